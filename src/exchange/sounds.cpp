// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/sounds.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "base/child.h"
#include "base/files.h"

namespace betwixt {
namespace {

constexpr double longest = 4 * 3600;             // seconds
constexpr rlim_t most_memory = rlim_t{4} << 30;  // of the program's own
constexpr std::size_t samples_at_once = 1 << 15;
constexpr std::size_t most_words = 4096;  // of what it says

// What holds samples and speaks of no other files, as playlists do.
constexpr const char* kinds_of_files = "wav,w64,aiff,au,caf,flac,ogg,mp3,aac,mov,mp4,m4a,matroska,webm,avi,ac3,amr,wv";

Error no_sound(const std::string& path, std::string why) {
  if (why.find("matches no streams") != std::string::npos) why = "nothing is heard";
  while (!why.empty() && std::isspace(static_cast<unsigned char>(why.back()))) why.pop_back();
  why = why.substr(why.rfind('\n') + 1);
  for (std::size_t at; (at = why.find("file:" + path)) != std::string::npos;) why.replace(at, path.size() + 5, path);
  if (why.starts_with(path + ": ")) why.erase(0, path.size() + 2);
  return fail(ErrorCode::file,
              fmt::format("{} is broken or no sound: {}", path, why.empty() ? "nothing is heard" : why));
}

// The program, and our ends of its output and of its standard error.
class Decoder {
 public:
  Decoder() = default;
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
  ~Decoder() {
    if (pid_ > 0) ::kill(pid_, SIGKILL), wait_for_child(pid_);
    for (const int file : {out_, err_})
      if (file >= 0) ::close(file);
  }

  Status start(const std::string& path) {
    std::array<int, 2> out{-1, -1}, err{-1, -1};
    if (::pipe2(out.data(), O_CLOEXEC) != 0) return system_error(errno, "read", path);
    out_ = out[0];
    const OpenFile its_out(out[1]);
    if (::pipe2(err.data(), O_CLOEXEC) != 0) return system_error(errno, "read", path);
    err_ = err[0];
    const OpenFile its_err(err[1]);
    const std::vector<std::string> words{"ffmpeg",
                                         "-hide_banner",
                                         "-nostdin",
                                         "-loglevel",
                                         "error",
                                         "-protocol_whitelist",
                                         "file,pipe",
                                         "-format_whitelist",
                                         kinds_of_files,
                                         "-i",
                                         "file:" + path,
                                         "-map",
                                         "0:a:0",
                                         "-f",
                                         "f32le",
                                         "-ac",
                                         "2",
                                         "-ar",
                                         std::to_string(sound_rate),
                                         "pipe:1"};
    const int failed = start_child(pid_, words, {-1, its_out.fd(), its_err.fd()});
    if (failed == ENOENT)
      return fail(ErrorCode::machine, "sounds need the program ffmpeg, which is not installed",
                  "sudo apt-get install ffmpeg");
    if (failed != 0) return system_error(failed, "start ffmpeg for", path);
    const rlimit bound{most_memory, most_memory};
    ::prlimit(pid_, RLIMIT_AS, &bound, nullptr);
    return Nothing{};
  }

  // Some more of what it gives; 0: that was all.
  std::size_t read(std::span<char> into) {
    for (;;) {
      std::array<pollfd, 2> both{pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
      ::poll(both.data(), both.size(), -1);
      if (both[1].revents) listen();
      if (!both[0].revents) continue;
      const ssize_t n = ::read(out_, into.data(), into.size());
      if (n < 0 && errno == EINTR) continue;
      return n > 0 ? static_cast<std::size_t>(n) : 0;
    }
  }
  // How it ended: whether well.
  bool finish() {
    while (err_ >= 0) listen();
    const int status = wait_for_child(std::exchange(pid_, -1));
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  const std::string& said() const { return said_; }

 private:
  void listen() {
    std::array<char, 1024> words;
    const ssize_t n = ::read(err_, words.data(), words.size());
    if (n < 0 && errno == EINTR) return;
    if (n <= 0) {
      ::close(err_), err_ = -1;
    } else if (said_.size() < most_words) {
      said_.append(words.data(), static_cast<std::size_t>(n));
    }
  }

  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;
  std::string said_;
};

// What is heard every hundredth of a second, and where there is much more of it than just before. Loudness is felt in
// ratios, so that its logarithm counts; what is 60 dB below a full sine is no sound.
std::vector<double> find_onsets(const std::vector<double>& energy) {
  constexpr std::size_t hop = 10, before = 10, least_apart = 5;  // in milliseconds; the others in hops
  constexpr double floor = 1e-6, rise = 1.0;                     // of the logarithm: by a factor e of energy
  std::vector<double> level;
  for (std::size_t ms = 0; ms + hop < energy.size(); ms += hop)
    level.push_back(std::log(floor + 1000.0 / hop * (energy[ms + hop] - energy[ms])));
  std::vector<double> onsets;
  std::size_t last = 0;
  for (std::size_t i = 0; i < level.size(); ++i) {
    double most = std::log(floor);  // lately
    for (std::size_t k = i > before ? i - before : 0; k < i; ++k) most = std::max(most, level[k]);
    if (level[i] < most + rise || (!onsets.empty() && i < last + least_apart)) continue;
    last = i;
    // To the millisecond: where the steepest part of the rise begins.
    std::size_t at = i * hop;
    for (std::size_t ms = i * hop; ms < (i + 1) * hop; ++ms)
      if (energy[ms + 1] - energy[ms] > energy[at + 1] - energy[at]) at = ms;
    onsets.push_back(static_cast<double>(at) / 1000);
  }
  return onsets;
}

}  // namespace

Status decode_sound(const std::string& path, const Listener& hear) {
  if (auto there = open_whole(path); !there) return there.error();  // in our own words
  Decoder decoder;
  if (Status s = decoder.start(path); !s) return s;
  std::vector<float> samples(samples_at_once);
  const std::span<char> bytes(reinterpret_cast<char*>(samples.data()), samples.size() * sizeof(float));
  constexpr std::size_t pair = 2 * sizeof(float);
  std::size_t have = 0;
  while (const std::size_t n = decoder.read(bytes.subspan(have))) {
    have += n;
    const std::size_t whole = have / pair;
    if (!hear(std::span(samples).first(2 * whole))) return Nothing{};
    std::memmove(bytes.data(), bytes.data() + whole * pair, have - whole * pair);
    have -= whole * pair;
  }
  return decoder.finish() ? Status(Nothing{}) : Status(no_sound(path, decoder.said()));
}

Result<std::shared_ptr<const Sound>> read_sound(const std::string& path) {
  constexpr std::size_t a_millisecond = sound_rate / 1000;
  auto sound = std::make_shared<Sound>();
  std::size_t count = 0;
  double sum = 0;
  sound->energy.push_back(0);
  bool too_long = false;
  const Status decoded = decode_sound(path, [&](std::span<const float> stereo) {
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) {
      const double left = stereo[i], right = stereo[i + 1], square = (left * left + right * right) / 2;
      if (std::isfinite(square)) sum += square;
      if (++count % a_millisecond == 0) sound->energy.push_back(sum / sound_rate);
    }
    too_long = static_cast<double>(count) > longest * sound_rate;
    return !too_long;
  });
  if (!decoded) return decoded.error();
  if (too_long) return fail(ErrorCode::range, fmt::format("{} is longer than four hours", path));
  if (count == 0) return no_sound(path, "");
  if (count % a_millisecond != 0) sound->energy.push_back(sum / sound_rate);
  sound->path = path;
  sound->seconds = static_cast<double>(count) / sound_rate;
  sound->onsets = find_onsets(sound->energy);
  return std::shared_ptr<const Sound>(std::move(sound));
}

}  // namespace betwixt

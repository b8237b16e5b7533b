// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/sounds.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "base/child.h"
#include "base/files.h"
#include "exchange/parser_process.h"
#include "exchange/sound_meter.h"

namespace betwixt {
namespace {

constexpr std::uint64_t most_memory = std::uint64_t{4} << 30;  // of ffmpeg itself
constexpr std::size_t samples_at_once = 1 << 15;
constexpr std::size_t most_words = 4096;  // of its messages

// Formats that contain samples and, unlike playlists, do not refer to other files.
constexpr const char* kinds_of_files = "wav,w64,aiff,au,caf,flac,ogg,mp3,aac,mov,mp4,m4a,matroska,webm,avi,ac3,amr,wv";

Error no_sound(const std::string& path, std::string why) {
  if (why.find("matches no streams") != std::string::npos) why = "it has no sound";
  while (!why.empty() && std::isspace(static_cast<unsigned char>(why.back()))) why.pop_back();
  why = why.substr(why.rfind('\n') + 1);
  for (std::size_t at; (at = why.find("file:" + path)) != std::string::npos;) why.replace(at, path.size() + 5, path);
  if (why.starts_with(path + ": ")) why.erase(0, path.size() + 2);
  return fail(ErrorCode::file,
              fmt::format("{} is broken or not a sound: {}", path, why.empty() ? "it has no sound" : why));
}

std::vector<std::string> ffmpeg_call(const std::string& program, const std::string& path) {
  return {program,
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
}

// Five minutes, and a second for every 100 bytes: the best compressed speech takes 700 bytes a second.
double longest_of(std::uint64_t size, bool any_size) {
  return any_size ? longest_sound : std::min(longest_sound, 300 + static_cast<double>(size) / 100);
}
// Ten times the needs of a slow machine.
ParserCeilings ceilings_of(std::uint64_t size, double longest) {
  const auto seconds = 5 + size / (std::uint64_t{1} << 20) + static_cast<std::uint64_t>(longest / 100);
  return {most_memory, seconds, 3 * seconds};
}

// The ffmpeg process, and our ends of its output and of its standard error.
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

  Status start(const std::string& path, const ParserCeilings& most) {
    most_ = most;
    const std::string ffmpeg = find_program("ffmpeg");
    if (ffmpeg.empty())
      return fail(ErrorCode::machine, "sounds need the program ffmpeg, which is not installed",
                  "sudo apt-get install ffmpeg");
    std::array<int, 2> out{-1, -1}, err{-1, -1};
    if (::pipe2(out.data(), O_CLOEXEC) != 0) return system_error(errno, "read", path);
    out_ = out[0];
    const OpenFile its_out(out[1]);
    if (::pipe2(err.data(), O_CLOEXEC) != 0) return system_error(errno, "read", path);
    err_ = err[0];
    const OpenFile its_err(err[1]);
    const std::string jail = find_parser();
    std::vector<std::string> words;
    if (!jail.empty())
      words = {jail, parser_version, parser_runs, std::to_string(most.memory), std::to_string(most.seconds), path};
    for (const std::string& word : ffmpeg_call(ffmpeg, path)) words.push_back(word);
    if (const int failed = start_child(pid_, words, {-1, its_out.fd(), its_err.fd()}))
      return system_error(failed, "start ffmpeg for", path);
    if (jail.empty()) limit();
    return Nothing{};
  }

  // Reads more of its output. Returns 0 at the end, or if it took too long. Counts only the time spent waiting for it.
  std::size_t read(std::span<char> into) {
    for (;;) {
      std::array<pollfd, 2> both{pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
      const auto begun = Clock::now();
      const auto left = std::chrono::seconds(most_.wall) - waited_;
      const int ready = ::poll(both.data(), both.size(), static_cast<int>(to_ms(left)));
      waited_ += Clock::now() - begun;
      if (ready == 0) return ::kill(pid_, SIGKILL), 0;
      if (both[1].revents) listen();
      if (!both[0].revents) continue;
      const ssize_t n = ::read(out_, into.data(), into.size());
      if (n < 0 && errno == EINTR) continue;
      return n > 0 ? static_cast<std::size_t>(n) : 0;
    }
  }
  Status finish(const std::string& path) {
    while (err_ >= 0) listen();
    const int status = wait_for_child(std::exchange(pid_, -1));
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
      return fail(ErrorCode::file, fmt::format("reading {} takes more than {} s", path, most_.seconds));
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 1;
    if (code == parser_of_another_version)
      return fail(ErrorCode::machine, "the program betwixt-parser has another version than this program");
    if (code == parser_started_nothing) return fail(ErrorCode::machine, said_.substr(0, said_.find('\n')));
    return code == 0 ? Status(Nothing{}) : Status(no_sound(path, said_));
  }

 private:
  using Clock = std::chrono::steady_clock;

  static std::int64_t to_ms(Clock::duration d) {
    return std::max<std::int64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(d).count(), 1);
  }
  // Sets the limits that work without betwixt-parser.
  void limit() const {
    const rlimit memory{most_.memory, most_.memory}, work{most_.seconds, most_.seconds};
    ::prlimit(pid_, RLIMIT_AS, &memory, nullptr);
    ::prlimit(pid_, RLIMIT_CPU, &work, nullptr);
  }
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

  ParserCeilings most_;
  Clock::duration waited_{};
  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;
  std::string said_;
};

// Returns an error in our own words if the file cannot be read.
Result<std::uint64_t> size_of(const std::string& path) {
  const auto there = open_whole(path);
  if (!there) return there.error();
  struct stat about {};
  if (::fstat(there->fd(), &about) != 0) return system_error(errno, "read", path);
  return static_cast<std::uint64_t>(about.st_size);
}

}  // namespace

Status decode_sound(const std::string& path, const Listener& hear, double longest) {
  const auto size = size_of(path);
  if (!size) return size.error();
  Decoder decoder;
  if (Status s = decoder.start(path, ceilings_of(*size, longest)); !s) return s;
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
  return decoder.finish(path);
}

Result<std::shared_ptr<const Sound>> read_sound(const std::string& path, bool any_size) {
  const auto size = size_of(path);
  if (!size) return size.error();
  const double longest = longest_of(*size, any_size);
  SoundMeter meter;
  bool too_long = false;
  const Status decoded = decode_sound(
      path,
      [&](std::span<const float> stereo) {
        meter.hear(stereo);
        too_long = meter.seconds() > longest;
        return !too_long;
      },
      longest);
  if (!decoded) return decoded.error();
  if (too_long && longest < longest_sound)
    return fail(ErrorCode::range,
                fmt::format("{} is longer than {:.0f} s, the limit for a file of {} bytes", path, longest, *size),
                Hint(Permission::read_anywhere, "to read files of any size: --read-anywhere"));
  if (too_long) return fail(ErrorCode::range, fmt::format("{} is longer than four hours", path));
  if (meter.seconds() == 0) return no_sound(path, "");
  return std::make_shared<const Sound>(meter.sound(path));
}

}  // namespace betwixt

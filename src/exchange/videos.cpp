// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A picture of a video is decoded from a place that depends on the picture alone, so that it is the same in any order.
// These places begin runs. A run ends where the next one begins; its pictures are decoded one after the other, as far
// as they are asked for.
#include "exchange/videos.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <list>
#include <mutex>
#include <optional>
#include <tuple>

#include "base/files.h"
#include "exchange/jailed_reader.h"
#include "exchange/kept_frames.h"
#include "exchange/video_index.h"

namespace betwixt {
namespace {

constexpr std::uint64_t most_memory = std::uint64_t{4} << 30;  // of ffmpeg itself
constexpr std::size_t most_kept = std::size_t{256} << 20;      // bytes of decoded pictures
constexpr std::size_t most_decoders = 8;                       // that wait for the next request
constexpr std::size_t shortest_run = 48;                       // pictures

// What identifies the content of a file without reading it.
using FileStamp = std::tuple<std::uint64_t, std::int64_t, std::int64_t, std::uint64_t>;
FileStamp stamp_of(const std::string& path) {
  struct stat s {};
  if (::stat(path.c_str(), &s) != 0) return {};
  return {static_cast<std::uint64_t>(s.st_size), s.st_mtim.tv_sec, s.st_mtim.tv_nsec, s.st_ino};
}

std::string seconds_of(std::int64_t steps, const VideoIndex& index) {
  // Rounded up, so that a picture at this very time is not after it.
  const long double exact = static_cast<long double>(steps) * static_cast<long double>(index.clock_num) /
                            static_cast<long double>(index.clock_den);
  return fmt::format("{:.6f}", static_cast<double>(exact) + 5e-7);
}

// Returns the arguments of ffmpeg that decode from a picture on; it begins there or earlier. Without one, from the
// beginning. The result is the same on all processors: one thread, and conversions that are exact to the bit.
std::vector<std::string> decoder_call(const std::string& path, const VideoIndex& index,
                                      std::optional<std::int64_t> from) {
  std::vector<std::string> words{"-hide_banner", "-nostdin", "-loglevel", "quiet", "-threads", "1", "-copyts"};
  if (from) words.insert(words.end(), {"-noaccurate_seek", "-seek_timestamp", "1", "-ss", seconds_of(*from, index)});
  if (!index.decoder.empty()) words.insert(words.end(), {"-c:v", index.decoder});
  words.insert(words.end(), {"-flags:v", "bitexact", "-idct", "simple"});
  for (std::string& word : arguments_for_reading(path)) words.push_back(std::move(word));
  std::string filter = fmt::format("scale={}:{}:flags=bilinear+bitexact+accurate_rnd+full_chroma_int:out_range=pc",
                                   index.width, index.height);
  // As players do: large pictures have the colours of HDTV.
  if (index.vague_colors && std::max(index.width, index.height) >= 1280) filter += ":in_color_matrix=bt709";
  words.insert(words.end(), {"-map", "0:V:0", "-fps_mode", "passthrough", "-enc_time_base", "-1", "-filter_threads",
                             "1", "-vf", filter + ",format=rgba", "-c:v", "rawvideo", "-f", "tee",
                             "[f=rawvideo:flush_packets=1]pipe:1|[f=framecrc:flush_packets=1]pipe:2"});
  return words;
}

// One process that decodes a run. Its standard output has the pictures, and its standard error a line for each, with
// its time.
class RunDecoder {
 public:
  struct Decoded {
    std::int64_t time = 0;
    std::shared_ptr<const Picture> picture;
  };

  Status start(const std::string& path, const VideoIndex& index, std::optional<std::int64_t> from, std::size_t count) {
    width_ = index.width, height_ = index.height;
    const double pixels = static_cast<double>(width_) * height_;
    const auto seconds = static_cast<std::uint64_t>(20 + static_cast<double>(count) * (0.05 + pixels / 4e6));
    program_.keep_of_said(std::size_t{4} << 20);
    return program_.start("ffmpeg", decoder_call(path, index, from), path, {most_memory, seconds, 3 * seconds},
                          "videos");
  }
  // Returns nullopt at the end.
  std::optional<Decoded> next() {
    auto picture = std::make_shared<Picture>();
    picture->width = width_, picture->height = height_;
    picture->rgba.resize(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    const std::span<char> bytes(reinterpret_cast<char*>(picture->rgba.data()), picture->rgba.size());
    for (std::size_t have = 0; have < bytes.size();) {
      const std::size_t n = program_.read(bytes.subspan(have));
      if (n == 0) return std::nullopt;
      have += n;
    }
    const auto time = next_time();
    if (!time) return std::nullopt;
    return Decoded{*time, std::move(picture)};
  }

 private:
  // "0,       1024,       1024,      512,   230400, 0x1585fca3": the stream, when it is decoded and shown, …
  std::optional<std::int64_t> next_time() {
    for (;;) {
      const std::size_t end = program_.said().find('\n');
      if (end == std::string::npos) {
        if (!program_.listen()) return std::nullopt;
        continue;
      }
      const std::string line = program_.said().substr(0, end);
      program_.said().erase(0, end + 1);
      if (!line.starts_with("0,")) continue;
      std::size_t at = line.find(',', 2);
      at = at == line.npos ? at : line.find_first_not_of(' ', at + 1);
      std::int64_t time = 0;
      if (at != line.npos && std::from_chars(&line[at], line.data() + line.size(), time).ec == std::errc()) return time;
    }
  }

  JailedReader program_;
  int width_ = 0, height_ = 0;
};

class FileVideo final : public Video {
 public:
  FileVideo(std::string path, VideoIndex index, FileStamp stamp)
      : path_(std::move(path)), index_(std::move(index)), stamp_(stamp) {
    width = index_.width, height = index_.height, aspect = index_.aspect;
    VideoTimes times = times_of(index_);
    begins = std::move(times.begins), end = times.end, slack = times.slack;
    runs_.push_back(0);
    for (const std::size_t key : index_.keys)
      if (key >= runs_.back() + shortest_run) runs_.push_back(key);
  }
  ~FileVideo() override {
    const std::lock_guard lock(decoding());
    stop();
    kept().forget(this);
  }
  FileVideo(const FileVideo&) = delete;
  FileVideo& operator=(const FileVideo&) = delete;

  Result<std::shared_ptr<const Picture>> picture(std::size_t number) const override {
    const std::lock_guard lock(decoding());
    number = std::min(number, begins.size() - 1);
    if (auto known = kept().find(this, number)) return known;
    return decode(number);
  }
  // Whether its first picture can be decoded.
  Status starts() const {
    const std::lock_guard lock(decoding());
    if (const auto first = decode(0); !first) return first.error();
    if (!short_) return Nothing{};
    return fail(ErrorCode::file, fmt::format("{} is broken or not a video: ffmpeg cannot decode its pictures", path_));
  }

 private:
  // One at a time decodes in this process; ffmpeg itself works ahead a little.
  static std::mutex& decoding() {
    static std::mutex& one = *new std::mutex;
    return one;
  }
  static KeptFrames& kept() {
    static KeptFrames& all = *new KeptFrames(most_kept);
    return all;
  }
  // Those that have a decoder, the latest first.
  static std::list<const FileVideo*>& active() {
    static auto& all = *new std::list<const FileVideo*>;
    return all;
  }

  std::size_t run_of(std::size_t number) const {
    return static_cast<std::size_t>(std::upper_bound(runs_.begin(), runs_.end(), number) - runs_.begin()) - 1;
  }
  std::size_t end_of(std::size_t run) const { return run + 1 < runs_.size() ? runs_[run + 1] : begins.size(); }

  void stop() const {
    decoder_.reset();
    active().remove(this);
  }
  // Begins a run; from the beginning of the file if its own beginning cannot be found.
  Status begin(std::size_t run, bool whole) const {
    stop();
    if (stamp_of(path_) != stamp_)
      return fail(ErrorCode::file, fmt::format("{} has changed, or is gone, since it was loaded", path_));
    run_ = run, next_ = runs_[run], last_ = nullptr, from_start_ = whole || run == 0;
    decoder_ = std::make_unique<RunDecoder>();
    const auto from = from_start_ ? std::nullopt : std::optional(index_.times[runs_[run]]);
    const std::size_t count = end_of(run) - (from ? runs_[run] : 0);
    if (Status s = decoder_->start(path_, index_, from, 2 * count); !s) return stop(), s;
    active().push_front(this);
    if (active().size() > most_decoders) active().back()->stop();
    return Nothing{};
  }

  Result<std::shared_ptr<const Picture>> decode(std::size_t number) const {
    const std::size_t run = run_of(number);
    if (short_ && short_->run == run && number >= short_->from) return short_->picture;
    if (!decoder_ || run_ != run || next_ > number)
      if (Status s = begin(run, false); !s) return s.error();
    std::shared_ptr<const Picture> wanted;
    while (!wanted) {
      auto decoded = decoder_->next();
      if (!decoded) return end_early();
      const bool late = last_ == nullptr && decoded->time > index_.times[next_];
      if (late && !from_start_) {
        if (Status s = begin(run, true); !s) return s.error();
        continue;
      }
      wanted = take(*decoded, end_of(run), number);
    }
    if (next_ == end_of(run)) stop();
    return wanted;
  }
  // Keeps what was decoded, also in place of what the decoder has left out. Returns the wanted one, or null.
  std::shared_ptr<const Picture> take(const RunDecoder::Decoded& decoded, std::size_t end, std::size_t number) const {
    std::shared_ptr<const Picture> wanted;
    const auto keep = [&](const std::shared_ptr<const Picture>& picture) {
      kept().add(this, next_, picture);
      if (next_++ == number) wanted = picture;
    };
    while (next_ < end && index_.times[next_] < decoded.time) keep(last_ ? last_ : decoded.picture);
    if (next_ < end && index_.times[next_] == decoded.time) keep(decoded.picture);
    last_ = decoded.picture;
    return wanted;
  }
  // Nothing more can be decoded in this run: the last picture stays, or it is black.
  std::shared_ptr<const Picture> end_early() const {
    if (!last_) {
      auto black = std::make_shared<Picture>();
      black->width = width, black->height = height;
      black->rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
      for (std::size_t i = 3; i < black->rgba.size(); i += 4) black->rgba[i] = 255;
      last_ = std::move(black);
    }
    short_ = {run_, next_, last_};
    stop();
    return last_;
  }

  const std::string path_;
  const VideoIndex index_;
  const FileStamp stamp_;
  std::vector<std::size_t> runs_;  // their first pictures
  // The run that is being decoded.
  mutable std::unique_ptr<RunDecoder> decoder_;
  mutable std::size_t run_ = 0, next_ = 0;
  mutable bool from_start_ = false;
  mutable std::shared_ptr<const Picture> last_;  // that was decoded
  // The last run that could not be decoded to its end.
  struct Short {
    std::size_t run = 0, from = 0;
    std::shared_ptr<const Picture> picture;
  };
  mutable std::optional<Short> short_;
};

}  // namespace

Result<ReadVideo> read_video(const std::string& path) {
  const auto size = size_of_file(path);
  if (!size) return size.error();
  const auto seconds = 20 + *size / (std::uint64_t{1} << 20);
  const FileStamp stamp = stamp_of(path);
  auto index = index_video(path, {most_memory, seconds, 3 * seconds});
  if (!index) return index.error();
  std::string complaint = index->complaint;
  const auto video = std::make_shared<FileVideo>(path, *std::move(index), stamp);
  if (const Status s = video->starts(); !s) return s.error();
  while (!complaint.empty() && complaint.back() == '\n') complaint.pop_back();
  if (!complaint.empty())
    complaint =
        fmt::format("{} is damaged, so not all of it is shown: {}", path, complaint.substr(complaint.rfind('\n') + 1));
  return ReadVideo{video, complaint};
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Videos of films in pages: the pictures that `betwixt web` has put beside their files (exchange/video_strip.h).
#include "exchange/videos.h"

#include <fmt/format.h>

#include "base/files.h"
#include "exchange/kept_frames.h"
#include "exchange/pictures.h"
#include "exchange/video_strip.h"

namespace betwixt {
namespace {

constexpr std::size_t most_kept = std::size_t{64} << 20;

class StripVideo final : public Video {
 public:
  explicit StripVideo(VideoStrip strip) : pictures_(std::move(strip.pictures)) {
    width = strip.width, height = strip.height, aspect = strip.aspect;
    begins = std::move(strip.begins), end = strip.end, slack = strip.slack;
  }
  Result<std::shared_ptr<const Picture>> picture(std::size_t number) const override {
    number = std::min(number, pictures_.size() - 1);
    if (auto known = kept_.find(this, number)) return known;
    const std::string file = "/tmp/video-picture.jpg";
    if (Status s = write_whole(file, pictures_[number], true); !s) return s.error();
    auto read = load_picture(file, true);
    if (read) kept_.add(this, number, *read);
    return read;
  }

 private:
  const std::vector<std::string> pictures_;
  mutable KeptFrames kept_{most_kept};
};

// Is shown in place of a video whose pictures the page lacks.
class GreyVideo final : public Video {
 public:
  GreyVideo() { width = 16, height = 9, aspect = 16.0 / 9, begins = {0}, end = 1; }
  Result<std::shared_ptr<const Picture>> picture(std::size_t) const override {
    return std::make_shared<const Picture>(Picture{1, 1, {128, 128, 128, 255}});
  }
};

}  // namespace

Result<ReadVideo> read_video(const std::string& path) {
  const std::string beside = path + std::string(strip_ending);
  if (read_contents(beside).problem != ReadProblem::none)
    return ReadVideo{std::make_shared<const GreyVideo>(),
                     "pages show the pictures of a video only if betwixt web has made the page"};
  const auto bytes = read_whole(beside);
  if (!bytes) return bytes.error();
  auto strip = read_strip(*bytes, beside);
  if (!strip) return strip.error();
  return ReadVideo{std::make_shared<const StripVideo>(*std::move(strip)), {}};
}

}  // namespace betwixt

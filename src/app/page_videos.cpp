// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/page_videos.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "betwixt/evaluation.h"
#include "betwixt/film.h"
#include "exchange/video_strip.h"
#include "program/compiled.h"
#include "scene/document.h"

namespace betwixt {
namespace {

constexpr int longest_side = 640, quality = 75;
constexpr std::size_t most_bytes = std::size_t{24} << 20;  // of one video
constexpr double most_frames = 20'000;                     // of the film that are looked at

// Each pixel is the mean of those that it covers.
Picture smaller(const Picture& from) {
  const double scale = static_cast<double>(longest_side) / std::max(from.width, from.height);
  if (scale >= 1) return from;
  Picture to{std::max(1, static_cast<int>(std::lround(scale * from.width))),
             std::max(1, static_cast<int>(std::lround(scale * from.height))),
             {}};
  to.rgba.resize(4 * static_cast<std::size_t>(to.width) * static_cast<std::size_t>(to.height));
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x) {
      const int x0 = x * from.width / to.width, x1 = std::max(x0 + 1, (x + 1) * from.width / to.width);
      const int y0 = y * from.height / to.height, y1 = std::max(y0 + 1, (y + 1) * from.height / to.height);
      for (int c = 0; c < 4; ++c) {
        int sum = 0;
        for (int v = y0; v < y1; ++v)
          for (int u = x0; u < x1; ++u)
            sum += from.rgba[4 * static_cast<std::size_t>(v * from.width + u) + static_cast<std::size_t>(c)];
        const int count = (x1 - x0) * (y1 - y0);
        to.rgba[4 * static_cast<std::size_t>(y * to.width + x) + static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>((sum + count / 2) / count);
      }
    }
  return to;
}

// The numbers of the pictures that the film shows, by video.
std::map<const void*, std::set<std::uint32_t>> shown_pictures(const Document& document) {
  std::map<const void*, std::set<std::uint32_t>> shown;
  const Program program = Program::compile(document);
  Evaluation evaluation(program);
  const auto [first, last] = document.range();
  const double count =
      std::min(std::floor(document.rate().frame_number(last) - document.rate().frame_number(first)) + 1, most_frames);
  for (double k = 0; k < count; ++k) {
    evaluation.to(first + document.rate().span(k));
    for (const std::uint32_t i : evaluation.changed())
      if (const Evaluation::Look& look = evaluation.looks()[i]; look.visible) {
        const auto [of, number] = program.compiled().picture_key(look.texture);
        if (of) shown[of].insert(number);
      }
  }
  return shown;
}

Status add_video(PageFilm& film, const std::string& name, const Video& video, const std::set<std::uint32_t>& numbers) {
  VideoStrip strip{0, 0, video.aspect, video.end, video.slack, {}, {}};
  std::size_t bytes = 0, step = 1;
  std::size_t place = 0;
  for (const std::uint32_t number : numbers) {
    if (place++ % step != 0) continue;
    const auto picture = video.picture(number);
    if (!picture) return picture.error();
    const Picture small = smaller(**picture);
    strip.width = small.width, strip.height = small.height;
    auto jpeg = jpeg_of(small, quality);
    if (!jpeg) return jpeg.error();
    bytes += jpeg->size();
    strip.begins.push_back(video.begins[number]), strip.pictures.push_back(*std::move(jpeg));
    if (bytes <= most_bytes) continue;
    // Every other one of those so far goes, and from now on twice as many are left out.
    step *= 2, bytes = 0;
    for (std::size_t k = 0; 2 * k < strip.begins.size(); ++k) {
      strip.begins[k] = strip.begins[2 * k], strip.pictures[k] = strip.pictures[2 * k];
      bytes += strip.pictures[k].size();
    }
    const std::size_t left = (strip.begins.size() + 1) / 2;
    strip.begins.resize(left), strip.pictures.resize(left);
  }
  if (step > 1)
    film.lost.push_back(fmt::format("the page shows one of {} pictures of {}, because more are too large", step, name));
  film.files[name + std::string(strip_ending)] = write_strip(strip);
  return Nothing{};
}

}  // namespace

Status add_videos(PageFilm& film, const Document& document) {
  const Scene& scene = document.scene();
  if (scene.videos->empty()) return Nothing{};
  const auto shown = shown_pictures(document);
  for (const auto& [name, video] : *scene.videos) {
    const auto numbers = shown.find(video.get());
    const std::set<std::uint32_t> first{0};
    if (Status s = add_video(film, name, *video, numbers == shown.end() ? first : numbers->second); !s) return s;
    if (std::max(video->width, video->height) > longest_side)
      film.lost.push_back(fmt::format("the page shows {} with {} pixels a side", name, longest_side));
  }
  return Nothing{};
}

}  // namespace betwixt

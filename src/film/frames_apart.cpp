// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/frames_apart.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "base/in_parallel.h"

namespace betwixt {
namespace {

// Draws the frames of a film one after the other.
class FilmDrawer {
 public:
  static Result<FilmDrawer> make(const Program& program, const RenderOptions& options) {
    auto renderer = make_renderer(options);
    if (!renderer) return renderer.error();
    return FilmDrawer(program, options.linear, *std::move(renderer));
  }
  Status draw(Time t, Picture& out) {
    evaluation_.to(t);
    if (!linear_) return renderer_->render(evaluation_, out);
    const Status drawn = renderer_->render(evaluation_, light_);
    if (drawn) to_shown(light_, out);
    return drawn;
  }

 private:
  FilmDrawer(const Program& program, bool linear, std::unique_ptr<Renderer> renderer)
      : evaluation_(program), linear_(linear), renderer_(std::move(renderer)) {}
  Evaluation evaluation_;
  bool linear_;
  std::unique_ptr<Renderer> renderer_;
  LinearPicture light_;
};

}  // namespace

PictureDifference difference(const Picture& a, const Picture& b) {
  PictureDifference d;
  if (a.width != b.width || a.height != b.height) return {255, std::max(a.rgba.size(), b.rgba.size()) / 4};
  for (std::size_t i = 0; i + 3 < a.rgba.size(); i += 4) {
    int most = 0;
    for (std::size_t k = i; k < i + 4; ++k) most = std::max(most, std::abs(a.rgba[k] - b.rgba[k]));
    d.most = std::max(d.most, most);
    d.pixels += most > 0;
  }
  return d;
}

Picture picture_of_difference(const Picture& a, const Picture& b) {
  Picture out{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size(), 255)};
  if (a.rgba.size() != b.rgba.size()) return out;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const int d = std::max(std::abs(a.rgba[i] - b.rgba[i]), std::abs(a.rgba[i | 3] - b.rgba[i | 3]));
    // The smallest difference can be seen too.
    out.rgba[i] = static_cast<std::uint8_t>(d == 0 ? 0 : std::min(255, 48 + 2 * d));
  }
  return out;
}

Result<Picture> picture_at(const Program& program, Time t, const RenderOptions& options) {
  auto drawer = FilmDrawer::make(program, options);
  if (!drawer) return drawer.error();
  Picture out;
  if (const Status drawn = drawer->draw(t, out); !drawn) return drawn.error();
  return out;
}

Result<std::vector<FrameApart>> frames_apart(const Program& old, const Program& now, const FrameList& frames,
                                             const RenderOptions& options, const std::function<bool()>& done) {
  std::vector<FrameApart> apart;
  std::optional<Error> failed;
  std::mutex mutex;
  std::atomic<int> next = 0;
  std::atomic<bool> stopped = false;
  const auto fails = [&](const Error& e) {
    const std::lock_guard lock(mutex);
    if (!failed) failed = e;
    stopped = true;
  };
  const std::size_t threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 16);
  in_parallel(std::min(threads, static_cast<std::size_t>(frames.count)), [&](std::size_t) {
    auto first = FilmDrawer::make(old, options), second = FilmDrawer::make(now, options);
    if (!first) return fails(first.error());
    if (!second) return fails(second.error());
    Picture a, b;
    for (int k = next++; k < frames.count && !stopped; k = next++) {
      if (const Status drawn = first->draw(frames.time(k), a); !drawn) return fails(drawn.error());
      if (const Status drawn = second->draw(frames.time(k), b); !drawn) return fails(drawn.error());
      if (const PictureDifference d = difference(a, b); d.pixels > 0) {
        const std::lock_guard lock(mutex);
        apart.push_back({k, d});
      }
      if (done && !done()) return fails(fail(ErrorCode::machine, "stopped"));
    }
  });
  if (failed) return *failed;
  std::ranges::sort(apart, {}, &FrameApart::index);
  return apart;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/traced.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include <atomic>
#include <limits>
#include <new>
#include <system_error>
#include <thread>

#include "base/cancellation.h"
#include "base/stages.h"
#include "render/blur.h"
#include "render/filter_sampler.h"
#include "render/path_tracer.h"

namespace betwixt {
namespace {

using traced::CameraSample;
using traced::FilterSampler;
using traced::PathTracer;
using traced::PixelSampler;
using traced::World;

// Flushes denormal numbers to 0 while rays are traced, since Embree is fast that way, and restores the mode.
class FlushDenormals {
 public:
#ifdef __SSE__
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
  ~FlushDenormals() { _mm_setcsr(before_); }
#else
  FlushDenormals() = default;
  ~FlushDenormals() {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  [[maybe_unused]] unsigned before_ = 0;
};

// The last picture.
class PreviousPicture {
 public:
  // Returns whether anything differs from it, and takes over the new state.
  bool differs(const Columns& c) {
    std::vector<Content> now(c.looks.size());
    for (std::uint32_t i = 0; i < now.size(); ++i)
      if (c.looks[i].visible) now[i] = content_of(c, i);
    const bool scenery = scenery_.take(c), things = now != things_;
    const bool camera = !camera_ || !(*camera_ == c.camera) || part_ != std::pair(c.part, c.parts);
    things_ = std::move(now), camera_ = c.camera, part_ = {c.part, c.parts};
    return scenery || camera || things;
  }
  const Scenery& scenery() const { return scenery_; }

 private:
  std::vector<Content> things_;
  std::optional<Camera> camera_;
  std::pair<int, int> part_;
  Scenery scenery_;
};

// A pool of threads that take the next work item. It ends with its work, which it aborts if the work was cancelled.
class ThreadPool {
 public:
  ~ThreadPool() {
    next = std::numeric_limits<std::size_t>::max() / 2;
    for (std::thread& t : threads_) t.join();
  }
  template <class Work>
  void add(const Work& work) {
    try {
      threads_.emplace_back(work);
    } catch (const std::system_error&) {  // continue with fewer
    }
  }
  std::atomic<std::size_t> next = 0;

 private:
  std::vector<std::thread> threads_;
};

class Traced final : public Renderer {
 public:
  Traced(const RenderOptions& options, World world, unsigned threads)
      : width_(options.width),
        height_(options.height),
        samples_(static_cast<std::uint32_t>(options.samples)),
        filter_(*find_pixel_filter(options.pixel_filter)),
        linear_(options.linear),
        unclamped_(options.unclamped),
        threads_(threads),
        world_(std::move(world)) {}

  Status render(const Frame& frame, Picture& out) override { return show(frame, out); }
  Status render(const Evaluation& evaluation, Picture& out) override { return show(evaluation, out); }
  Status render(const Frame& frame, LinearPicture& out) override { return give(frame, out); }
  Status render(const Evaluation& evaluation, LinearPicture& out) override { return give(evaluation, out); }
  Status render_blurred(Evaluation& evaluation, Time t, const Blur& how, LinearPicture& out) override {
    const auto draw_part = [&](const Columns& columns, LinearPicture& one) { return give(columns, one); };
    return betwixt::render_blurred(evaluation, t, how, width_, height_, draw_part, out);
  }

 private:
  Status draw(const Frame& frame) {
    const FrameColumns laid_out(frame);
    return draw(laid_out.columns());
  }
  Status draw(const Evaluation& evaluation) { return draw(columns_of(evaluation)); }
  template <class Source>
  Status show(const Source& source, Picture& out) {
    Status drawn = draw(source);
    if (drawn) to_shown(light_, out);
    return drawn;
  }
  template <class Source>
  Status give(const Source& source, LinearPicture& out) {
    if (!linear_) return fail(ErrorCode::range, "pictures of linear light need a renderer with that option");
    Status drawn = draw(source);
    if (drawn) out = light_;
    return drawn;
  }

  Status draw(const Columns& columns) {
    const InStage draw(Stage::draw);
    try {
      if (!previous_.differs(columns) && whole_) return Nothing{};
      whole_ = false;
      Status made = draw_anew(columns);
      whole_ = static_cast<bool>(made);
      return made;
    } catch (const std::bad_alloc&) {
      return fail(ErrorCode::machine, "there is not enough memory for this picture");
    }
  }

  Status draw_anew(const Columns& columns) {
    bool good = false, always = true;
    View view = make_view(columns.camera, width_, height_, good);
    if (!good) view = make_view({}, width_, height_, always);  // a view of nothing
    {
      const InStage gather(Stage::gather);
      const FlushDenormals now;
      if (Status s = world_.set(columns, good ? columns.looks.size() : 0, view); !s) return s;
    }
    const PathTracer path_tracer(world_, view, previous_.scenery());
    light_.width = width_, light_.height = height_;
    light_.rgba.resize(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    const std::size_t pixels = light_.rgba.size() / 4;
    constexpr std::size_t run = 64;
    ThreadPool pool;
    const auto work = [&] {
      const FlushDenormals now;
      for (std::size_t first; (first = pool.next.fetch_add(run)) < pixels;) {
        Cancellation::check();
        for (std::size_t k = first; k < std::min(first + run, pixels); ++k) draw_pixel(path_tracer, k, columns);
      }
    };
    for (unsigned k = 1; k < threads_; ++k) pool.add(work);
    work();
    return Nothing{};
  }

  // The highlights of each cell of a pixel roll off separately, so bright edges are smooth and the noise of single
  // samples has little effect.
  void draw_pixel(const PathTracer& path_tracer, std::size_t k, const Columns& columns) {
    // Pictures that are averaged share the samples of one; with fewer than these, highlights would roll off too soon.
    constexpr std::uint32_t fewest = 4;
    const auto parts = static_cast<std::uint32_t>(columns.parts), part = static_cast<std::uint32_t>(columns.part);
    const std::uint32_t samples = std::max(samples_ / parts, std::min(samples_, fewest));
    const double x = static_cast<double>(k % static_cast<std::size_t>(width_));
    const double y = static_cast<double>(k / static_cast<std::size_t>(width_));
    const int side = samples >= 64 ? 4 : samples >= 4 ? 2 : 1;
    std::array<CameraSample, 16> cells;
    std::array<double, 16> signs{};  // of a cell's samples: the sum of the signs of their weights, and their number
    std::array<double, 16> counts{};
    double clear = 0, weight = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
      PixelSampler sampler(static_cast<std::uint32_t>(k), part * samples + s, parts * samples);
      const auto [right, down] = sampler.next_2d();
      const auto cell = static_cast<std::size_t>(static_cast<int>(side * down) * side + static_cast<int>(side * right));
      const auto [in_x, sign_x] = filter_.at(right);
      const auto [in_y, sign_y] = filter_.at(down);
      const double sign = sign_x * sign_y;
      const CameraSample seen = path_tracer.sample((x + in_x) / width_, (y + in_y) / height_, sampler);
      cells[cell].lit = cells[cell].lit + seen.lit, cells[cell].plain = cells[cell].plain + sign * seen.plain;
      cells[cell].share += seen.share, clear += sign * seen.clear;
      signs[cell] += sign, counts[cell] += 1, weight += sign;
    }
    Vec3 sum;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const CameraSample& c = cells[i];
      sum = sum + c.plain;
      if (c.share > 0)
        sum = sum + signs[i] / counts[i] * (unclamped_ ? c.lit : c.share * traced::tone_mapped(1 / c.share * c.lit));
    }
    if (weight == 0) weight = 1;  // a few samples whose signs cancel
    float* const out = &light_.rgba[4 * k];
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(std::max(sum[i] / weight, 0.0));
    out[3] = linear_ ? static_cast<float>(std::clamp(1 - clear / weight, 0.0, 1.0)) : 1;
  }

  const int width_, height_;
  const std::uint32_t samples_;
  const FilterSampler filter_;
  const bool linear_, unclamped_;
  const unsigned threads_;
  World world_;
  PreviousPicture previous_;
  LinearPicture light_;
  bool whole_ = false;  // the last picture is complete
};

}  // namespace

Result<std::unique_ptr<Renderer>> make_traced(const RenderOptions& options, unsigned threads) {
  auto world = World::create();
  if (!world) return world.error();
  const unsigned some = threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1U);
  return std::unique_ptr<Renderer>(std::make_unique<Traced>(options, *std::move(world), some));
}

}  // namespace betwixt

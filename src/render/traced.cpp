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
#include "render/path_tracer.h"

namespace betwixt {
namespace {

using traced::CameraSample;
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
    double clear = 0;
    for (std::uint32_t s = 0; s < samples; ++s) {
      PixelSampler sampler(static_cast<std::uint32_t>(k), part * samples + s, parts * samples);
      const auto [right, down] = sampler.next_2d();
      const auto cell = static_cast<std::size_t>(static_cast<int>(side * down) * side + static_cast<int>(side * right));
      const CameraSample seen = path_tracer.sample((x + right) / width_, (y + down) / height_, sampler);
      cells[cell].lit = cells[cell].lit + seen.lit, cells[cell].plain = cells[cell].plain + seen.plain;
      cells[cell].share += seen.share, clear += seen.clear;
    }
    Vec3 sum;
    for (const CameraSample& c : cells) {
      sum = sum + c.plain;
      if (c.share > 0) sum = sum + (unclamped_ ? c.lit : c.share * traced::tone_mapped(1 / c.share * c.lit));
    }
    float* const out = &light_.rgba[4 * k];
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(sum[i] / samples);
    out[3] = linear_ ? static_cast<float>(1 - clear / samples) : 1;
  }

  const int width_, height_;
  const std::uint32_t samples_;
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

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/traced.h"

#ifdef __SSE__
#include <xmmintrin.h>
#endif

#include <new>
#include <numeric>
#include <thread>

#include "base/stages.h"
#include "base/work_progress.h"
#include "render/denoise.h"
#include "render/exposure.h"
#include "render/shared_work.h"
#include "render/traced_tile.h"

namespace betwixt {
namespace {

using traced::ExposedTracer;
using traced::FilterSampler;
using traced::NoisyPicture;
using traced::PixelSums;
using traced::SamplePlan;
using traced::TileOfPixels;
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

// The last picture of one moment.
class PreviousPicture {
 public:
  // Returns whether anything differs from it, and takes over the new state.
  bool differs(const Columns& c) {
    Exposure now = moment_of(c);
    const bool differs = !last_ || !same(now, *last_);
    last_ = std::move(now);
    return differs;
  }
  const Exposure& exposure() const { return *last_; }

 private:
  static bool same(const Exposure& a, const Exposure& b) {
    const auto things = [](const Course& x, const Course& y) { return x.states == y.states; };
    return a.cameras == b.cameras && a.background == b.background && a.surroundings == b.surroundings &&
           std::equal(a.lights[0].begin(), a.lights[0].end(), b.lights[0].begin(), b.lights[0].end(), same_light) &&
           std::equal(a.things.begin(), a.things.end(), b.things.begin(), b.things.end(), things);
  }
  std::optional<Exposure> last_;
};

// Returns a step that goes to all of `count` places before it comes back. Successive ones are far apart, so that the
// work done so far is like the work that is left.
std::size_t scattering_step(std::size_t count) {
  auto step = static_cast<std::size_t>(0.381966 * static_cast<double>(count)) + 1;
  while (std::gcd(step, count) != 1) ++step;
  return step;
}

constexpr std::uint32_t enough_to_denoise = 4;  // samples

void add_noisy(const std::array<PixelSums, 2>& halves, int x, int y, NoisyPicture& to) {
  const auto add = [&](traced::Plane& plane, double value) { plane.row(y)[x] = static_cast<float>(value); };
  PixelSums all = halves[0];
  all += halves[1];
  const double n = all.samples, seen = all.seen / n;
  add(to.seen, seen), add(to.samples, n);
  const auto variance = [&](double square, double mean) { return std::max(square - mean * mean, 0.0) / (n - 1); };
  add(to.spread, variance(all.far_square / all.seen, all.far / all.seen));
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    add(to.first[c], halves[0].lit[i] / halves[0].divisor());
    add(to.second[c], halves[1].lit[i] / halves[1].divisor());
    add(to.variance[c], variance(all.lit_square[i] / n, all.lit_sample[i] / n));
    add(to.albedo[c], std::max(all.albedo[i] / all.divisor(), 0.01 * seen));
    add(to.normal[c], all.normal[i] / n), add(to.place[c], all.place[i] / n);
  }
}

class Traced final : public Renderer {
 public:
  Traced(const RenderOptions& options, World world, unsigned threads)
      : width_(options.width),
        height_(options.height),
        plan_{.samples = static_cast<std::uint32_t>(options.samples), .unclamped = options.unclamped},
        denoised_(options.denoise && (plan_.samples == 0 || plan_.samples >= enough_to_denoise)),
        filter_(*find_pixel_filter(options.pixel_filter)),
        linear_(options.linear),
        threads_(threads),
        world_(std::move(world)) {}

  Status render(const Frame& frame, Picture& out) override { return show(frame, out); }
  Status render(const Evaluation& evaluation, Picture& out) override { return show(evaluation, out); }
  Status render(const Frame& frame, LinearPicture& out) override { return give(frame, out); }
  Status render(const Evaluation& evaluation, LinearPicture& out) override { return give(evaluation, out); }
  Status render_blurred(Evaluation& evaluation, Time t, const Blur& how, LinearPicture& out) override {
    const std::optional<Exposure> exposure = exposure_of(evaluation, t, how, width_, height_);
    if (!exposure) evaluation.to(t);
    if (!exposure || !linear_) return give(evaluation, out);
    Status drawn = guarded([&] { return draw_anew(*exposure); });
    whole_ = false;  // what comes next is another picture
    if (drawn) out = light_;
    return drawn;
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
    return guarded([&]() -> Status {
      if (!previous_.differs(columns) && whole_) return Nothing{};
      whole_ = false;
      Status made = draw_anew(previous_.exposure());
      whole_ = static_cast<bool>(made);
      return made;
    });
  }
  template <class Draw>
  static Status guarded(const Draw& draw) {
    const InStage drawing(Stage::draw);
    try {
      return draw();
    } catch (const std::bad_alloc&) {
      return fail(ErrorCode::machine, "there is not enough memory for this picture");
    }
  }

  // Returns the view of each camera, or none if the numbers of one are not valid.
  std::vector<View> views_of(const std::vector<Camera>& cameras) const {
    std::vector<View> views;
    for (const Camera& c : cameras) {
      bool good = false;
      views.push_back(make_view(c, width_, height_, good));
      if (!good) return {};
    }
    return views;
  }

  Status draw_anew(const Exposure& exposure) {
    std::vector<View> views = views_of(exposure.cameras);
    if (views.empty()) return draw_anew(nothing_of(exposure));
    {
      const InStage gather(Stage::gather);
      const FlushDenormals now;
      if (Status s = world_.set(exposure.things, views.front()); !s) return s;
    }
    begin(views.front());
    const ExposedTracer tracer(world_, exposure, views);
    SamplePlan plan = plan_;
    plan.halved = denoised_ || plan.samples == 0;
    constexpr int side = TileOfPixels::side;
    const auto across = static_cast<std::size_t>((width_ + side - 1) / side);
    const std::size_t tiles = across * static_cast<std::size_t>((height_ + side - 1) / side);
    const std::size_t step = scattering_step(tiles);
    share_work(
        threads_, tiles, [] { return FlushDenormals(); },
        [&](std::size_t k, const auto&) {
          TileOfPixels tile;
          const std::size_t at = k * step % tiles;
          tile.left = side * static_cast<int>(at % across), tile.top = side * static_cast<int>(at / across);
          sample_tile(tracer, filter_, width_, height_, plan, tile);
          store(tile);
          tell(k + 1, tiles);
        });
    if (denoised_) finish();
    WorkProgress::report(1, 1);
    return Nothing{};
  }

  // The surroundings alone, seen by a camera that is valid.
  static Exposure nothing_of(const Exposure& e) {
    return {{}, {Camera()}, {e.lights.front()}, e.background, e.surroundings};
  }

  // Reports how many tiles are done. Denoising takes about as long as two samples.
  void tell(std::size_t done, std::size_t tiles) const {
    constexpr std::size_t denoising = 2, usual = 64;
    const std::size_t samples = plan_.samples == 0 ? usual : plan_.samples, rest = denoised_ ? denoising : 0;
    WorkProgress::report(done * samples, tiles * (samples + rest));
  }

  // Empties the picture.
  void begin(const View& view) {
    light_.width = width_, light_.height = height_;
    light_.rgba.assign(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
    if (!denoised_) return;
    noisy_.emplace(width_, height_);
    noisy_->pixel = 2 / (view.sx * width_), noisy_->orthographic = view.orthographic;
  }

  void store(const TileOfPixels& tile) {
    for (int y = 0; y < tile.rows; ++y)
      for (int x = 0; x < tile.columns; ++x) {
        const auto& halves = tile.halves[static_cast<std::size_t>(y * TileOfPixels::side + x)];
        if (denoised_)
          put_noisy(halves, tile.left + x, tile.top + y);
        else
          put_pixel(halves, pixel(tile.left + x, tile.top + y));
      }
  }
  float* pixel(int x, int y) {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    return &light_.rgba[4 * (row + static_cast<std::size_t>(x))];
  }
  double opacity(const PixelSums& all) const {
    return linear_ ? std::clamp(1 - all.clear / all.divisor(), 0.0, 1.0) : 1;
  }
  void put_pixel(const std::array<PixelSums, 2>& halves, float* out) const {
    PixelSums all = halves[0];
    all += halves[1];
    const Vec3 light = 1 / all.divisor() * (all.lit + all.plain);
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(std::max(light[i], 0.0));
    out[3] = static_cast<float>(opacity(all));
  }

  void put_noisy(const std::array<PixelSums, 2>& halves, int x, int y) {
    PixelSums all = halves[0];
    all += halves[1];
    const bool noisy = all.seen > 0;
    if (noisy) add_noisy(halves, x, y, *noisy_);
    const Vec3 light = 1 / all.divisor() * (noisy ? all.plain : all.plain + all.lit);
    float* const out = pixel(x, y);
    for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(light[i]);
    out[3] = static_cast<float>(opacity(all));
  }

  // Takes the noise out of the light of surfaces, and adds it to the rest.
  void finish() {
    traced::denoise(*noisy_, threads_);
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        float* const out = pixel(x, y);
        for (std::size_t c = 0; c < 3; ++c) out[c] = std::max(out[c] + noisy_->first[c].row(y)[x], 0.0F);
      }
    noisy_.reset();
  }

  const int width_, height_;
  const SamplePlan plan_;
  const bool denoised_;
  const FilterSampler filter_;
  const bool linear_;
  const unsigned threads_;
  World world_;
  PreviousPicture previous_;
  LinearPicture light_;
  std::optional<NoisyPicture> noisy_;  // while a picture is drawn that is denoised
  bool whole_ = false;                 // the picture of the last moment is complete
};

}  // namespace

Result<std::unique_ptr<Renderer>> make_traced(const RenderOptions& options, unsigned threads) {
  auto world = World::create();
  if (!world) return world.error();
  const unsigned some = threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1U);
  return std::unique_ptr<Renderer>(std::make_unique<Traced>(options, *std::move(world), some));
}

}  // namespace betwixt

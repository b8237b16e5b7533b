// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/blur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "render/closing.h"
#include "render/view.h"
#include "scene/extent.h"

namespace betwixt {
namespace {

constexpr double clear_sight = 0.25;  // pixels: less blur than this is sharp

// Columns with the held objects in their places.
class Mixed {
 public:
  Mixed(const Columns& now, const Held& held, const Camera& through)
      : worlds_(now.worlds.begin(), now.worlds.end()),
        looks_(now.looks.begin(), now.looks.end()),
        lights_(held.lights.value_or(now.lights)),
        camera_(through),
        now_(now),
        held_(held) {
    std::uint32_t number = first;
    for (const auto& [i, place] : held.places) {
      worlds_[i] = place.world, looks_[i] = place.look;
      if (place.shape) looks_[i].shape = number;
      if (place.toward) looks_[i].toward = number + 1;
      if (place.texture) looks_[i].texture = number;
      if (place.finish) looks_[i].finish = number;
      if (place.gradients) looks_[i].gradients = number;
      number += 2;
    }
  }
  Columns columns() const {
    const auto shape = [this](std::uint32_t n) -> const std::shared_ptr<const Shape>& {
      if (n < first) return now_.shape(n);
      const Content& place = held_.places[(n - first) / 2].second;
      return (n - first) % 2 == 0 ? place.shape : place.toward;
    };
    const auto texture = [this](std::uint32_t n) {
      return n < first ? now_.texture(n) : held_.places[(n - first) / 2].second.texture;
    };
    const auto finish = [this](std::uint32_t n) -> const std::shared_ptr<const Finish>& {
      return n < first ? now_.finish(n) : held_.places[(n - first) / 2].second.finish;
    };
    const auto gradients = [this](std::uint32_t n) -> const std::shared_ptr<const Gradients>& {
      return n < first ? now_.gradients(n) : held_.places[(n - first) / 2].second.gradients;
    };
    return {.worlds = worlds_,
            .looks = looks_,
            .shape = shape,
            .texture = texture,
            .finish = finish,
            .gradients = gradients,
            .changed = {},
            .lights = lights_,
            .camera = camera_,
            .background = now_.background,
            .surroundings = now_.surroundings};
  }

 private:
  static constexpr std::uint32_t first = 0x80000000;  // numbers of held shapes and textures
  std::vector<Mat4> worlds_;
  std::vector<Evaluation::Look> looks_;
  const std::vector<Light> lights_;
  const Camera camera_;
  const Columns& now_;
  const Held& held_;
};

// Estimates the largest blur in pixels, by motion and by distance from the focus.
class BlurEstimate {
 public:
  BlurEstimate(int width, int height) : width_(width), height_(height) {}
  double most() const { return most_; }
  // Adds the motion of everything since the last time.
  void look(const Columns& c) {
    bool good = false;
    const View view = make_view(c.camera, width_, height_, good);
    if (!good) return;
    const Mat4 clip = view.clip();
    std::vector<Corners> now(c.worlds.size());
    double gone = 0;
    for (std::uint32_t i = 0; i < now.size(); ++i) {
      if (!c.looks[i].visible) continue;
      const Content p = content_of(c, i);
      if (!p.shape) continue;
      now[i] = corners(p, view, clip);
      if (i < before_.size()) gone = std::max(gone, between(before_[i], now[i]));
      if (c.camera.aperture > 0) most_ = std::max(most_, unsharp(c.camera, view, p));
    }
    // A change of light, or of a floor or sky, which have no corners to follow.
    const bool setting = c.surroundings.ground || c.surroundings.sky;
    if (lights_ && (!alike(*lights_, c.lights) || (setting && jumps(*camera_, c.camera)))) gone = wholly;
    before_ = std::move(now), lights_ = c.lights, camera_ = c.camera;
    gone_ += gone;
    most_ = std::max(most_, gone_);
  }

 private:
  static constexpr double wholly = 1e9;  // a change of opacity or shape counts as a long way
  struct Corners {
    std::array<Vec3, 8> at;  // in pixels
    std::shared_ptr<const Shape> shape;
    Vec3 color;
    double transparency = 0, blend = 0;
    bool there = false;
  };
  Corners corners(const Content& p, const View& view, const Mat4& clip) const {
    Corners c;
    c.there = true, c.shape = p.shape, c.color = p.look.color, c.transparency = p.look.transparency,
    c.blend = p.look.blend;
    const Extent box = extent(*p.shape);
    for (std::size_t k = 0; k < 8; ++k) {
      const Vec3 h = box.half(), own{k & 1 ? h.x : -h.x, k & 2 ? h.y : -h.y, k & 4 ? h.z : -h.z};
      const Vec3 seen = transform_point(p.world, box.middle() + own) - view.eye;
      const double w = view.orthographic ? 1 : std::max(view.depth(seen), 1e-3);
      const Vec3 x = transform_vector(clip, seen);
      c.at[k] = {0.5 * width_ * (x.x + clip(0, 3)) / w, 0.5 * height_ * (x.y + clip(1, 3)) / w, 0};
    }
    return c;
  }
  static double between(const Corners& a, const Corners& b) {
    if (!a.there || !b.there) return 0;
    if (a.shape != b.shape || a.blend != b.blend || a.transparency != b.transparency || far_apart(a.color, b.color))
      return wholly;
    double most = 0;
    for (std::size_t k = 0; k < a.at.size(); ++k) most = std::max(most, length(a.at[k] - b.at[k]));
    return std::isfinite(most) ? most : wholly;
  }
  // Returns the diameter of the circle of confusion, the larger of an object's nearest and farthest point.
  double unsharp(const Camera& c, const View& view, const Content& p) const {
    const Extent box = extent(*p.shape);
    const Vec3 seen = transform_point(p.world, box.middle()) - view.eye;
    double most = 0, r = 0;
    for (int i = 0; i < 3; ++i) r += length(column(p.world, i)) * box.half()[i];
    for (const double depth : {view.depth(seen) - r, view.depth(seen) + r})
      most = std::max(most, 0.5 * width_ * view.sx * c.aperture * std::abs(1 / c.focus - 1 / std::max(depth, 1e-3)));
    return most;
  }

  const int width_, height_;
  std::vector<Corners> before_;
  std::optional<std::vector<Light>> lights_;
  std::optional<Camera> camera_;
  double gone_ = 0, most_ = 0;
};

// Returns the k-th of n points on a disc of radius 1: evenly distributed, and no two neighbours in succession.
Vec3 on_lens(int k, int n) {
  const int step = n > 2 ? static_cast<int>(n * 0.381966) | 1 : 1;
  const int own = std::gcd(step, n) == 1 ? static_cast<int>(std::int64_t{k} * step % n) : k;
  const double away = std::sqrt((own + 0.5) / n), turn = own * pi * (3 - std::sqrt(5.0));
  return {away * std::cos(turn), away * std::sin(turn), 0};
}

// The camera of one of n pictures.
Camera part_of(Camera c, int k, int n, int width, int height) {
  if (!(c.aperture > 0) || c.orthographic) return c;
  const Vec3 at = 0.5 * c.aperture * on_lens(k, n);
  const Vec3 right = transform_vector(c.world, {1, 0, 0}), up = transform_vector(c.world, {0, 1, 0});
  const Vec3 eye = translation_of(c.world) + at.x * right + at.y * up;
  for (int i = 0; i < 3; ++i) c.world(i, 3) = eye[i];
  // The plane of focus stays in its place in the picture.
  const double scale = 1 / (c.focus * std::tan(c.fov / 2));
  c.shift_x += at.x * scale, c.shift_y += at.y * scale * width / height;
  return c;
}

void add(const LinearPicture& one, std::vector<double>& sum) {
  sum.resize(one.rgba.size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(one.rgba[i]);
}

}  // namespace

int subframes_needed(Evaluation& e, Time t, double shutter, int most, int width, int height) {
  if (most <= 1) return 1;
  const auto next = shutter > 0 ? e.program().next_change(t) : std::nullopt;
  const bool still = shutter <= 0 || !next || *next > t + from_seconds(shutter);
  if (still && !(e.camera().aperture > 0)) return 1;
  BlurEstimate blur(width, height);
  for (const double part :
       {0.0, 0.19, 0.43, 0.71, 1.0}) {  // uneven, so that rotations do not come back to the same state
    if (still && part > 0) break;
    e.to(t + from_seconds(shutter * part));
    blur.look(columns_of(e));
  }
  if (blur.most() == 0 || (still && blur.most() < clear_sight)) return 1;
  // With this many pictures a pixel, an edge is as exact as with all pictures for longer distances: off by half the
  // share of one picture.
  constexpr double a_pixel = 64, at_least = 16;
  return std::min(most, 4 * static_cast<int>(std::ceil(std::clamp(a_pixel * blur.most(), at_least, 1e6) / 4)));
}

Status render_blurred(Evaluation& e, Time t, const Blur& how, int width, int height, const DrawColumns& draw,
                      LinearPicture& out) {
  e.to(t);
  const double shutter = std::clamp(how.shutter.value_or(e.camera().shutter), 0.0, 60.0);
  const int n = subframes_needed(e, t, shutter, how.subframes, width, height);
  e.to(t);
  if (n == 1) return draw(columns_of(e), out);
  const Closing closes =
      closing(e, shutter > 0 ? e.program().discontinuities(t, t + from_seconds(shutter)) : std::vector<Time>{});
  std::vector<double> sum;
  for (int k = 0; k < n; ++k) {
    const double part = (k + 0.5) / n;
    const Held held = held_at(e, t, part, closes);
    e.to(t + from_seconds(shutter * part));
    const Columns all = columns_of(e);
    const Mixed mixed(all, held, part_of(held.camera.value_or(e.camera()), k, n, width, height));
    if (Status s = draw(mixed.columns(), out); !s) return s;
    add(out, sum);
  }
  for (std::size_t i = 0; i < sum.size(); ++i) out.rgba[i] = static_cast<float>(sum[i] / n);
  return Nothing{};
}

}  // namespace betwixt

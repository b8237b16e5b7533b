// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/gradients.h"

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

// The angle of a point in turns, 0 to 1, anticlockwise from x. The series (Abramowitz and Stegun 4.4.49) is that of the
// shader, off by less than 1e-8 turns.
double turn_of(double x, double y) {
  const double wide = std::abs(x), high = std::abs(y), most = std::max(wide, high);
  if (!(most > 0)) return 0;
  const double s = std::min(wide, high) / most, z = s * s;
  double turn =
      s *
      (1 + z * (-0.3333314528 +
                z * (0.1999355085 +
                     z * (-0.1420889944 +
                          z * (0.1065626393 +
                               z * (-0.0752896400 + z * (0.0429096138 + z * (-0.0161657367 + z * 0.0028662257))))))));
  turn *= 0.5 / pi;
  if (high > wide) turn = 0.25 - turn;
  if (x < 0) turn = 0.5 - turn;
  return y < 0 ? 1 - turn : turn;
}

}  // namespace

GradientLight light_of(const Gradient::Stop& s) {
  const auto shown = [&](double c) { return s.opacity * std::clamp(c, 0.0, 1e4); };
  return {{shown(s.color.x), shown(s.color.y), shown(s.color.z)}, s.opacity};
}

PlacedGradient placed_gradient(const Gradient& g, const Box& box, const Mat4& m) {
  const GradientPlane p = plane_of(g, box);
  PlacedGradient out;
  for (std::size_t k = 0; k < 4; ++k) {
    const int c = static_cast<int>(k);
    out.x[k] = p.x[0] * m(0, c) + p.x[1] * m(1, c) + (k == 3 ? p.x[2] : 0);
    out.y[k] = p.y[0] * m(0, c) + p.y[1] * m(1, c) + (k == 3 ? p.y[2] : 0);
  }
  return out;
}

std::optional<PixelRows> rows_from_pixels(const PlacedGradient& to, const Mat4& clip, int width, int height, double z) {
  PixelRows p{};  // from (x y 1) of the mesh to pixels
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = [&](int row) {
      const int c = static_cast<int>(k);
      return k < 2 ? clip(row, c) : clip(row, 2) * z + clip(row, 3);
    };
    p[0][k] = 0.5 * width * (at(0) + at(3)), p[1][k] = 0.5 * height * (at(1) + at(3)), p[2][k] = at(3);
  }
  const auto minor = [&](std::size_t r, std::size_t c) {
    const auto &a = p[(r + 1) % 3], &b = p[(r + 2) % 3];
    return a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
  };
  const double d = p[0][0] * minor(0, 0) + p[0][1] * minor(0, 1) + p[0][2] * minor(0, 2);
  if (!(std::abs(d) > 1e-300)) return std::nullopt;
  const std::array<double, 3> rows[] = {
      {to.x[0], to.x[1], to.x[2] * z + to.x[3]}, {to.y[0], to.y[1], to.y[2] * z + to.y[3]}, {0, 0, 1}};
  PixelRows out{};
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      out[r][c] = rows[r][0] * minor(c, 0) + rows[r][1] * minor(c, 1) + rows[r][2] * minor(c, 2);
  return out;
}

bool is_even(const Gradient& g, const PixelRows& rows, int width) {
  constexpr double nothing = 1e-9;
  return g.kind == GradientKind::linear && std::abs(rows[2][0]) * width <= nothing * std::abs(rows[2][2]) &&
         std::abs(rows[0][0]) * width <= nothing * std::abs(rows[2][2]);
}

GradientColors::GradientColors(const Gradient& g)
    : kind_(g.kind == GradientKind::circular ? GradientKind::radial : g.kind), spread_(g.spread), size_(g.size) {
  GradientLight sum;
  for (const Gradient::Stop& s : g.stops) {
    const GradientLight light = light_of(s);
    if (stops_.empty()) {
      sum = s.at * light;
    } else {
      const Stop& last = stops_.back();
      sum = sum + (0.5 * (s.at - last.at)) * (last.light + light);
      edges_ = edges_ || s.at <= last.at;
    }
    stops_.push_back({s.at, light, sum});
  }
  all_ = sum + (1 - stops_.back().at) * stops_.back().light;
  edges_ = edges_ || spread_ != GradientSpread::pad || kind_ == GradientKind::conic;
}

GradientLight GradientColors::ramp(double t) const {
  if (spread_ == GradientSpread::repeat) t -= std::floor(t);
  if (spread_ == GradientSpread::reflect) t -= 2 * std::floor(t / 2), t = t > 1 ? 2 - t : t;
  std::size_t i = 0;
  while (i < stops_.size() && stops_[i].at <= t) ++i;
  if (i == 0) return stops_.front().light;
  if (i == stops_.size()) return stops_.back().light;
  const double share = (t - stops_[i - 1].at) / (stops_[i].at - stops_[i - 1].at);
  return (1 - share) * stops_[i - 1].light + share * stops_[i].light;
}

// The sum from 0 to t, which is from 0 to 1.
GradientLight GradientColors::sum_in(double t) const {
  std::size_t i = 0;
  while (i < stops_.size() && stops_[i].at <= t) ++i;
  if (i == 0) return t * stops_.front().light;
  const Stop& last = stops_[i - 1];
  const double way = t - last.at;
  if (i == stops_.size()) return last.sum + way * last.light;
  const double share = way / (stops_[i].at - last.at);
  return last.sum + (0.5 * way) * ((2 - share) * last.light + share * stops_[i].light);
}

// The same of any t, with what is beyond the gradient.
GradientLight GradientColors::sum(double t) const {
  switch (spread_) {
    case GradientSpread::repeat: {
      const double whole = std::floor(t);
      return whole * all_ + sum_in(t - whole);
    }
    case GradientSpread::reflect: {
      const double whole = std::floor(t / 2), rest = t - 2 * whole;
      const GradientLight there = rest <= 1 ? sum_in(rest) : 2 * all_ + -1 * sum_in(2 - rest);
      return 2 * whole * all_ + there;
    }
    default:
      return t < 0 ? t * stops_.front().light : t > 1 ? all_ + (t - 1) * stops_.back().light : sum_in(t);
  }
}

double GradientColors::place(double x, double y) const {
  return kind_ == GradientKind::linear ? x : kind_ == GradientKind::radial ? std::sqrt(x * x + y * y) : turn_of(x, y);
}

GradientLight GradientColors::at(double x, double y) const {
  const double t = place(x, y);
  return ramp(kind_ == GradientKind::conic ? t / size_ : t);
}

GradientLight GradientColors::around(double x, double y, double right_x, double right_y, double down_x,
                                     double down_y) const {
  const double t = place(x, y), square = std::max(x * x + y * y, 1e-30);
  const auto slope = [&](double dx, double dy) {
    return kind_ == GradientKind::linear   ? dx
           : kind_ == GradientKind::radial ? (x * dx + y * dy) / std::sqrt(square)
                                           : (x * dy - y * dx) / (2 * pi * square);
  };
  const double right = slope(right_x, right_y), down = slope(down_x, down_y);
  const double width = std::min(std::sqrt(right * right + down * down), 1e6);
  if (!(width > 1e-9)) return at(x, y);
  const double from = t - width / 2, to = t + width / 2;
  if (kind_ != GradientKind::conic) return (1 / width) * (sum(to) + -1 * sum(from));
  if (width >= 1) return size_ * sum(1 / size_);  // the middle of the turns
  const auto around_to = [&](double turn) {
    const double whole = std::floor(turn);
    return whole * size_ * sum(1 / size_) + size_ * sum((turn - whole) / size_);
  };
  return (1 / width) * (around_to(to) + -1 * around_to(from));
}

GradientUniforms uniforms_of(const Gradient& g, const PlacedGradient& p) {
  const auto as = [](double v) { return static_cast<float>(v); };
  GradientUniforms u;
  for (std::size_t k = 0; k < 4; ++k) u.x[k] = as(p.x[k]), u.y[k] = as(p.y[k]);
  const std::size_t count = std::min(g.stops.size(), most_stops);
  const float way = g.kind == GradientKind::linear ? 1.F : g.kind == GradientKind::conic ? 3.F : 2.F;
  u.grading = {way, static_cast<float>(g.spread), as(g.size), static_cast<float>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    const GradientLight l = light_of(g.stops[i]);
    u.stop_light[i] = {as(l.light.x), as(l.light.y), as(l.light.z), as(l.opacity)};
    u.stop_at[i] = as(g.stops[i].at);
  }
  return u;
}

const char* const gradient_vertex = R"(
#if defined(GRADIENT)
uniform vec4 gradient_x, gradient_y;  // from mesh space
out vec2 in_gradient;
void place_gradient(vec4 p) { in_gradient = vec2(dot(gradient_x, p), dot(gradient_y, p)); }
#else
void place_gradient(vec4 p) {}
#endif
)";

const char* const gradient_shader = R"(
#if defined(GRADIENT)
in vec2 in_gradient;
uniform vec4 grading;          // 1 linear, 2 from a point, 3 around it; the spread, the part of a turn, the number of stops
uniform vec4 stop_light[16];   // light times opacity, and opacity
uniform float stop_at[16];
float turn_of(vec2 p) {
  vec2 a = abs(p);
  float s = min(a.x, a.y) / max(max(a.x, a.y), 1e-30), z = s * s;
  float turn = s * (1.0 + z * (-0.3333314528 + z * (0.1999355085 + z * (-0.1420889944 + z * (0.1065626393 +
               z * (-0.0752896400 + z * (0.0429096138 + z * (-0.0161657367 + z * 0.0028662257))))))));
  turn *= 0.15915494;
  turn = a.y > a.x ? 0.25 - turn : turn;
  turn = p.x < 0.0 ? 0.5 - turn : turn;
  return p.y < 0.0 ? 1.0 - turn : turn;
}
// The colours at t; those that do not go over into each other are mixed across the width of a pixel.
vec4 ramp(float t, float pixel) {
  vec4 sum = stop_light[0];
  int count = int(grading.w);
  for (int i = 1; i < count; ++i) {
    float width = max(stop_at[i] - stop_at[i - 1], max(pixel, 1e-6)), middle = 0.5 * (stop_at[i] + stop_at[i - 1]);
    sum = mix(sum, stop_light[i], clamp((t - middle) / width + 0.5, 0.0, 1.0));
  }
  return sum;
}
float spread(float t) {
  return grading.y < 0.5 ? t : grading.y < 1.5 ? fract(t) : 1.0 - abs(1.0 - 2.0 * fract(0.5 * t));
}
// Where the end meets the beginning, they are mixed across a pixel.
vec4 joined(vec4 here, vec4 begins, vec4 ends, float t, float pixel) {
  float off = t - floor(t + 0.5);
  return abs(off) < 0.5 * pixel ? mix(ends, begins, off / pixel + 0.5) : here;
}
vec4 graded(vec2 p) {
  vec2 right = dFdx(p), down = dFdy(p);
  if (grading.x < 2.5) {
    float far = length(p), t = grading.x < 1.5 ? p.x : far;
    float pixel = grading.x < 1.5 ? length(vec2(right.x, down.x)) : length(vec2(dot(p, right), dot(p, down))) / max(far, 1e-9);
    vec4 here = ramp(spread(t), pixel);
    return grading.y > 0.5 && grading.y < 1.5 ? joined(here, ramp(0.0, 0.0), ramp(1.0, 0.0), t, min(pixel, 1.0)) : here;
  }
  float t = turn_of(p);
  float pixel = min(0.15915494 * length(vec2(p.x * right.y - p.y * right.x, p.x * down.y - p.y * down.x)) / max(dot(p, p), 1e-20), 1.0);
  vec4 here = ramp(spread(t / grading.z), pixel / grading.z);
  return joined(here, ramp(0.0, 0.0), ramp(spread(1.0 / grading.z - 1e-6), 0.0), t, pixel);
}
vec4 own_color() {
  vec4 light = graded(in_gradient);
  return vec4(light.rgb / max(light.a, 1e-6) * part_color.rgb, light.a * paint.a);
}
#elif !defined(GROUND)
vec4 own_color() { return vec4(mix(vec3(1.0), paint.rgb, part_color.a) * part_color.rgb, paint.a); }
#endif
)";

}  // namespace betwixt

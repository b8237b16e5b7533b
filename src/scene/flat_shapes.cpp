// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/flat_shapes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/primitives.h"
#include "scene/strokes.h"

namespace betwixt {
namespace {

constexpr int round_turn = 128;  // corners of a full circle
constexpr double most_corners = 10'000;

Vec3 on_circle(double radius, double angle, Vec3 about = {0, 0, 0}) {
  return about + Vec3{radius * std::cos(angle), radius * std::sin(angle), 0};
}

// Adds points along a circle, both ends included.
void go_round(std::vector<Vec3>& out, Vec3 about, double radius, double from, double to) {
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / (2 * pi) * round_turn)));
  for (int i = 0; i <= steps; ++i) out.push_back(on_circle(radius, from + (to - from) * i / steps, about));
}
std::vector<Vec3> whole_circle(double radius) {
  std::vector<Vec3> out;
  for (int i = 0; i < round_turn; ++i) out.push_back(on_circle(radius, 2 * pi * i / round_turn));
  return out;
}
std::vector<Vec3> backwards(std::vector<Vec3> contour) {
  std::reverse(contour.begin(), contour.end());
  return contour;
}

// Returns the number of corners, or 0 if it makes no shape.
int corners(double n, double least) {
  const double whole = std::floor(n + 0.5);
  return whole >= least && whole <= most_corners ? static_cast<int>(whole) : 0;
}

// Returns the area between two circles, from one angle to a larger one.
std::vector<Vec3> band(double outer, double inner, double from, double to) {
  std::vector<Vec3> out;
  go_round(out, {0, 0, 0}, outer, from, to);
  if (inner > 0)
    go_round(out, {0, 0, 0}, inner, to, from);
  else
    out.push_back({0, 0, 0});
  return out;
}

}  // namespace

Contours disc_contours(const Shape& s) {
  if (!sane(s.radius) || !(s.radius > 0)) return {};
  return {whole_circle(s.radius)};
}

Contours rings(const std::vector<Vec3>& points) {
  Contours all;
  std::vector<Vec3> one;
  for (const Vec3 p : points) {
    const bool again = one.size() > 1 && p == one.front();
    if (!again) one.push_back(p);
    if (again) all.push_back(std::exchange(one, {}));
  }
  if (!one.empty()) all.push_back(std::move(one));
  return all;
}

Contours polygon_contours(const Shape& s) {
  if (s.points->size() < 3 || !sane(*s.points) || !sane(*s.holes)) return {};
  Contours all{*s.points};
  if (s.holes->empty()) return all;
  const auto turns_left = [up = facing(all)](const std::vector<Vec3>& c) {
    double sum = 0;
    for (std::size_t i = 0; i < c.size(); ++i) sum += dot(cross(c[i] - c[0], c[(i + 1) % c.size()] - c[0]), up);
    return sum > 0;
  };
  if (!turns_left(all[0])) all[0] = backwards(all[0]);
  for (auto& ring : rings(*s.holes))
    if (ring.size() > 2) all.push_back(turns_left(ring) ? backwards(ring) : ring);
  return all;
}

Contours rectangle_contours(const Shape& s) {
  const double x = s.size.x / 2, y = s.size.y / 2;
  if (!sane(s.size) || !(x > 0) || !(y > 0)) return {};
  const double r = std::clamp(s.corner, 0.0, std::min(x, y));
  if (!(r > 0)) return {{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}}};
  std::vector<Vec3> out;
  go_round(out, {x - r, y - r, 0}, r, 0, pi / 2);
  go_round(out, {r - x, y - r, 0}, r, pi / 2, pi);
  go_round(out, {r - x, r - y, 0}, r, pi, 3 * pi / 2);
  go_round(out, {x - r, r - y, 0}, r, 3 * pi / 2, 2 * pi);
  return {out};
}

Contours video_contours(const Shape& s) {
  Shape whole = s;
  whole.size = s.height * s.size;
  return rectangle_contours(whole);
}

Contours ring_contours(const Shape& s) {
  if (!sane(s.radius) || !(s.radius > 0) || !(s.inner < s.radius)) return {};
  if (!(s.inner > 0)) return {whole_circle(s.radius)};
  return {whole_circle(s.radius), backwards(whole_circle(s.inner))};
}

Contours arc_contours(const Shape& s) {
  const double way = std::clamp(s.to - s.from, -2 * pi, 2 * pi), half = s.width / 2;
  if (!sane(s.radius) || !sane(s.width) || !(s.radius > 0) || !(half > 0) || !(std::abs(way) > 0)) return {};
  const double outer = s.radius + half, inner = std::max(0.0, s.radius - half);
  const Dashes dashes = dashes_of(s);
  if (std::abs(way) >= 2 * pi && dashes.whole()) {
    Contours both{whole_circle(outer)};
    if (inner > 0) both.push_back(backwards(whole_circle(inner)));
    return both;
  }
  Contours all;
  for (const auto& [from, to] : drawn_parts(s.radius * std::abs(way), dashes)) {
    const double a = s.from + std::copysign(from / s.radius, way), b = s.from + std::copysign(to / s.radius, way);
    if (a != b) all.push_back(band(outer, inner, std::min(a, b), std::max(a, b)));
  }
  return all;
}

Contours regular_contours(const Shape& s) {
  const int n = corners(s.sides, 3);
  if (n == 0 || !sane(s.radius) || !(s.radius > 0)) return {};
  std::vector<Vec3> out;
  for (int i = 0; i < n; ++i) out.push_back(on_circle(s.radius, pi / 2 + 2 * pi * i / n));
  return {out};
}

Contours star_contours(const Shape& s) {
  const int n = corners(s.sides, 2);
  if (n == 0 || !sane(s.radius) || !(s.radius > 0) || !(s.inner > 0) || !sane(s.inner)) return {};
  std::vector<Vec3> out;
  for (int i = 0; i < 2 * n; ++i) out.push_back(on_circle(i % 2 == 0 ? s.radius : s.inner, pi / 2 + pi * i / n));
  return {out};
}

Contours gear_contours(const Shape& s) {
  const int n = corners(s.sides, 4);
  if (n == 0 || !sane(s.module) || !(s.module > 0)) return {};
  constexpr double pressure = 20 * pi / 180;
  constexpr int flank = 12;
  const double pitch = n * s.module / 2, base = pitch * std::cos(pressure), tip = pitch + s.module;
  const double root = std::max(0.1 * pitch, pitch - 1.25 * s.module);
  const auto involute = [](double angle) { return std::tan(angle) - angle; };
  // Returns half the angle of a tooth at a radius.
  const auto half = [&](double r) {
    return pi / (2 * n) + involute(pressure) - involute(std::acos(std::min(1.0, base / r)));
  };
  const double begins = std::max(base, root);
  const double ends = half(tip) > 0 ? tip : pitch + 0.5 * s.module;  // with few teeth they end in a point earlier
  std::vector<Vec3> out;
  for (int tooth = 0; tooth < n; ++tooth) {
    const double middle = pi / 2 + 2 * pi * tooth / n;
    if (root < begins) out.push_back(on_circle(root, middle - half(begins)));
    for (int side = -1; side <= 1; side += 2)
      for (int i = 0; i <= flank; ++i) {
        const double r = begins + (ends - begins) * (side < 0 ? i : flank - i) / flank;
        out.push_back(on_circle(r, middle + side * half(r)));
      }
    if (root < begins) out.push_back(on_circle(root, middle + half(begins)));
  }
  Contours all{out};
  if (s.inner > 0 && s.inner < root) all.push_back(backwards(whole_circle(s.inner)));
  return all;
}

Contours arrow_contours(const Shape& s) {
  const double way = length(s.size);
  if (!sane(s.size) || !sane(s.width) || !(way > 0) || !(s.width > 0)) return {};
  const Vec3 along = (1 / way) * s.size;
  const Vec3 flat{-along.y, along.x, 0};
  const Vec3 across = length(flat) > 1e-9 ? normalize(flat, {0, 1, 0}) : Vec3{1, 0, 0};
  const double head = std::min(way, 4 * s.width), thin = s.width / 2, wide = 1.5 * s.width;
  const auto at = [&](double forth, double aside) { return forth * along + aside * across; };
  std::vector<Vec3> out;
  if (head < way) out = {at(0, -thin), at(way - head, -thin)};
  for (const Vec3 p : {at(way - head, -wide), at(way, 0), at(way - head, wide)}) out.push_back(p);
  if (head < way) out.push_back(at(way - head, thin)), out.push_back(at(0, thin));
  return {out};
}

}  // namespace betwixt

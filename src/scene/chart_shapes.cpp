// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Outlines of plots, charts and marks.
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/flat_shapes.h"
#include "scene/primitives.h"

namespace betwixt {

std::vector<std::vector<Vec3>> unbroken(const std::vector<Vec3>& points) {
  std::vector<std::vector<Vec3>> all(1);
  for (const Vec3 p : points)
    if (sane(p))
      all.back().push_back(p);
    else if (!all.back().empty())
      all.emplace_back();
  if (all.back().empty()) all.pop_back();
  return all;
}

Contours broken_contours(const Shape& s) {
  Contours all = unbroken(*s.points);
  std::erase_if(all, [](const auto& ring) { return ring.size() < 3; });
  return all;
}

Contours bar_contours(const Shape& s) {
  if (!sane(s.size) || s.size.x == 0 || s.size.y == 0) return {};
  // Along its growth, and across: seen from its foot, the corners at its end are round.
  const bool up = s.height > 0.5;
  const double grown = up ? s.size.y : s.size.x, half = std::abs(up ? s.size.x : s.size.y) / 2;
  const double r = std::clamp(s.corner, 0.0, std::min(std::abs(grown), half)), way = grown < 0 ? -1 : 1;
  const auto at = [&](double along, double across) {
    return up ? Vec3{-across, way * along, 0} : Vec3{way * along, across, 0};
  };
  constexpr int steps = 8;
  const double end = std::abs(grown);
  std::vector<Vec3> out{at(0, -half)};
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i <= (r > 0 ? steps : 0); ++i) {
      const double a = pi / 2 * (side < 0 ? i : steps - i) / steps;
      out.push_back(r > 0 ? at(end - r + r * std::sin(a), side * (half - r + r * std::cos(a))) : at(end, side * half));
    }
  out.push_back(at(0, half));
  if (way < 0) std::reverse(out.begin(), out.end());
  return {out};
}

// Two bows of a quarter circle each, from the ends to a bar, and from the bar to the tip.
Contours brace_contours(const Shape& s) {
  const double way = length(s.size), high = s.height, half = s.width / 2;
  if (!sane(s.size) || !sane(s.width) || !sane(high) || !(way > 0) || !(half > 0) || !(high > 0)) return {};
  const Vec3 along = (1 / way) * s.size, across = normalize(Vec3{along.y, -along.x, 0}, {0, -1, 0});
  const double r = std::min(high / 2, way / 4);
  constexpr int steps = 16;
  std::vector<std::pair<Vec3, Vec3>> middle;  // points of the middle line, in (along, across), and their normals
  const auto bow = [&](double cx, double cy, double from, double to) {
    for (int i = 0; i <= steps; ++i) {
      const double a = from + (to - from) * i / steps;
      const double turn = to > from ? 1 : -1;
      middle.push_back({{cx + r * std::cos(a), cy + r * std::sin(a), 0}, turn * Vec3{std::cos(a), std::sin(a), 0}});
    }
  };
  const double level = high - r;
  bow(r, level - r, pi, pi / 2);
  bow(way / 2 - r, level + r, -pi / 2, 0);
  const std::size_t tip = middle.size();
  for (std::size_t i = tip; i-- > 0;) {
    const auto [p, n] = middle[i];
    middle.push_back({{way - p.x, p.y, 0}, {n.x, -n.y, 0}});
  }
  std::vector<Vec3> one, other;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const auto [p, n] = middle[i];
    const auto put = [&](Vec3 q) { return q.x * along + (q.y - (level - r)) * across; };
    const double thin =
        half * (0.35 + 0.65 * std::sin(pi * static_cast<double>(i % tip) / static_cast<double>(tip - 1)));
    one.push_back(put(p + thin * n)), other.push_back(put(p - thin * n));
  }
  one.insert(one.end(), other.rbegin(), other.rend());
  return {one};
}

}  // namespace betwixt

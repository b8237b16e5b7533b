// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/link_way.h"

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

Vec3 unit_way(Vec3 v) { return length(v) > 1e-12 ? (1 / length(v)) * v : Vec3{1, 0, 0}; }

// A cubic curve of 24 pieces.
std::vector<Vec3> bow(Vec3 from, Vec3 away, Vec3 back, Vec3 to) {
  std::vector<Vec3> out;
  for (int i = 0; i <= 24; ++i) {
    const double u = i / 24.0, v = 1 - u;
    out.push_back(v * v * v * from + 3 * v * v * u * away + 3 * v * u * u * back + u * u * u * to);
  }
  return out;
}

// It leaves at the top and comes back from the right. Its end is straight, as far as a tip is long.
std::vector<Vec3> loop_at(const LinkBorder& a, double gap, double metre) {
  const bool is_round = a.height == 0;
  const double beside = 0.2 * metre, turn = is_round ? std::min(beside / std::max(a.width, 1e-9), 0.6) : 0;
  const auto ray = [](double angle) { return Vec3{std::cos(angle), std::sin(angle), 0}; };
  const Vec3 up = is_round ? ray(pi / 4 + turn) : Vec3{0, 1, 0}, right = is_round ? ray(pi / 4 - turn) : Vec3{1, 0, 0};
  const Vec3 top = is_round ? a.width * up : Vec3{std::max(a.width - beside, 0.0), a.height, 0},
             edge = is_round ? a.width * right : Vec3{a.width, std::max(a.height - beside, 0.0), 0};
  const Vec3 from = a.middle + top + gap * up, to = a.middle + edge + gap * right, before = to + 0.24 * metre * right;
  std::vector<Vec3> out = bow(from, from + 0.8 * metre * up, before + 0.56 * metre * right, before);
  out.push_back(to);
  return out;
}

// Along the longer direction, across in the middle.
std::vector<Vec3> angled_way(Vec3 d, const auto& leaves) {
  const bool flat = std::abs(d.x) >= std::abs(d.y);
  const Vec3 way = flat ? Vec3{d.x < 0 ? -1.0 : 1.0, 0, 0} : Vec3{0, d.y < 0 ? -1.0 : 1.0, 0};
  const Vec3 from = leaves(true, way), to = leaves(false, -1 * way), half = 0.5 * (from + to);
  return flat ? std::vector<Vec3>{from, {half.x, from.y, from.z}, {half.x, to.y, to.z}, to}
              : std::vector<Vec3>{from, {from.x, half.y, from.z}, {to.x, half.y, to.z}, to};
}

std::vector<Vec3> whole_way(const LinkBorder& a, const LinkBorder& b, std::string_view route, double gap,
                            double metre) {
  if (route == "loop") return loop_at(a, gap, metre);
  const Vec3 d = b.middle - a.middle;
  const auto leaves = [&](bool first, Vec3 way) {
    const LinkBorder& one = first ? a : b;
    return one.middle + (one.reach(way) + gap) * way;
  };
  if (route == "angled") return angled_way(d, leaves);
  if (route != "curved") return {leaves(true, unit_way(d)), leaves(false, unit_way(-1 * d))};
  const Vec3 bulge = 0.5 * (a.middle + b.middle) + 0.22 * Vec3{-d.y, d.x, 0};
  const Vec3 from = leaves(true, unit_way(bulge - a.middle)), to = leaves(false, unit_way(bulge - b.middle));
  std::vector<Vec3> out;
  for (int i = 0; i <= 24; ++i) {
    const double u = i / 24.0;
    out.push_back((1 - u) * (1 - u) * from + 2 * u * (1 - u) * bulge + u * u * to);
  }
  return out;
}

// Takes a length from the end of a way.
void shorten(std::vector<Vec3>& points, double by) {
  while (points.size() > 2 && length(points.back() - points[points.size() - 2]) <= by) {
    by -= length(points.back() - points[points.size() - 2]);
    points.pop_back();
  }
  Vec3& last = points.back();
  last = last - by * unit_way(last - points[points.size() - 2]);
}

// ---- Labels

bool overlap(const LinkBorder& a, const LinkBorder& b) {
  return std::abs(a.middle.x - b.middle.x) < a.width + b.width - 1e-9 &&
         std::abs(a.middle.y - b.middle.y) < a.height + b.height - 1e-9;
}
// Returns whether a piece of a line goes through a rectangle: it is cut at each of the four sides.
bool goes_through(const LinkBorder& r, Vec3 from, Vec3 to) {
  double first = 0, last = 1;
  for (int i = 0; i < 2; ++i) {
    const double half = i ? r.height : r.width, at = from[i] - r.middle[i], step = to[i] - from[i];
    if (std::abs(step) < 1e-12) {
      if (std::abs(at) >= half) return false;
      continue;
    }
    const double one = (-half - at) / step, two = (half - at) / step;
    first = std::max(first, std::min(one, two)), last = std::min(last, std::max(one, two));
  }
  return first < last;
}
bool meets_line(const LinkBorder& r, const std::vector<Vec3>& line) {
  for (std::size_t i = 1; i < line.size(); ++i)
    if (goes_through(r, line[i - 1], line[i])) return true;
  return false;
}

}  // namespace

double LinkBorder::reach(Vec3 way) const {
  if (height == 0) return width;
  const double x = std::abs(way.x), y = std::abs(way.y);
  return std::min(x > 1e-12 ? width / x : 1e9, y > 1e-12 ? height / y : 1e9);
}

std::vector<Vec3> link_way(const LinkBorder& a, const LinkBorder& b, std::string_view route, double gap, double tip,
                           double metre) {
  std::vector<Vec3> points = whole_way(a, b, route, gap, metre);
  return shorten(points, tip), points;
}

Vec3 place_of_label(const std::vector<Vec3>& line, double half, LinkLabel label) {
  if (line.size() < 2) return {};
  double left = 0;
  for (std::size_t i = 1; i < line.size(); ++i) left += length(line[i] - line[i - 1]);
  left *= label.at;
  std::size_t i = 1;
  for (; i + 1 < line.size() && length(line[i] - line[i - 1]) < left; ++i) left -= length(line[i] - line[i - 1]);
  const Vec3 d = unit_way(line[i] - line[i - 1]), at = line[i - 1] + left * d;
  const Vec3 across = d.x < 0 ? Vec3{d.y, -d.x, 0} : Vec3{-d.y, d.x, 0};  // up, or beside an upright line
  const double away = 0.08 + std::abs(across.x) * half + std::abs(across.y) * half_label_height;
  if (label.side == LinkSide::above) return at + away * across;
  if (label.side == LinkSide::below) return at - away * across;
  // Along x it is further, and in a flat line it would be at no end.
  const double along = away / std::max(std::abs(across.x), 0.35);
  return at + Vec3{label.side == LinkSide::left ? -along : along, 0, 0};
}

LinkLabel free_label(const LabelSurroundings& all, const std::vector<Vec3>& line, double half) {
  LinkLabel best;
  double least = 1e300;
  for (const double at : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8})
    for (const LinkSide side : {LinkSide::above, LinkSide::below, LinkSide::right, LinkSide::left}) {
      const LinkBorder here{place_of_label(line, half, {at, side}), half, half_label_height};
      double cost = std::abs(at - 0.5);
      if (cost >= least) continue;
      for (const LinkBorder& node : all.nodes) cost += overlap(here, node) ? 1e6 : 0;
      for (const LinkBorder& label : all.labels) cost += overlap(here, label) ? 1e3 : 0;
      for (std::size_t i = 0; i < all.lines.size() && cost < least; ++i) cost += meets_line(here, all.lines[i]) ? 1 : 0;
      if (cost < least) least = cost, best = {at, side};
    }
  return best;
}

}  // namespace betwixt

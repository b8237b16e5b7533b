// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/line.h"

#include <algorithm>
#include <cmath>

#include "scene/flat_shapes.h"
#include "scene/kinds.h"
#include "scene/primitives.h"

namespace betwixt {
namespace {

constexpr std::size_t most_pieces = 400'000;  // of a smooth curve, unless it has more points than that

Line of_circle(double radius, double from, double to) {
  constexpr int steps = 256;
  Line out;
  const double turns = std::abs(to - from) / (2 * pi);
  out.closed = turns >= 1;
  const int n = std::max(1, static_cast<int>(std::ceil(std::min(turns, 1.0) * steps)));
  if (out.closed) to = from + std::copysign(2 * pi, to - from);
  for (int i = 0; i < (out.closed ? n : n + 1); ++i) {
    const double a = from + (to - from) * i / n;
    out.points.push_back({radius * std::cos(a), radius * std::sin(a), 0});
  }
  return out;
}

std::vector<Vec3> sane_points(const Shape& s) {
  std::vector<Vec3> out;
  for (const Vec3 p : *s.points)
    if (sane(p)) out.push_back(p);
  return out;
}

}  // namespace

bool has_line(Kind k) { return row_of(k).line || row_of(k).contours != nullptr; }

Line line_of(const Shape& s) {
  switch (s.kind) {
    case Kind::polyline:
    case Kind::trace:
    case Kind::plot:
    case Kind::tangent:
    case Kind::streamlines:
      return {sane_points(s), false};
    case Kind::curve:
      return {s.smooth ? through(sane_points(s), s.closed) : sane_points(s), s.closed};
    case Kind::disc:
      return sane(s.radius) ? of_circle(s.radius, 0, 2 * pi) : Line{};
    case Kind::arc:
      return sane(s.radius) && sane(s.from) && sane(s.to) ? of_circle(s.radius, s.from, s.to) : Line{};
    case Kind::arrow:
    case Kind::line:
      return sane(s.size) ? Line{{{0, 0, 0}, s.size}, false} : Line{};
    default:
      break;
  }
  const auto contours = row_of(s.kind).contours;
  if (!contours) return {};
  auto all = contours(s);
  return all.empty() ? Line{} : Line{std::move(all[0]), true};
}

std::vector<Line> lines_of(const Shape& s) {
  if (std::all_of(s.points->begin(), s.points->end(), [](Vec3 p) { return sane(p); })) return {line_of(s)};
  std::vector<Line> all;
  for (auto& piece : unbroken(*s.points)) {
    Shape one = s;
    one.points = Points(std::move(piece)), one.closed = false;
    all.push_back(line_of(one));
  }
  return all;
}

std::vector<Vec3> through(const std::vector<Vec3>& points, bool closed) {
  const std::size_t n = points.size();
  if (n < 3) return points;
  const std::size_t pieces = std::clamp<std::size_t>(most_pieces / n, 1, 32);
  const auto at = [&](std::ptrdiff_t i) {  // beyond the ends an open line continues straight
    const auto count = static_cast<std::ptrdiff_t>(n);
    if (closed) return points[static_cast<std::size_t>((i + count) % count)];
    if (i < 0) return 2.0 * points[0] - points[1];
    return i < count ? points[static_cast<std::size_t>(i)] : 2.0 * points[n - 1] - points[n - 2];
  };
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < (closed ? n : n - 1); ++i) {
    const auto k = static_cast<std::ptrdiff_t>(i);
    const Vec3 a = at(k - 1), b = at(k), c = at(k + 1), d = at(k + 2);
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const double u = static_cast<double>(piece) / static_cast<double>(pieces);
      out.push_back(b + (u / 2) * ((c - a) + u * ((2.0 * a - 5.0 * b + 4.0 * c - d) + u * (3.0 * (b - c) + d - a))));
    }
  }
  if (!closed) out.push_back(points.back());
  return out;
}

MeasuredLine::MeasuredLine(Line line) : points_(std::move(line.points)), closed_(line.closed) {
  if (closed_ && !points_.empty()) points_.push_back(points_.front());
  double length = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i > 0) length += betwixt::length(points_[i] - points_[i - 1]);
    reached_.push_back(length);
  }
}

MeasuredLine::Place MeasuredLine::at(double share) const {
  const Vec3 ahead{1, 0, 0};
  if (points_.empty()) return {{}, ahead};
  const double all = length();
  if (!(all > 0)) return {points_.front(), ahead};
  if (closed_ && (share < 0 || share > 1)) share -= std::floor(share);
  const double way = share * all;
  // The first point not reached yet; pieces without a length are skipped.
  auto next = std::upper_bound(reached_.begin(), reached_.end(), way);
  if (next == reached_.end()) next = std::lower_bound(reached_.begin(), reached_.end(), all);
  if (next == reached_.begin()) next = std::upper_bound(reached_.begin(), reached_.end(), 0.0);
  const auto i = static_cast<std::size_t>(next - reached_.begin());
  const double piece = reached_[i] - reached_[i - 1];
  const Vec3 along = (1 / piece) * (points_[i] - points_[i - 1]);
  return {points_[i - 1] + (way - reached_[i - 1]) * along, along};
}

}  // namespace betwixt

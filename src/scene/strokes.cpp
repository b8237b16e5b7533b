// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/strokes.h"

#include <algorithm>
#include <cmath>

#include "scene/kinds.h"
#include "scene/primitives.h"

namespace betwixt {
namespace {

constexpr double longest_point = 4;  // of a corner, in widths
constexpr double gentle = 0.9;       // the cosine of turns without a corner
constexpr int disc_sides = 32;       // of a round corner, if it were a whole turn

// Returns the length along a line at each of its points; for a closed one, the total length at the end.
std::vector<double> places_along(const std::vector<Vec3>& line, bool closed) {
  std::vector<double> at{0};
  for (std::size_t i = 1; i < line.size() + (closed ? 1 : 0); ++i)
    at.push_back(at.back() + length(line[i % line.size()] - line[i - 1]));
  return at;
}

DrawnPart stretch_between(const std::vector<Vec3>& line, const std::vector<double>& at, double from, double to) {
  const auto point = [&](double where) {
    const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(at.begin(), at.end(), where) - at.begin(), 1,
                                                 static_cast<std::ptrdiff_t>(at.size()) - 1);
    const auto i = static_cast<std::size_t>(next);
    const double side = at[i] - at[i - 1], s = side > 0 ? std::clamp((where - at[i - 1]) / side, 0.0, 1.0) : 0;
    return (1 - s) * line[i - 1] + s * line[i % line.size()];
  };
  DrawnPart out;
  out.points.push_back(point(from));
  for (auto i = std::upper_bound(at.begin(), at.end(), from); i != at.end() && *i < to; ++i)
    out.points.push_back(line[static_cast<std::size_t>(i - at.begin()) % line.size()]);
  out.points.push_back(point(to));
  return out;
}

// A line with a width in a plane. Sides without length are left out.
class FlatStroke {
 public:
  FlatStroke(const DrawnPart& line, double width, bool round, Vec3 up)
      : up_(up), half_(width / 2), round_(round), closed_(line.closed) {
    const std::size_t n = line.points.size();
    for (std::size_t i = 0; i < n + (closed_ ? 1 : 0); ++i) {
      const Vec3 p = line.points[i % n];
      if (!points_.empty()) {
        const Vec3 left = cross(up, p - points_.back());
        if (!(length(left) > 1e-9 * width)) continue;
        left_.push_back(normalize(left)), long_.push_back(length(left));
      }
      points_.push_back(p);
    }
    if (left_.size() < 2) closed_ = false;
    if (closed_) points_.pop_back();  // the repeated first one
  }

  void areas(Contours& out) const {
    const std::size_t sides = left_.size();
    std::size_t first = 0;  // where a run of sides begins
    if (closed_) {
      while (first < sides && turns_gently(first)) ++first;
      if (first == sides) return go_round(out);
      if (const int turn = convex(); turn != 0)
        return turn > 0 ? go_round_convex(out) : reversed().go_round_convex(out);
    }
    for (std::size_t done = 0; done < sides;) {
      std::size_t run = 1;
      while (done + run < sides && turns_gently(first + done + run)) ++run;
      add_run(first + done, run, out);
      done += run;
      if (done < sides || closed_) add_corner(first + done, out);
    }
    if (!round_ || closed_) return;
    add_disc(points_.front(), out);
    if (sides > 0) add_disc(points_.back(), out);
  }

 private:
  Vec3 point(std::size_t i) const { return points_[i % points_.size()]; }
  Vec3 left(std::size_t side) const { return left_[side % left_.size()]; }  // of the side that begins at a point
  Vec3 left_before(std::size_t i) const { return left(i + left_.size() - 1); }

  // Returns whether the borders of the two sides at a point simply meet, the inner ones before their middles.
  bool turns_gently(std::size_t i) const {
    const double turn = dot(left_before(i), left(i));
    const double shorter = std::min(long_[i % left_.size()], long_[(i + left_.size() - 1) % left_.size()]);
    return turn >= gentle && half_ * std::sqrt(std::max(0.0, 1 - turn) / (1 + turn)) <= shorter / 2;
  }
  // Returns 1 if the line is closed, convex and anticlockwise, -1 if it is the same clockwise, and 0 otherwise.
  int convex() const {
    double sum = 0, least = 0, most = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec3 a = left_before(i), b = left(i);
      const double turn = std::atan2(dot(cross(a, b), up_), dot(a, b));
      sum += turn, least = std::min(least, turn), most = std::max(most, turn);
    }
    constexpr double straight = 1e-9;
    if (std::abs(std::abs(sum) - 2 * pi) > 1e-6) return 0;
    return least > -straight ? 1 : most < straight ? -1 : 0;
  }
  FlatStroke reversed() const {
    FlatStroke r = *this;
    std::reverse(r.points_.begin(), r.points_.end());
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t side = (2 * n - 2 - i) % n;  // the side between the points n - 1 - i and n - 2 - i
      r.left_[i] = -1 * left_[side], r.long_[i] = long_[side];
    }
    return r;
  }
  // The outer border, and the hole, if the stroke leaves any: what is farther than half a width from all sides.
  void go_round_convex(Contours& out) const {
    std::vector<Vec3> outer, hole = points_;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      add_outer_corner(i, outer);
      hole = inside(hole, point(i) + half_ * left(i), left(i));
    }
    out.push_back(std::move(outer));
    if (hole.size() < 3) return;
    std::reverse(hole.begin(), hole.end());
    out.push_back(std::move(hole));
  }
  // Adds the border at a corner of an anticlockwise line.
  void add_outer_corner(std::size_t i, std::vector<Vec3>& to) const {
    const Vec3 a = left_before(i), b = left(i), p = point(i);
    const double turn = dot(a, b);
    if (turn >= gentle || (!round_ && (1 + turn) / 2 >= 1 / (longest_point * longest_point))) {
      to.push_back(p - meeting(i));
      return;
    }
    const int steps =
        round_ ? static_cast<int>(std::ceil(std::acos(std::clamp(turn, -1.0, 1.0)) / (2 * pi / disc_sides))) : 1;
    const Vec3 across = cross(a, up_);  // a, turned to where b is
    for (int k = 0; k <= steps; ++k) {
      const double angle = std::acos(std::clamp(turn, -1.0, 1.0)) * k / steps;
      to.push_back(p - half_ * (std::cos(angle) * a - std::sin(angle) * across));
    }
  }
  // Returns the part of a convex polygon on the side of a line to which `normal` points.
  static std::vector<Vec3> inside(const std::vector<Vec3>& polygon, Vec3 on_line, Vec3 normal) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double in_p = dot(p - on_line, normal), in_q = dot(q - on_line, normal);
      if (in_p > 0) kept.push_back(p);
      if ((in_p > 0) != (in_q > 0)) kept.push_back(p + in_p / (in_p - in_q) * (q - p));
    }
    return kept;
  }
  // Returns the vector from a point to where the left borders of its two sides meet.
  Vec3 meeting(std::size_t i) const {
    const Vec3 a = left_before(i), b = left(i);
    return half_ / (1 + dot(a, b)) * (a + b);
  }
  void add_run(std::size_t first, std::size_t sides, Contours& out) const {
    std::vector<Vec3> shift{half_ * left(first)}, area;
    for (std::size_t i = 1; i < sides; ++i) shift.push_back(meeting(first + i));
    shift.push_back(half_ * left(first + sides - 1));
    for (std::size_t i = 0; i <= sides; ++i) area.push_back(point(first + i) - shift[i]);
    for (std::size_t i = sides + 1; i-- > 0;) area.push_back(point(first + i) + shift[i]);
    out.push_back(std::move(area));
  }
  void go_round(Contours& out) const {
    std::vector<Vec3> right, left;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      right.push_back(point(i) - meeting(i));
      left.push_back(point(i) + meeting(i));
    }
    std::reverse(left.begin(), left.end());
    out.push_back(std::move(right)), out.push_back(std::move(left));
  }
  // Adds the area between two sides on the outside of their turn.
  void add_corner(std::size_t i, Contours& out) const {
    if (round_) return add_disc(point(i), out);
    const Vec3 a = left_before(i), b = left(i), p = point(i);
    const double outside = dot(cross(a, b), up_) > 0 ? -half_ : half_;  // in a left turn the left side is the inner one
    std::vector<Vec3> area{p, p + outside * a};
    if ((1 + dot(a, b)) / 2 >= 1 / (longest_point * longest_point)) area.push_back(p + outside / half_ * meeting(i));
    area.push_back(p + outside * b);
    if (outside > 0) std::reverse(area.begin(), area.end());
    out.push_back(std::move(area));
  }

  void add_disc(Vec3 middle, Contours& out) const {
    const Vec3 across = left_.empty() ? any_side() : left_.front(), along = cross(across, up_);
    std::vector<Vec3> disc;
    for (int i = 0; i < disc_sides; ++i) {
      const double turn = 2 * pi * i / disc_sides;
      disc.push_back(middle + half_ * (std::cos(turn) * along + std::sin(turn) * across));
    }
    out.push_back(std::move(disc));
  }
  Vec3 any_side() const { return normalize(cross(up_, std::abs(up_.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})); }

  Vec3 up_;
  double half_;
  bool round_, closed_;
  std::vector<Vec3> points_, left_;
  std::vector<double> long_;
};

}  // namespace

Dashes dashes_of(const Shape& s) { return {s.dash, s.gap, s.trim_from, s.trim_to}; }

std::vector<std::pair<double, double>> drawn_parts(double length, const Dashes& dashes) {
  const double from = std::max(0.0, dashes.from) * length, to = std::min(1.0, dashes.to) * length;
  if (!(to > from)) return {};
  const double period = dashes.dash + dashes.gap;
  if (!(dashes.gap > 0) || !(length / period <= most_dashes)) return {{from, to}};
  std::vector<std::pair<double, double>> all;
  for (double k = std::floor(from / period); k * period < to; ++k) {
    const double begins = std::max(from, k * period), ends = std::min(to, k * period + dashes.dash);
    if (ends > begins || (dashes.dash == 0 && ends == begins)) all.emplace_back(begins, ends);
  }
  return all;
}

std::vector<DrawnPart> stretches(const std::vector<Vec3>& line, bool closed, const Dashes& dashes) {
  if (line.empty()) return {};
  if (dashes.whole()) return {{line, closed}};
  const std::vector<double> at = places_along(line, closed);
  std::vector<DrawnPart> all;
  for (const auto& [from, to] : drawn_parts(at.back(), dashes)) all.push_back(stretch_between(line, at, from, to));
  return all;
}

Pen pen_of(const Shape& s) {
  Pen pen{s.filled, 0, std::nullopt, {}, s.stroke_round};
  if (s.stroke.x >= 0 || s.stroke.y >= 0 || s.stroke.z >= 0) pen.color = s.stroke;
  if ((pen.color || !s.filled || s.stroke_graded) && sane(s.stroke_width)) pen.width = std::max(0.0, s.stroke_width);
  if (!row_of(s.kind).line) pen.dashes = dashes_of(s);
  return pen;
}

Pen between(const Pen& a, const Pen& b, double s) {
  const auto mixed = [s](double x, double y) { return (1 - s) * x + s * y; };
  Pen pen = s < 1 ? a : b;
  pen.width = std::max(0.0, mixed(a.width, b.width));
  if (a.width > 0 && b.width > 0) {
    if (a.color && b.color) pen.color = (1 - s) * *a.color + s * *b.color;
    pen.dashes = {mixed(a.dashes.dash, b.dashes.dash), mixed(a.dashes.gap, b.dashes.gap),
                  mixed(a.dashes.from, b.dashes.from), mixed(a.dashes.to, b.dashes.to)};
  } else {
    pen.color = a.width > 0 ? a.color : b.color, pen.dashes = a.width > 0 ? a.dashes : b.dashes;
  }
  return pen;
}

bool by_contours(const Shape& s) {
  const KindRow& row = row_of(s.kind);
  if (row.fill != Fill::surface || !row.contours) return row.fill == Fill::outline;
  return s.depth > 0 || !s.filled || pen_of(s).width > 0;
}

Vec3 facing(const Contours& contours) {
  Vec3 turn{}, first{}, far{}, side{};
  bool level = true, any = false;
  for (const auto& contour : contours)
    for (std::size_t i = 0; i < contour.size(); ++i) {
      if (!any) first = contour[i];
      any = true;
      level = level && contour[i].z == first.z;
      turn = turn + cross(contour[i] - first, contour[(i + 1) % contour.size()] - first);
      if (length(contour[i] - first) > length(far)) far = contour[i] - first;
    }
  if (level) return {0, 0, 1};
  // The area vector of a figure of eight is 0; any two directions in it will do.
  for (const auto& contour : contours)
    for (const Vec3 p : contour)
      if (const Vec3 s = cross(far, p - first); length(s) > length(side)) side = s;
  return normalize(length(turn) > 1e-6 * length(side) ? turn : side);
}

Contours stroke_areas(const Contours& contours, const Pen& pen, Vec3 up) {
  Contours areas;
  if (!(pen.width > 0)) return areas;
  for (const auto& contour : contours)
    for (const DrawnPart& s : stretches(contour, true, pen.dashes))
      FlatStroke(s, pen.width, pen.round, up).areas(areas);
  return areas;
}

Extent drawn_extent(const Contours& contours, const Shape& s) {
  const Pen pen = pen_of(s);
  Extent e;
  const auto add = [&e](const Contours& all) {
    for (const auto& contour : all)
      for (const Vec3 p : contour) e.add(p);
  };
  if (pen.fills) add(contours);
  if (pen.width > 0) add(stroke_areas(contours, pen, facing(contours)));
  if (!e.empty()) e.low.z -= s.depth / 2, e.high.z += s.depth / 2;
  return e;
}

}  // namespace betwixt

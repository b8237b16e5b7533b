// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/planar_drawn.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exchange/geometry.h"
#include "exchange/outline_morph.h"
#include "exchange/outlines.h"
#include "exchange/shapes.h"
#include "scene/kind_extents.h"
#include "scene/kinds.h"
#include "scene/primitives.h"
#include "scene/shape_blend.h"

namespace betwixt {
namespace {

constexpr std::size_t most_balls = 5000;  // of a point cloud
constexpr int around_ball = 24;

std::vector<DrawnPart> closed_parts(const Contours& contours) {
  std::vector<DrawnPart> out;
  for (const auto& contour : contours) out.push_back({contour, true});
  return out;
}

// Removes the repeated first point of a closed line.
DrawnPart without_end(DrawnPart part) {
  if (part.closed && part.points.size() > 1 && part.points.front() == part.points.back()) part.points.pop_back();
  return part;
}

// Returns the convex hull in the plane, anticlockwise (Andrew 1979).
std::vector<Vec3> hull_of(std::vector<Vec3> p) {
  std::sort(p.begin(), p.end(), [](Vec3 a, Vec3 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  const auto left = [](Vec3 a, Vec3 b, Vec3 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); };
  std::vector<Vec3> out;
  for (int way = 0; way < 2; ++way) {
    const std::size_t first = out.size();
    for (const Vec3 q : p) {
      while (out.size() >= first + 2 && left(out[out.size() - 2], out.back(), q) <= 1e-12) out.pop_back();
      out.push_back({q.x, q.y, 0});
    }
    if (!out.empty()) out.pop_back();
    std::reverse(p.begin(), p.end());
  }
  return out;
}

bool is_convex(Kind k) {
  return k == Kind::sphere || k == Kind::box || k == Kind::cylinder || k == Kind::cone || k == Kind::plane;
}
std::vector<Vec3> points_of(const Shape& s, const Mat4& seen_by) {
  const Geometry g = realise(s, Detail{128, true});
  std::vector<Vec3> out;
  for (const auto& p : g.mesh->positions) out.push_back(transform_point(seen_by * g.local, {p[0], p[1], p[2]}));
  return out;
}

Contours balls_of(const Shape& s) {
  Contours all;
  for (const Vec3 p : *s.points) {
    std::vector<Vec3> ball;
    for (int i = 0; i < around_ball; ++i) {
      const double turn = 2 * pi * i / around_ball;
      ball.push_back(p + s.width / 2 * Vec3{std::cos(turn), std::sin(turn), 0});
    }
    all.push_back(std::move(ball));
  }
  return all;
}

struct FlatDrawn {
  Contours contours;
  Pen pen;
};
void add_flat(const FlatDrawn& flat, const Mat4* seen_by, PlanarDrawn& to) {
  if (flat.pen.fills) to.filled = closed_parts(flat.contours);
  to.color = flat.pen.color, to.round = flat.pen.round;
  if (!(flat.pen.width > 0)) return;
  // Seen at an angle, a stroke has no constant width.
  if (seen_by != nullptr) {
    to.bordered = closed_parts(stroke_areas(flat.contours, flat.pen, facing(flat.contours)));
    return;
  }
  to.width = flat.pen.width;
  const bool dashed = flat.pen.dashes.gap > 0;
  if (!dashed) to.from = flat.pen.dashes.from, to.to = flat.pen.dashes.to;
  for (const auto& contour : flat.contours)
    for (DrawnPart& part : dashed ? stretches(contour, true, flat.pen.dashes) : std::vector<DrawnPart>{{contour, true}})
      to.stroked.push_back(without_end(std::move(part)));
}

void add_line(const Shape& s, bool round, PlanarDrawn& to) {
  to.width = s.width, to.round = round, to.hairline = !(s.width > 0);
  const Line line = line_of(s);
  const Dashes dashes = dashes_of(s);
  if (dashes.gap > 0) {
    to.stroked = stretches(line.points, line.closed, dashes);
  } else if (!line.points.empty()) {
    to.from = dashes.from, to.to = dashes.to;
    to.stroked.push_back(without_end({line.points, line.closed}));
  }
}

// An arc whose ends move is a line with a width; as an outline its number of points would grow.
bool is_bow(const Shape& s) {
  return s.kind == Kind::arc && s.filled && !(s.depth > 0) && !(pen_of(s).width > 0) && !(s.gap > 0) && s.width > 0 &&
         s.radius > s.width / 2;
}

void each_drawn_part(PlanarDrawn& d, auto what) {
  for (auto* parts : {&d.filled, &d.bordered, &d.stroked})
    for (DrawnPart& part : *parts) what(part);
}

bool same_parts(const std::vector<DrawnPart>& a, const std::vector<DrawnPart>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const DrawnPart& p, const DrawnPart& q) {
    return p.closed == q.closed && p.points.size() == q.points.size();
  });
}
bool equal_parts(const std::vector<DrawnPart>& a, const std::vector<DrawnPart>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const DrawnPart& p, const DrawnPart& q) {
    return p.closed == q.closed && p.points == q.points;
  });
}
double most_off(const std::vector<DrawnPart>& a, const std::vector<DrawnPart>& b, double s,
                const std::vector<DrawnPart>& there) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < a[i].points.size(); ++k)
      most = std::max(most, length((1 - s) * a[i].points[k] + s * b[i].points[k] - there[i].points[k]));
  return most;
}

// Returns whether both have the same letters, possibly in several forms.
bool one_thing(const Shape& a, const Shape& b) {
  return a.kind == b.kind && a.filled == b.filled && a.letters == b.letters && *a.text == *b.text &&
         *a.font == *b.font && a.own_font == b.own_font && a.formula == b.formula;
}

}  // namespace

bool PlanarDrawn::looks_like(const PlanarDrawn& b) const {
  return width == b.width && from == b.from && to == b.to && round == b.round && color == b.color &&
         (gradients == b.gradients || (gradients && b.gradients && *gradients == *b.gradients)) &&
         equal_parts(filled, b.filled) && equal_parts(bordered, b.bordered) && equal_parts(stroked, b.stroked);
}

std::size_t PlanarDrawn::numbers() const {
  std::size_t sum = 0;
  for (const auto* parts : {&filled, &bordered, &stroked})
    for (const DrawnPart& part : *parts) sum += 2 * part.points.size();
  return sum;
}

std::optional<PlanarDrawn> drawn_of(const std::shared_ptr<const Shape>& shape,
                                    const std::shared_ptr<const Shape>& toward, double blend, const Mat4* seen_by) {
  PlanarDrawn out;
  out.shape = shape, out.toward = toward;
  Shape mixed;
  const Shape* s = shape.get();
  std::optional<FlatDrawn> flat;
  if (toward && !(*shape == *toward) && std::isfinite(blend)) {
    const bool by_measures = !by_contours(*shape) && !by_contours(*toward) && one_topology(*shape, *toward) &&
                             row_of(shape->kind).fill != Fill::file;
    if (by_measures) {
      mixed = sum_of(std::array{ShapeShare{shape.get(), 1 - blend}, ShapeShare{toward.get(), blend}}), s = &mixed;
    } else if (has_outline(*shape) && has_outline(*toward)) {
      const double share = std::clamp(blend, 0.0, 1.0);
      flat =
          FlatDrawn{contours_between(*shape, *toward, share).contours, between(pen_of(*shape), pen_of(*toward), share)};
    } else if (blend >= 1) {
      s = toward.get();
    }
  }
  const KindRow& row = row_of(s->kind);
  if (!flat && ((row.line && !row.contours) || is_bow(*s))) {
    add_line(*s, !is_bow(*s), out);
  } else if (!flat && is_convex(s->kind)) {
    const std::vector<Vec3> hull = hull_of(points_of(*s, seen_by != nullptr ? *seen_by : Mat4{}));
    if (hull.size() > 2) out.filled = {{hull, true}};
    return out;
  } else if (!flat && (s->kind == Kind::points || s->kind == Kind::scatter)) {
    if (s->points->size() > most_balls) return std::nullopt;
    out.filled = closed_parts(balls_of(*s));
  } else {
    if (!flat && !has_outline(*s)) return std::nullopt;
    if (!flat) flat = FlatDrawn{outline_of(*s).contours, pen_of(*s)};
    // Players would fill holes that reach beyond their contour.
    if (!s->holes->empty() && !flat->contours.empty() && flat->pen.fills) {
      const std::vector<DrawnPart> whole = closed_parts(flat->contours);
      Contours clean;
      for (Island& island : islands(flat->contours, Winding::positive)) {
        clean.push_back(std::move(island.outer));
        for (auto& hole : island.holes) clean.push_back(std::move(hole));
      }
      add_flat(*flat, seen_by, out);
      // Such a hole changes the contours; otherwise they keep their points.
      std::size_t before = 0, after = 0;
      for (const auto& c : flat->contours) before += c.size();
      for (const auto& c : clean) after += c.size();
      if (before != after) out.filled = closed_parts(clean);
    } else {
      add_flat(*flat, seen_by, out);
    }
  }
  if (seen_by != nullptr) carry(out, *seen_by);
  each_drawn_part(out, [](DrawnPart& part) {
    for (Vec3& p : part.points) p.z = 0;
  });
  return out;
}

void carry(PlanarDrawn& d, const Mat4& m) {
  each_drawn_part(d, [&](DrawnPart& part) {
    for (Vec3& p : part.points) p = transform_point(m, p), p.z = 0;
  });
  d.width *= std::cbrt(std::abs(determinant(m)));
}

double front_of(const Shape& s) {
  const KindRow& row = row_of(s.kind);
  if (s.kind == Kind::box) return s.size.z / 2;
  if (s.kind == Kind::sphere || s.kind == Kind::cylinder || s.kind == Kind::cone) return 0.7 * s.radius;
  // From the front, seven tenths of a point's width are above that height. Lines are flat in a drawing.
  if (s.kind == Kind::points) return 0.35 * std::max(0.0, s.width);
  return row.deep ? std::max(0.0, s.depth) / 2 : 0;
}

bool goes_over(const PlanarDrawn& a, const PlanarDrawn& b) {
  if (!same_parts(a.filled, b.filled) || !same_parts(a.bordered, b.bordered) || !same_parts(a.stroked, b.stroked))
    return false;
  if (!a.toward && !b.toward) return a.shape == b.shape || one_thing(*a.shape, *b.shape);
  if (a.toward && b.toward && a.shape && b.shape) return *a.shape == *b.shape && *a.toward == *b.toward;
  return a.looks_like(b);
}

double off_between(const PlanarDrawn& a, const PlanarDrawn& b, double s, const PlanarDrawn& there) {
  return std::max({most_off(a.filled, b.filled, s, there.filled), most_off(a.bordered, b.bordered, s, there.bordered),
                   most_off(a.stroked, b.stroked, s, there.stroked)});
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/svg_outlines.h"

#include <algorithm>
#include <cmath>

#include "exchange/outlines.h"

namespace betwixt {
namespace {

void append_ring(std::vector<Vec3>& rings, const Contour& ring) {
  rings.insert(rings.end(), ring.begin(), ring.end());
  rings.push_back(ring[0]);
}

DrawnThing with_stroke(DrawnThing thing, const SvgLook& look) {
  thing.strokes = true;
  thing.stroke = look.stroke.color, thing.stroke_width = look.width;
  thing.round = look.round, thing.dash = {look.dash, look.gap, 0};
  return thing;
}

DrawnThing filled(const SvgLook& look) {
  DrawnThing thing;
  thing.color = look.fill.color;
  thing.transparency = 1 - look.fill.opacity;
  return thing;
}

// Returns the path's share in the length that includes the way back to the first point.
double share_of_open(const Contour& points) {
  double length_open = 0;
  for (std::size_t i = 1; i < points.size(); ++i) length_open += length(points[i] - points[i - 1]);
  const double back = length(points[0] - points.back());
  return length_open > 0 ? length_open / (length_open + back) : 1;
}

void lengthen(Contour& points, double by) {
  const auto beyond = [by](Vec3 end, Vec3 before) { return end + by * normalize(end - before); };
  const Vec3 first = beyond(points[0], points[1]);
  points.back() = beyond(points.back(), points[points.size() - 2]);
  points[0] = first;
}

// All closed strokes become one object, because they are one area, and all open ones another. An open stroke goes
// there and back, and is trimmed to the first half.
std::vector<DrawnThing> stroked(const std::vector<Flattener::Run>& runs, const SvgLook& look) {
  std::vector<DrawnThing> out;
  if (!look.stroke.there) return out;
  DrawnThing closed = with_stroke({}, look);
  closed.fills = closed.strokes = false;  // its fill has the stroke's colour
  closed.color = look.stroke.color;
  closed.transparency = 1 - look.stroke.opacity;
  DrawnThing open = closed;
  open.trim_to = 0.5;
  for (const auto& run : runs) {
    Contour points = run.points;
    if (points.size() < 2) continue;
    if (look.square && !run.closed) lengthen(points, look.width / 2);
    if (points.size() == 2) points.insert(points.begin() + 1, 0.5 * (points[0] + points[1]));
    DrawnThing& to = run.closed ? closed : open;
    if (!run.closed)
      for (std::size_t i = points.size() - 1; i-- > 1;) points.push_back(points[i]);
    if (to.points.empty())
      to.points = std::move(points);
    else
      append_ring(to.holes, points);
  }
  for (DrawnThing* thing : {&closed, &open})
    if (!thing->points.empty()) out.push_back(std::move(*thing));
  return out;
}

void grow(Vec3& low, Vec3& high, Vec3 p) {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
}

}  // namespace

std::vector<DrawnThing> outlined(const std::vector<Flattener::Run>& runs, const SvgLook& look) {
  std::vector<DrawnThing> out;
  Contours closed;
  std::size_t points = 0;
  bool all_closed = true;
  for (const auto& run : runs) {
    if (run.points.size() > 2) closed.push_back(run.points), points += run.points.size();
    all_closed = all_closed && run.closed && run.points.size() > 2;
  }
  if (!look.fill.there) return stroked(runs, look);
  const std::vector<Island> all = islands(closed, look.even_odd ? Winding::odd : Winding::nonzero);
  std::size_t left = 0;  // of the points: all of them, if no lines cross
  for (const Island& island : all) {
    left += island.outer.size();
    for (const Contour& hole : island.holes) left += hole.size();
  }
  const bool as_it_is = left == points, one = as_it_is && runs.size() == 1 && all.size() == 1;
  const bool both =
      look.stroke.there && look.stroke.opacity == look.fill.opacity && as_it_is && !look.square && (all_closed || one);
  for (const Island& island : all) {
    DrawnThing thing = filled(look);
    thing.points = island.outer;
    for (const Contour& hole : island.holes) append_ring(thing.holes, hole);
    if (both) thing = with_stroke(std::move(thing), look);
    out.push_back(std::move(thing));
  }
  if (one) {  // keeps the start of the path, where its drawing begins
    out[0].points = runs[0].points;
    if (both && !runs[0].closed) out[0].trim_to = share_of_open(runs[0].points);
  }
  if (look.stroke.there && !both)
    for (DrawnThing& thing : stroked(runs, look)) out.push_back(std::move(thing));
  return out;
}

void place_in_middles(std::vector<DrawnThing>& all) {
  const double thick = std::min(1e-3, 0.1 / static_cast<double>(all.size()));
  std::vector<Vec3> low(all.size(), Vec3{INFINITY, INFINITY, 0}), high(all.size(), Vec3{-INFINITY, -INFINITY, 0});
  for (std::size_t i = all.size(); i-- > 0;) {
    for (const Vec3 p : all[i].points) grow(low[i], high[i], p);
    const std::uint32_t above = all[i].above;
    if (above == DrawnThing::nothing) continue;
    grow(low[above], high[above], low[i]), grow(low[above], high[above], high[i]);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec3 middle = 0.5 * (low[i] + high[i]);
    all[i].at = {middle.x, middle.y, all[i].group ? 0 : static_cast<double>(i) * thick};
    for (Vec3& p : all[i].points) p = p - middle;
    for (Vec3& p : all[i].holes) p = p - middle;
  }
  for (std::size_t i = all.size(); i-- > 0;)
    if (all[i].above != DrawnThing::nothing) all[i].at = all[i].at - all[all[i].above].at;
}

}  // namespace betwixt

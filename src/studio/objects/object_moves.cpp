// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Edits that move whole objects: aligned, distributed, shifted with their events, falling.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "betwixt/language.h"
#include "betwixt/math.h"
#include "betwixt/object.h"
#include "betwixt/pick.h"
#include "betwixt/track.h"
#include "editor/made_by.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/objects/object_lines.h"
#include "studio/viewport/hand.h"

namespace betwixt::studio {
namespace {

double& along(Vec3& v, Axis a) { return a == Axis::x ? v.x : a == Axis::y ? v.y : v.z; }

// Returns the lines that move an object by so much along an axis of the world.
void add_move(const Program& program, ObjectId id, Axis axis, double by, Time t, bool make_events, Lines& to) {
  Vec3 way{};
  along(way, axis) = by;
  for (std::string& line : Hand(program, t, {id}, make_events).move(way, millimetre)) to.push_back(std::move(line));
}

}  // namespace

Lines align_lines(const Program& program, const std::vector<ObjectId>& objects, Axis axis, Time t, bool make_events) {
  Lines lines;
  if (objects.size() < 2) return lines;
  Vec3 to = place_of(program, objects.back(), t);
  for (const ObjectId id : objects) {
    Vec3 at = place_of(program, id, t);
    if (!(id == objects.back())) add_move(program, id, axis, along(to, axis) - along(at, axis), t, make_events, lines);
  }
  return lines;
}

Lines distribute_lines(const Program& program, const std::vector<ObjectId>& objects, Axis axis, Time t,
                       bool make_events) {
  Lines lines;
  if (objects.size() < 3) return lines;
  std::vector<std::pair<double, ObjectId>> all;
  for (const ObjectId id : objects) {
    Vec3 at = place_of(program, id, t);
    all.emplace_back(along(at, axis), id);
  }
  std::ranges::stable_sort(all, {}, &std::pair<double, ObjectId>::first);
  const double first = all.front().first, step = (all.back().first - first) / static_cast<double>(all.size() - 1);
  for (std::size_t i = 1; i + 1 < all.size(); ++i)
    add_move(program, all[i].second, axis, first + step * static_cast<double>(i) - all[i].first, t, make_events, lines);
  return lines;
}

Lines lines_to_shift(const Program& program, ObjectId id, const Mat4& from, const Mat4& to, Time t) {
  const Document& d = program.document();
  const ObjectId above = parent_at(d, id, t);
  const Value up = above ? program.read(Target(above, Query::world), t) : Value(Matrix(Mat4{}));
  const auto* parent = std::get_if<Matrix>(&up);
  const auto back = parent ? inverse(**parent) : std::nullopt, undone = inverse(from);
  if (!back || !undone) return {};
  const Mat4 change = *back * to * *undone * **parent;
  for (int c = 0; c < 3; ++c) {
    Vec3 unit{};
    unit[c] = 1;
    if (length(column(change, c) - unit) > 1e-9) return {};
  }
  const Target whole(id, fn::position);
  const Vec3 by = translation_of(change);
  const auto number = [](double v) { return write_number(rounded(v, 1e-6)); };
  const auto vector = [&](Vec3 v) { return fmt::format("({} {} {})", number(v.x), number(v.y), number(v.z)); };
  const Value now = program.read(whole, t);
  const auto* place = std::get_if<Vec3>(&now);
  if (!place || !made_by(d, whole, t).code.empty()) return {};
  Lines lines;
  bool keyed[3] = {};
  for (const TrackView& track : tracks(d, whole)) {
    if (track.event_count == 0 || track.target.velocity || track.target.layer) continue;
    const int c = track.target.component;
    for (int i = 0; i < 3; ++i) keyed[i] = keyed[i] || c < 0 || c == i;
    if (c < 0 || by[c] != 0)
      lines.push_back(fmt::format("translate {} {}..{} {}", d.name(track.target), format_time(track.first, d),
                                  format_time(track.last, d), c < 0 ? vector(by) : number(by[c])));
  }
  if (!keyed[0] && !keyed[1] && !keyed[2]) return {fmt::format("set {} {}", d.name(whole), vector(*place + by))};
  for (int c = 0; c < 3; ++c)
    if (!keyed[c] && std::abs(by[c]) > 1e-9)
      lines.push_back(fmt::format("set {} {}", d.name(Target(id, fn::position, c)), number((*place)[c] + by[c])));
  return lines;
}

Lines fall_lines(const Program& program, const std::vector<ObjectId>& objects, Time t) {
  const Document& d = program.document();
  const Frame frame = program.frame(t);
  Lines lines;
  for (const ObjectId id : objects) {
    if (!placed(kind(d, id))) continue;
    // Its position stops where its lowest point is on the floor.
    double lowest = place_of(program, id, t).y;
    for (const Item& item : frame.items)
      if (item.id == id)
        for (const Vec3& corner : drawn(item).corners) lowest = std::min(lowest, corner.y);
    const double above = rounded(place_of(program, id, t).y - lowest, millimetre);
    lines.push_back(
        fmt::format("at {} fall {} ground={} bounce=0.6", format_time(t, d), d.name(id), write_number(above)));
  }
  return lines;
}

}  // namespace betwixt::studio

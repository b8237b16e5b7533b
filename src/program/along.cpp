// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/along.h"

#include <fmt/format.h>

#include "program/placing.h"
#include "scene/line.h"

namespace betwixt {

namespace {

// Returns the point at a fraction of the length of an object's line, in world space, or nullopt if there is no line.
std::optional<MeasuredLine::Place> on_line(const Program::Compiled& c, ObjectId road, double share, Time t,
                                           Asking& asking) {
  if (!find_object(c.document.scene(), road) || c.node_of[road.index] == ObjectId::nothing) return std::nullopt;
  Line line = line_of(c.shape(road.index, t, nullptr, asking));
  asking.work(20 + line.points.size());
  if (line.points.empty()) return std::nullopt;
  const Mat4 world = placement(c, c.node_of[road.index], t, asking).in_world();
  for (Vec3& p : line.points) p = transform_point(world, p);
  return MeasuredLine(std::move(line)).at(share);
}

}  // namespace

Result<Vec3> place_on(const Program::Compiled& c, std::string_view road, double share, double seconds, Asking& asking) {
  if (!(std::abs(seconds) <= longest_seconds) || !std::isfinite(share))
    return fail(ErrorCode::range, fmt::format("place('{}', {}): the place or the time is out of range", road, share));
  const ObjectId id = c.document.find(road);
  if (!id) return fail(ErrorCode::name, fmt::format("place('{}', …): there is no object '{}'", road, road));
  const auto place = on_line(c, id, share, from_seconds(seconds), asking);
  if (!place)
    return fail(ErrorCode::type, fmt::format("place('{}', …): '{}' is not a line, or has no length", road, road));
  return place->point;
}

std::optional<Value> value_along(const Program::Compiled& c, std::uint32_t object, FunctionId f, ObjectId road,
                                 double share, Time t, Asking& asking) {
  const auto place = on_line(c, road, share, t, asking);
  const auto name = [&] { return c.document.name(Target{{object}, f, -1}); };
  if (!place) {
    const Object* there = find_object(c.document.scene(), road);
    return asking.say(name(), fmt::format(" follows {}: it keeps its value from before",
                                          there ? fmt::format("'{}', which has no length", there->name)
                                                : "a line that no longer exists")),
           std::nullopt;
  }
  const Node& n = c.nodes[c.node_of[object]];
  const Carrier by = carrier_of(c, n, t, asking);
  if (f == fn::rotation) return normalize(conjugate(by.turn) * turned_to(c, n, place->direction, t, asking));
  const auto seen = by.seen(place->point);
  if (!seen) asking.say(name(), " has a parent with a scale of 0");
  return seen ? std::optional<Value>(*seen) : std::nullopt;
}

}  // namespace betwixt

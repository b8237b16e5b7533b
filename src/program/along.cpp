// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Objects that move along a line: where the line is, in the space of their positions.
#include "track/along.h"

#include <fmt/format.h>

#include "program/compiled.h"
#include "program/facing.h"
#include "program/placing.h"
#include "scene/line.h"

namespace betwixt {

// Like hang(), for a position and a rotation only. It must not read the object's own values: one of them may be the
// value that is being evaluated.
Carrier Program::Compiled::carried(const Node& n, Time t, Asking& asking) const {
  Carrier out;
  if (!span(n, t)) {
    if (n.around >= 0) out.above = product(n.around, t);
    return out;
  }
  const CompiledSpan span = held(node_of[n.object], t, asking);
  if (span.frozen >= 0) thaw(span.frozen, asking);
  const Frozen* const kept = span.frozen >= 0 ? &frozen[static_cast<std::size_t>(span.frozen)] : nullptr;
  Mat4 around;
  Quat turn;
  if (span.kind >= AttachmentKind::hang) {
    const Sited parent = placement(static_cast<std::uint32_t>(span.parent), t, asking);
    double x[4] = {};
    evaluate(find(n.object, fn::attach_position), t, asking, x);
    around = parent.around, out.above = parent.world, out.attach = vec3(x);
    if (span.kind != AttachmentKind::hang) turn = parent.turn;
  } else if (kept && kept->held) {
    around = kept->around, out.above = kept->parent, out.attach = kept->attach, turn = kept->parent_turn;
  }
  if (n.around >= 0) around = around * product(n.around, t);
  out.above = around * out.above;
  if (kept) out.kept = kept->before, turn = turn * kept->before_turn;
  out.turn = turn;
  return out;
}

std::optional<Vec3> Carrier::seen(Vec3 in_world) const {
  const auto back = inverse(above), out = inverse(kept);
  if (!back || !out) return std::nullopt;
  return transform_point(*out, transform_point(*back, in_world) - attach);
}

std::optional<MeasuredLine::Place> Program::Compiled::on_line(ObjectId road, double share, Time t,
                                                              Asking& asking) const {
  if (!find_object(document.scene(), road) || node_of[road.index] == ObjectId::nothing) return std::nullopt;
  Line line = line_of(shape(road.index, t, nullptr, asking));
  asking.work(20 + line.points.size());
  if (line.points.empty()) return std::nullopt;
  const Mat4 world = placement(node_of[road.index], t, asking).in_world();
  for (Vec3& p : line.points) p = transform_point(world, p);
  return MeasuredLine(std::move(line)).at(share);
}

Result<Vec3> Program::Compiled::place_on(std::string_view road, double share, double seconds, Asking& asking) const {
  if (!(std::abs(seconds) <= longest_seconds) || !std::isfinite(share))
    return fail(ErrorCode::range, fmt::format("place('{}', {}): the place or the time is out of range", road, share));
  const ObjectId id = document.find(road);
  if (!id) return fail(ErrorCode::name, fmt::format("place('{}', …): there is no object '{}'", road, road));
  const auto place = on_line(id, share, from_seconds(seconds), asking);
  if (!place)
    return fail(ErrorCode::type, fmt::format("place('{}', …): '{}' is not a line, or has no length", road, road));
  return place->point;
}

std::optional<Value> Program::Compiled::along(std::uint32_t object, FunctionId f, ObjectId road, double share, Time t,
                                              Asking& asking) const {
  const auto place = on_line(road, share, t, asking);
  const auto name = [&] { return document.name(Target{{object}, f, -1}); };
  if (!place) {
    const Object* there = find_object(document.scene(), road);
    return asking.say(fmt::format(
               "{} follows {}: it keeps its value from before", name(),
               there ? fmt::format("'{}', which has no length", there->name) : "a line that no longer exists")),
           std::nullopt;
  }
  const Node& n = nodes[node_of[object]];
  const Carrier by = carried(n, t, asking);
  if (f == fn::rotation) return normalize(conjugate(by.turn) * turned(n, place->direction, t, asking));
  const auto seen = by.seen(place->point);
  if (!seen) asking.say(fmt::format("{} has a parent with a scale of 0", name()));
  return seen ? std::optional<Value>(*seen) : std::nullopt;
}

Quat Program::Compiled::turned(const Node& n, Vec3 direction, Time t, Asking& asking) const {
  const Value said = value(find(n.object, fn::front), t, asking);
  const auto* word = std::get_if<Text>(&said);
  Front front = n.kind == Kind::camera ? Front::minus_z : Front::x;
  for (std::size_t i = 0; word && i < front_names.size(); ++i)
    if (**word == front_names[i]) front = static_cast<Front>(i);
  return facing(direction, front, document.scene().appearance.flat);
}

}  // namespace betwixt

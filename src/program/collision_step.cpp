// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/collision_step.h"

#include <algorithm>
#include <cmath>

#include "scene/document.h"

namespace betwixt {
namespace {

struct StepMaker {
  const Program::Compiled& c;
  const std::uint32_t object;
  Asking& asking;

  void add_obstacle(CollisionStep& s, ObjectId id) const {
    constexpr std::size_t most = 1000;
    if (id.index == object || s.obstacles.size() >= most) return;
    const std::uint32_t node = c.node_of[id.index];
    if (node == ObjectId::nothing || !c.draws(node)) return;
    asking.note_read(Target{id, fn::position});
    asking.work(100);
    const auto at = [&](Time t) {
      return body_of(*c.drawn_shape(node, t, asking), placement(c, node, t, asking).in_world());
    };
    const auto first = at(s.from), last = at(s.until);
    if (!first || !last) return;
    CollisionStep::Obstacle o{{*first, *last}};
    o.moves = !same(*first, *last);
    s.obstacles.push_back(o);
  }

  // Returns the object's own body relative to its place. Its rotation and scale are those of its tracks; what it looks
  // at, and what bends it, would need its place.
  std::optional<Body> own_body(std::uint32_t node, Time t, const Carrier& carrier) const {
    if (!c.draws(node)) return std::nullopt;
    const Node& n = c.nodes[node];
    const auto shape = c.drawn_shape(node, t, asking);
    double x[4] = {};
    const auto three = [&](FunctionId f) {
      c.evaluate(c.find(n.object, f), t, asking, x);
      return vec3(x);
    };
    Mat4 own;
    if (shape->kind != Kind::sphere) {
      three(fn::rotation);
      own = rotation(n.orientation ? Quat{x[0], x[1], x[2], x[3]} : from_angles(vec3(x)));
    }
    const Vec3 scale = three(fn::scale), pivot = three(fn::pivot);
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) own(i, k) *= scale[k];
    const Mat4 by = linear_part(carrier.above) * linear_part(carrier.kept);
    const CompiledSpan span = held(c, node, t, asking);
    const Mat4 turn =
        span.kind == AttachmentKind::couple || span.kind == AttachmentKind::letgo ? by : rotation(carrier.turn);
    const Vec3 moved = transform_vector(by, pivot - transform_vector(own, pivot));
    Mat4 world = turn * own;
    world(0, 3) = moved.x, world(1, 3) = moved.y, world(2, 3) = moved.z;
    return body_of(*shape, world);
  }
};

CollisionLaw law_of(const Value& v) {
  const auto* word = std::get_if<Text>(&v);
  if (!word || **word == "stop") return CollisionLaw::stop;
  return **word == "slide" ? CollisionLaw::slide : **word == "bounce" ? CollisionLaw::bounce : CollisionLaw::mirror;
}

}  // namespace

Vec3 CollisionStep::in_world(Vec3 position, std::int64_t flicks) const {
  const auto by = [&](const Carrier& k) {
    return transform_point(k.above, transform_point(k.kept, position) + k.attach);
  };
  const Vec3 a = by(carriers[0]);
  return carried_still ? a : a + share(flicks) * (by(carriers[1]) - a);
}

Clearance CollisionStep::gap(std::size_t i, Vec3 place, std::int64_t flicks) const {
  Body moved = turns ? between(own[0], own[1], share(flicks)) : own[0];
  moved.middle = moved.middle + place;
  const Obstacle& o = obstacles[i];
  return gap_between(moved, o.moves ? between(o.ends[0], o.ends[1], share(flicks)) : o.ends[0]);
}

double CollisionStep::turning(std::size_t i) const {
  const auto of = [](const Body& a, const Body& b) {
    double most = std::abs(a.radius - b.radius) + betwixt::length(a.half - b.half);
    for (std::size_t k = 0; k < 3; ++k) most += betwixt::length(a.axes[k] - b.axes[k]) * betwixt::length(a.half);
    return most;
  };
  return of(obstacles[i].ends[0], obstacles[i].ends[1]) + (turns ? of(own[0], own[1]) : 0);
}

Vec3 CollisionStep::velocity_of(std::size_t i) const {
  const Obstacle& o = obstacles[i];
  return o.moves ? (1 / length.seconds()) * (o.ends[1].middle - o.ends[0].middle) : Vec3{};
}

CollisionStep collision_step(const Program::Compiled& c, const Live& live, Time from, Asking& asking) {
  CollisionStep s;
  s.from = from, s.until = from + CollisionStep::length;
  const std::uint32_t node = c.node_of[live.object];
  const StepMaker maker{c, live.object, asking};
  for (int end = 0; end < 2; ++end) s.carriers[end] = carrier_of(c, c.nodes[node], end ? s.until : from, asking);
  const Carrier &a = s.carriers[0], &b = s.carriers[1];
  s.carried_still = a.above == b.above && a.kept == b.kept && a.attach == b.attach;
  const Value names = c.value(c.find(live.object, fn::obstacles), from, asking);
  if (const auto* all = std::get_if<Names>(&names))
    for (const std::string& name : **all)
      for (const ObjectId id : select(c.document.scene(), name)) maker.add_obstacle(s, id);
  s.law = law_of(c.value(c.find(live.object, fn::collision), from, asking));
  double kept[4] = {1};
  c.evaluate(c.find(live.object, fn::bounciness), from, asking, kept);
  s.kept = std::clamp(kept[0], 0.0, 1.0);
  if (s.obstacles.empty()) return s;
  const auto first = maker.own_body(node, from, a), last = maker.own_body(node, s.until, b);
  if (!first || !last) return s.obstacles.clear(), s;
  s.own[0] = *first, s.own[1] = *last, s.turns = !same(*first, *last);
  return s;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Transforms: parents, releases and look-at.
#include <algorithm>
#include <cmath>

#include "program/evaluator.h"
#include "program/facing.h"
#include "program/needed.h"
#include "program/placing.h"

namespace betwixt {
namespace {

// Scales and rotates about the pivot, then translates.
Mat4 local(const OwnTransform& said) {
  Mat4 m = rotation(said.turn);
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) m(i, c) *= said.scale[c];
  const Vec3 move = said.position + said.pivot - transform_vector(m, said.pivot);
  m(0, 3) = move.x, m(1, 3) = move.y, m(2, 3) = move.z;
  if (said.own) m = m * *said.own;
  return said.motion ? *said.motion * m : m;
}

Mat4 held_turn(AttachmentKind kind, const Placed& parent) {
  return kind == AttachmentKind::couple   ? linear_part(parent.world)
         : kind == AttachmentKind::attach ? rotation(parent.turn)
                                          : Mat4{};
}

}  // namespace

Quat turn_of(const Mat4& m) {
  Mat4 r;
  for (int c = 0; c < 3; ++c) {
    const Vec3 axis = normalize({m(0, c), m(1, c), m(2, c)}, {c == 0 ? 1.0 : 0, c == 1 ? 1.0 : 0, c == 2 ? 1.0 : 0});
    r(0, c) = axis.x, r(1, c) = axis.y, r(2, c) = axis.z;
  }
  return from_matrix(r);
}

Placed own_place(const OwnTransform& said) {
  Quat turn = said.own ? said.turn * turn_of(*said.own) : said.turn;
  if (said.motion) turn = turn_of(*said.motion) * turn;
  return {local(said), turn};
}

Placed hang(const Placed& own, Vec3 attach, const CompiledSpan* span, const Frozen* frozen, const Placed* parent) {
  if (!span || span->kind == AttachmentKind::detach || (span->kind == AttachmentKind::letgo && !frozen->held))
    return own;
  Placed kept;
  if (frozen) kept = {frozen->before * own.world, frozen->before_turn * own.turn};
  const Placed& from = frozen ? kept : own;
  const bool let_go = span->kind == AttachmentKind::letgo;
  if (let_go) attach = frozen->attach;
  const Vec3 place = transform_point(let_go ? frozen->parent : parent->world, translation_of(from.world) + attach);
  Placed p{linear_product(let_go ? frozen->turn3 : held_turn(span->kind, *parent), from.world), from.turn};
  if (span->kind != AttachmentKind::hang) p.turn = (let_go ? frozen->parent_turn : parent->turn) * from.turn;
  p.world(0, 3) = place.x, p.world(1, 3) = place.y, p.world(2, 3) = place.z;
  return p;
}

OwnTransform said_by(const Node& n, const double* numbers) {
  const double* r = numbers + n.rotation;
  return {n.orientation ? Quat{r[0], r[1], r[2], r[3]} : from_angles(vec3(r)),
          vec3(numbers + n.scale),
          vec3(numbers + n.pivot),
          vec3(numbers + n.position),
          vec3(numbers + n.attach),
          {},
          {}};
}

OwnTransform own_transform_at(const Program::Compiled& compiled, const Node& n, Time t, Asking& asking, bool turned) {
  double x[4] = {};
  const auto numbers = [&](FunctionId f) {
    compiled.evaluate(compiled.find(n.object, f), t, asking, x);
    return vec3(x);
  };
  OwnTransform said;
  said.scale = {1, 1, 1};
  if (turned || !turns_in_place(compiled, n)) {
    numbers(fn::rotation);
    said.turn = n.orientation ? Quat{x[0], x[1], x[2], x[3]} : from_angles(vec3(x));
    said.scale = numbers(fn::scale);
  }
  said.pivot = numbers(fn::pivot), said.position = numbers(n.on_axes ? fn::placed : fn::position);
  said.attach = numbers(fn::attach_position);
  said.own = driven(compiled, n, t, asking), said.motion = moved(compiled, n, t, asking);
  return said;
}

void thaw(const Program::Compiled& c, std::int32_t index, Asking& asking) {
  Frozen& f = c.frozen[static_cast<std::size_t>(index)];
  if (f.state != Frozen::asleep) return;
  f.state = Frozen::busy;
  const Node& n = c.nodes[f.node];
  const CompiledSpan& now = c.spans[n.first_span + static_cast<std::uint32_t>(f.span)];
  const CompiledSpan* before = f.span > 0 ? &now - 1 : nullptr;
  CompiledSpan by_code;  // just before this time
  if (before && before->computed) by_code = held(c, f.node, {now.from.flicks - 1}, asking), before = &by_code;
  const Time t = now.from.flicks == INT64_MIN ? Time{} : now.from;
  const OwnTransform said = own_transform_at(c, n, t, asking);
  const Frozen* kept = before && before->frozen >= 0 ? &c.frozen[static_cast<std::size_t>(before->frozen)] : nullptr;
  if (kept) thaw(c, before->frozen, asking);
  Sited old_parent;
  if (before && before->kind >= AttachmentKind::hang)
    old_parent = placement(c, static_cast<std::uint32_t>(before->parent), t, asking);
  if (now.kind == AttachmentKind::letgo) {
    if (before && before->kind == AttachmentKind::letgo) {  // already free: keeps the earlier transforms
      const auto span = f.span;
      f = *kept;
      f.span = span;
    } else if (before && before->kind >= AttachmentKind::hang) {
      f.held = true;
      if (kept) f.before = kept->before, f.before_turn = kept->before_turn;
      f.turn3 = held_turn(before->kind, old_parent);
      f.parent = old_parent.world, f.around = old_parent.around;
      if (before->kind != AttachmentKind::hang) f.parent_turn = old_parent.turn;
      f.attach = said.attach;
    }
  } else {
    Placed was = hang(own_place(said), said.attach, before, kept, &old_parent);
    const Sited parent = placement(c, static_cast<std::uint32_t>(now.parent), t, asking);
    if (c.sited) {  // from the environments it was in to those it will be in
      const Mat4 own = product(c, n.around, t, asking), old = kept && kept->held ? kept->around : old_parent.around;
      if (const auto out = inverse(parent.around * own)) was.world = *out * old * own * was.world;
    }
    const auto turned = inverse(held_turn(now.kind, parent)), above = inverse(parent.world);
    const auto own = inverse(local(said));
    if (turned && above && own) {
      Mat4 wanted = *turned * linear_part(was.world);
      const Vec3 place = transform_point(*above, translation_of(was.world)) - said.attach;
      wanted(0, 3) = place.x, wanted(1, 3) = place.y, wanted(2, 3) = place.z;
      f.before = wanted * *own;
      const Quat above_turn = now.kind == AttachmentKind::hang ? Quat{} : parent.turn;
      f.before_turn = normalize(conjugate(above_turn) * was.turn * conjugate(said.turn));
    }
  }
  f.state = Frozen::done;
}

namespace {

// Returns the environment's matrix A.
Mat4 matrix_of(const Program::Compiled& c, const Site& site, Time t) {
  const Scene& scene = c.document.scene();
  const Environment& e = *c.environments[site.environment];
  if (scene.smooth_ticks) return e.smooth(site.generation, scene.ticks.frame_number(t) - 1);
  const std::int64_t tick = scene.ticks.whole(t);
  SharedEnvironments& many = c.caches.environments;
  return many.set ? many.matrix(site.member, tick) : e.at(site.generation, tick);
}

// Returns the product of the environments that code names.
Mat4 computed_product(const Program::Compiled& c, std::int32_t live, Time t, Asking& asking) {
  const Scene& scene = c.document.scene();
  const Value names = c.live_value(live, t, asking);
  const auto* all = std::get_if<Names>(&names);
  const std::int64_t tick = scene.ticks.whole(t);
  Mat4 m;
  for (const std::string& name : all ? **all : std::vector<std::string>())
    for (const ObjectId id : select(scene, name)) {
      const auto& track = scene.objects[id.index].environment;
      const auto generation = track ? track->bind(tick) : std::nullopt;
      if (!generation) continue;
      m = m * (scene.smooth_ticks ? track->smooth(*generation, scene.ticks.frame_number(t) - 1)
                                  : track->at(*generation, tick));
    }
  return m;
}

}  // namespace

Mat4 product(const Program::Compiled& c, std::int32_t number, Time t, Asking& asking, const EnvironmentSet* own) {
  Mat4 m;
  if (number < 0) return m;
  const Siting& siting = c.sitings[static_cast<std::size_t>(number)];
  if (siting.live >= 0) return computed_product(c, siting.live, t, asking);
  const auto& changes = siting.changes;
  auto at =
      std::upper_bound(changes.begin(), changes.end(), t, [](Time x, const auto& change) { return x < change.from; });
  if (at != changes.begin()) --at;
  bool first = true;
  for (const Site& site : at->sites) {
    const Mat4 a = own ? own->matrix(site.member) : matrix_of(c, site, t);
    m = first ? a : m * a;
    first = false;
  }
  return m;
}

std::optional<Mat4> driven(const Program::Compiled& c, const Node& n, Time t, Asking& asking, const Mat4* drive) {
  if (!n.transform && n.drive < 0) return std::nullopt;
  Mat4 m = drive ? *drive : product(c, n.drive, t, asking);
  if (n.transform)
    if (const Value v = c.value(c.find(n.object, fn::transform), t, asking); const auto* own = std::get_if<Matrix>(&v))
      m = m * **own;
  return m;
}

Sited placement(const Program::Compiled& c, std::uint32_t node, Time t, Asking& asking, bool turned) {
  std::vector<std::pair<std::uint32_t, CompiledSpan>> chain;
  for (std::int32_t i = static_cast<std::int32_t>(node); i >= 0;) {
    const Node& n = c.nodes[static_cast<std::size_t>(i)];
    const bool looks = n.looks && (turned || !chain.empty());  // turning does not move its own position
    if (looks || n.bends) {                                    // look-at or inverse kinematics turns it
      Evaluator some(c, asking.deferred);
      some.place(t, asking, needed(c, {&node, 1}, turned, t, asking));
      return {some.placed(node), some.around(node)};
    }
    chain.emplace_back(static_cast<std::uint32_t>(i), held(c, static_cast<std::uint32_t>(i), t, asking));
    const CompiledSpan& h = chain.back().second;
    i = h.kind >= AttachmentKind::hang ? h.parent : -1;
  }
  Sited placed;
  for (; !chain.empty(); chain.pop_back()) {
    const Node& n = c.nodes[chain.back().first];
    const CompiledSpan* h = &chain.back().second;
    if (h->frozen >= 0) thaw(c, h->frozen, asking);
    const OwnTransform said = own_transform_at(c, n, t, asking, turned || chain.size() > 1);
    const Frozen* f = h->frozen >= 0 ? &c.frozen[static_cast<std::size_t>(h->frozen)] : nullptr;
    if (h->kind < AttachmentKind::hang) placed.around = f && f->held ? f->around : Mat4{};
    static_cast<Placed&>(placed) = hang(own_place(said), said.attach, h, f, &placed);
    if (n.around >= 0) placed.around = placed.around * product(c, n.around, t, asking);
  }
  return placed;
}

Vec3 place_of(const Program::Compiled& c, std::uint32_t node, Time t, Asking& asking) {
  return translation_of(placement(c, node, t, asking, false).in_world());
}

double place_of(const Program::Compiled& c, std::uint32_t node, Time t, Asking& asking, int component) {
  const Node& n = c.nodes[node];
  const Binding& position = c.find(n.object, fn::position);
  const bool bare = position.live >= 0 && !n.on_axes && c.parted(position.live, component) && turns_in_place(c, n) &&
                    !n.bends && n.moving < 0 && n.around < 0;
  if (bare && held(c, node, t, asking).kind == AttachmentKind::detach)
    if (const Value v = c.live_value(position.live, t, asking, component); const auto* d = std::get_if<double>(&v))
      return *d + 0.0;  // turns -0 into 0, as matrices do
  return place_of(c, node, t, asking)[component];
}

// Like hang(), for a position and a rotation only. It must not read the object's own values: one of them may be the
// value that is being evaluated.
Carrier carrier_of(const Program::Compiled& c, const Node& n, Time t, Asking& asking) {
  Carrier out;
  if (!c.span(n, t)) {
    if (n.around >= 0) out.above = product(c, n.around, t, asking);
    return out;
  }
  const CompiledSpan span = held(c, c.node_of[n.object], t, asking);
  if (span.frozen >= 0) thaw(c, span.frozen, asking);
  const Frozen* const kept = span.frozen >= 0 ? &c.frozen[static_cast<std::size_t>(span.frozen)] : nullptr;
  Mat4 around;
  Quat turn;
  if (span.kind >= AttachmentKind::hang) {
    const Sited parent = placement(c, static_cast<std::uint32_t>(span.parent), t, asking);
    double x[4] = {};
    c.evaluate(c.find(n.object, fn::attach_position), t, asking, x);
    around = parent.around, out.above = parent.world, out.attach = vec3(x);
    if (span.kind != AttachmentKind::hang) turn = parent.turn;
  } else if (kept && kept->held) {
    around = kept->around, out.above = kept->parent, out.attach = kept->attach, turn = kept->parent_turn;
  }
  if (n.around >= 0) around = around * product(c, n.around, t, asking);
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

Quat turned_to(const Program::Compiled& c, const Node& n, Vec3 direction, Time t, Asking& asking) {
  const Value said = c.value(c.find(n.object, fn::front), t, asking);
  const auto* word = std::get_if<Text>(&said);
  Front front = n.kind == Kind::camera || n.kind == Kind::light ? Front::minus_z : Front::x;
  for (std::size_t i = 0; word && i < front_names.size(); ++i)
    if (**word == front_names[i]) front = static_cast<Front>(i);
  return facing(direction, front, c.document.scene().appearance.flat);
}

Kinematics Program::kinematics(ObjectId object, Time t) const {
  const auto of = code_->node_of_object(object);
  if (!of) return {};
  Asking asking;
  const Compiled& compiled = *code_;
  const std::uint32_t node = *of;
  const Node& n = compiled.nodes[node];
  const auto place = [&](Time when) { return translation_of(placement(compiled, node, when, asking).in_world()); };
  Kinematics b;
  b.position = place(t);
  const CompiledSpan h = betwixt::held(compiled, node, t, asking);
  const bool held = h.kind >= AttachmentKind::hang;
  if (held) b.track_to_world = linear_part(placement(compiled, static_cast<std::uint32_t>(h.parent), t, asking).world);
  const Mat4 around = linear_part(placement(compiled, node, t, asking).around);
  if (h.frozen >= 0) {
    const Frozen& f = compiled.frozen[static_cast<std::size_t>(h.frozen)];
    if (!held) b.track_to_world = linear_part(f.parent);
    b.track_to_world = b.track_to_world * linear_part(f.before);
  }
  b.track_to_world = around * b.track_to_world;
  if (const auto motion = moved(compiled, n, t, asking)) b.track_to_world = b.track_to_world * linear_part(*motion);
  // The position track gives the velocity. If a parent carries the object, or did until now, the velocity is measured
  // by differences instead.
  if (held || h.computed || h.from == t || n.moving >= 0) {
    constexpr Time look{flicks_per_second / 2000};
    b.velocity = 1000 * (3.0 * b.position - 4.0 * place(t - look) + place(t - look - look));
  } else {
    Target rate{object, fn::position};
    rate.velocity = true;
    b.velocity = transform_vector(b.track_to_world, std::get<Vec3>(read(rate, t)));
  }
  return b;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where things are: what they hang on, what was let go, cameras that look at something. (rules, section 5)
#include <algorithm>
#include <cmath>

#include "program/compiled.h"

namespace betwixt {
namespace {

// What the tracks of one object say about its place.
struct Said {
  Quat turn;
  Vec3 scale, pivot, position, attach;
  std::optional<Mat4> own;     // what moves it in its own space first
  std::optional<Mat4> motion;  // and what moves it where its position is
};

// The turning part of a matrix that turns and scales.
Quat turn_of(const Mat4& m) {
  Mat4 r;
  for (int c = 0; c < 3; ++c) {
    const Vec3 axis = normalize({m(0, c), m(1, c), m(2, c)}, {c == 0 ? 1.0 : 0, c == 1 ? 1.0 : 0, c == 2 ? 1.0 : 0});
    r(0, c) = axis.x, r(1, c) = axis.y, r(2, c) = axis.z;
  }
  return from_matrix(r);
}

// Scale and rotation about the pivot, then the move (R-H7).
Mat4 local(const Said& said) {
  Mat4 m = rotation(said.turn);
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) m(i, c) *= said.scale[c];
  const Vec3 move = said.position + said.pivot - transform_vector(m, said.pivot);
  m(0, 3) = move.x, m(1, 3) = move.y, m(2, 3) = move.z;
  if (said.own) m = m * *said.own;
  return said.motion ? *said.motion * m : m;
}

Mat4 linear_part(Mat4 m) {
  m(0, 3) = m(1, 3) = m(2, 3) = 0;
  return m;
}

Mat4 held_turn(AttachmentKind kind, const Placed& parent) {
  return kind == AttachmentKind::couple   ? linear_part(parent.world)
         : kind == AttachmentKind::attach ? rotation(parent.turn)
                                          : Mat4{};
}

// R-H1 to R-H5. `parent`: of hang, attach and couple, at this time.
Placed hang(const Said& said, const CompiledSpan* span, const Frozen* frozen, const Placed* parent) {
  Mat4 m = local(said);
  Quat turn = said.own ? said.turn * turn_of(*said.own) : said.turn;
  if (said.motion) turn = turn_of(*said.motion) * turn;
  if (!span || span->kind == AttachmentKind::detach || (span->kind == AttachmentKind::letgo && !frozen->held))
    return {m, turn};
  Vec3 attach = said.attach;
  if (frozen) m = frozen->before * m, turn = frozen->before_turn * turn;
  Mat4 turn3, above;
  Quat above_turn;
  if (span->kind == AttachmentKind::letgo) {
    turn3 = frozen->turn3, above = frozen->parent, above_turn = frozen->parent_turn, attach = frozen->attach;
  } else {
    turn3 = held_turn(span->kind, *parent), above = parent->world;
    if (span->kind != AttachmentKind::hang) above_turn = parent->turn;
  }
  const Vec3 place = transform_point(above, translation_of(m) + attach);
  Mat4 world = turn3 * linear_part(m);
  world(0, 3) = place.x, world(1, 3) = place.y, world(2, 3) = place.z;
  return {world, above_turn * turn};
}

Said said_by(const Node& n, const double* numbers) {
  const double* r = numbers + n.rotation;
  return {n.orientation ? Quat{r[0], r[1], r[2], r[3]} : from_angles(vec3(r)),
          vec3(numbers + n.scale),
          vec3(numbers + n.pivot),
          vec3(numbers + n.position),
          vec3(numbers + n.attach),
          {},
          {}};
}

// The same of one node alone.
Said said_at(const Program::Compiled& compiled, const Node& n, Time t, Asking& asking) {
  double x[4] = {};
  const auto numbers = [&](FunctionId f) {
    compiled.evaluate(compiled.find(n.object, f), t, asking, x);
    return vec3(x);
  };
  Said said;
  numbers(fn::rotation);
  said.turn = n.orientation ? Quat{x[0], x[1], x[2], x[3]} : from_angles(vec3(x));
  said.scale = numbers(fn::scale), said.pivot = numbers(fn::pivot), said.position = numbers(fn::position);
  said.attach = numbers(fn::attach_position);
  said.own = compiled.driven(n, t, asking), said.motion = compiled.moved(n, t);
  return said;
}

}  // namespace

const CompiledSpan* Program::Compiled::span(const Node& n, Time t) const {
  const CompiledSpan *first = spans.data() + n.first_span, *last = first + n.spans;
  const CompiledSpan* next =
      std::upper_bound(first, last, t, [](Time time, const CompiledSpan& h) { return time < h.from; });
  return next == first ? nullptr : next - 1;
}

// What a letgo or a keep-world keeps: worked out once, from the world at its time.
void Program::Compiled::thaw(std::int32_t index, Asking& asking) const {
  Frozen& f = frozen[static_cast<std::size_t>(index)];
  if (f.state != Frozen::asleep) return;
  f.state = Frozen::busy;
  const Node& n = nodes[f.node];
  const CompiledSpan& now = spans[n.first_span + static_cast<std::uint32_t>(f.span)];
  const CompiledSpan* before = f.span > 0 ? &now - 1 : nullptr;
  const Time t = now.from.flicks == INT64_MIN ? Time{} : now.from;
  const Said said = said_at(*this, n, t, asking);
  const Frozen* kept = before && before->frozen >= 0 ? &frozen[static_cast<std::size_t>(before->frozen)] : nullptr;
  if (kept) thaw(before->frozen, asking);
  Sited old_parent;
  if (before && before->kind >= AttachmentKind::hang)
    old_parent = placement(static_cast<std::uint32_t>(before->parent), t, asking);
  if (now.kind == AttachmentKind::letgo) {
    if (before && before->kind == AttachmentKind::letgo) {  // nobody holds it: what was kept stays
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
    Placed was = hang(said, before, kept, &old_parent);
    const Sited parent = placement(static_cast<std::uint32_t>(now.parent), t, asking);
    if (sited) {  // from the environments that enclosed it to those that will
      const Mat4 own = product(n.around, t), old = kept && kept->held ? kept->around : old_parent.around;
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

Mat4 Program::Compiled::matrix(const Site& site, Time t) const {
  const Scene& scene = document.scene();
  const Environment& e = *environments[site.environment];
  if (scene.smooth_ticks) return e.smooth(site.generation, scene.ticks.frame_number(t) - 1);
  const std::int64_t tick = scene.ticks.whole(t);
  if (!many) return e.at(site.generation, tick);
  const std::lock_guard lock(many_in_use);
  if (many->tick() != tick) many->advance(tick);
  return many->matrix(site.member);
}

Mat4 Program::Compiled::product(std::int32_t siting, Time t) const {
  Mat4 m;
  if (siting < 0) return m;
  const auto& changes = sitings[static_cast<std::size_t>(siting)].changes;
  auto at = std::upper_bound(changes.begin(), changes.end(), t, [](Time x, const auto& c) { return x < c.from; });
  if (at != changes.begin()) --at;
  bool first = true;
  for (const Site& site : at->sites) {
    const Mat4 a = matrix(site, t);
    m = first ? a : m * a;
    first = false;
  }
  return m;
}

// What moves it in its own space: its transform, then the environments that drive it.
std::optional<Mat4> Program::Compiled::driven(const Node& n, Time t, Asking& asking) const {
  if (!n.transform && n.drive < 0) return std::nullopt;
  Mat4 m = product(n.drive, t);
  if (n.transform)
    if (const Value v = value(find(n.object, fn::transform), t, asking); const auto* own = std::get_if<Matrix>(&v))
      m = m * **own;
  return m;
}

// Where all nodes are. For each one up to the root and, unwinding, down again; nothing is worked out twice (G85, G86).
// A camera that looks at something turns with it, and so does what hangs on the camera: cameras take their turn in this
// order, each seeing the ones before it already turned.
std::vector<Placed> Program::Compiled::placements(Time t, const double* numbers, Asking& asking,
                                                  std::vector<Mat4>& around) const {
  constexpr std::int32_t unknown = -2;
  std::vector<Placed> w(nodes.size());
  std::vector<std::int32_t> above(nodes.size(), unknown);
  std::vector<std::uint32_t> order, chain;
  order.reserve(nodes.size());
  around.clear();
  if (sited) around.resize(nodes.size());
  const auto put = [&](std::uint32_t i) {
    const CompiledSpan* h = span(nodes[i], t);
    const Frozen* f = h && h->frozen >= 0 ? &frozen[static_cast<std::size_t>(h->frozen)] : nullptr;
    Said said = said_by(nodes[i], numbers);
    said.own = driven(nodes[i], t, asking), said.motion = moved(nodes[i], t);
    w[i] = hang(said, h, f, above[i] >= 0 ? &w[static_cast<std::size_t>(above[i])] : nullptr);
    if (!sited) return;
    const Mat4* outer = above[i] >= 0  ? &around[static_cast<std::size_t>(above[i])]
                        : f && f->held ? &f->around
                                       : nullptr;
    around[i] = product(nodes[i].around, t);
    if (outer) around[i] = *outer * around[i];
  };
  const auto in_world = [&](std::uint32_t i) { return sited ? around[i] * w[i].world : w[i].world; };
  for (std::uint32_t start = 0; start < nodes.size(); ++start) {
    for (std::int32_t i = static_cast<std::int32_t>(start); i >= 0 && above[static_cast<std::size_t>(i)] == unknown;) {
      const auto at = static_cast<std::uint32_t>(i);
      const CompiledSpan* h = span(nodes[at], t);
      chain.push_back(at);
      i = above[at] = h && h->kind >= AttachmentKind::hang ? h->parent : -1;
    }
    for (; !chain.empty(); chain.pop_back()) {
      put(chain.back());
      order.push_back(chain.back());
    }
  }
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint32_t eye = order[i];
    if (nodes[eye].kind != Kind::camera) continue;
    const auto target = aim(
        nodes[eye].object, t, numbers, [&](std::uint32_t node) { return translation_of(in_world(node)); }, asking);
    const Vec3 place = translation_of(in_world(eye));
    if (!target || *target == place) continue;
    w[eye].world = look_at(place, *target);
    w[eye].turn = from_matrix(w[eye].world);
    if (sited)  // it stands upright in the world, whatever encloses it
      if (const auto back = inverse(around[eye])) w[eye].world = *back * w[eye].world;
    std::vector<bool> below(nodes.size());
    below[eye] = true;
    for (std::size_t k = i + 1; k < order.size(); ++k) {
      const std::int32_t p = above[order[k]];
      if (p < 0 || !below[static_cast<std::size_t>(p)]) continue;
      below[order[k]] = true;
      put(order[k]);
    }
  }
  return w;
}

std::vector<Mat4> Program::Compiled::worlds(Time t, const double* numbers, Asking& asking) const {
  std::vector<Mat4> around;
  const auto all = placements(t, numbers, asking, around);
  std::vector<Mat4> w(all.size());
  for (std::size_t i = 0; i < w.size(); ++i) w[i] = sited ? around[i] * all[i].world : all[i].world;
  return w;
}

Sited Program::Compiled::placement(std::uint32_t node, Time t, Asking& asking) const {
  std::vector<std::uint32_t> chain;
  for (std::int32_t i = static_cast<std::int32_t>(node); i >= 0;) {
    const Node& n = nodes[static_cast<std::size_t>(i)];
    chain.push_back(static_cast<std::uint32_t>(i));
    if (n.kind == Kind::camera &&
        &find(n.object, fn::look_at) != &defaults[fn::look_at]) {  // it turns with what it looks at
      std::vector<Mat4> around;
      Sited found{placements(t, at(t, asking).data(), asking, around)[node], {}};
      if (sited) found.around = around[node];
      return found;
    }
    const CompiledSpan* h = span(n, t);
    i = h && h->kind >= AttachmentKind::hang ? h->parent : -1;
  }
  Sited placed;
  for (; !chain.empty(); chain.pop_back()) {
    const Node& n = nodes[chain.back()];
    const CompiledSpan* h = span(n, t);
    if (h && h->frozen >= 0) thaw(h->frozen, asking);
    const Said said = said_at(*this, n, t, asking);
    const Frozen* f = h && h->frozen >= 0 ? &frozen[static_cast<std::size_t>(h->frozen)] : nullptr;
    const bool held = h && h->kind >= AttachmentKind::hang;
    if (!held) placed.around = f && f->held ? f->around : Mat4{};
    static_cast<Placed&>(placed) = hang(said, h, f, &placed);
    if (n.around >= 0) placed.around = placed.around * product(n.around, t);
  }
  return placed;
}

Kinematics Program::kinematics(ObjectId object, Time t) const {
  Asking asking;
  const Compiled& compiled = *code_;
  const std::uint32_t node = compiled.node_of[object.index];
  const Node& n = compiled.nodes[node];
  const auto place = [&](Time when) { return translation_of(compiled.placement(node, when, asking).in_world()); };
  Kinematics b;
  b.position = place(t);
  const CompiledSpan* h = compiled.span(n, t);
  const bool held = h && h->kind >= AttachmentKind::hang;
  if (held) b.to_world = linear_part(compiled.placement(static_cast<std::uint32_t>(h->parent), t, asking).world);
  const Mat4 around = linear_part(compiled.placement(node, t, asking).around);
  if (h && h->frozen >= 0) {
    const Frozen& f = compiled.frozen[static_cast<std::size_t>(h->frozen)];
    if (!held) b.to_world = linear_part(f.parent);
    b.to_world = b.to_world * linear_part(f.before);
  }
  b.to_world = around * b.to_world;
  if (const auto motion = compiled.moved(n, t)) b.to_world = b.to_world * linear_part(*motion);
  // Its track says how fast it goes; what carries it, or carried it up to now, is looked at as it goes by.
  if (held || (h && h->from == t) || n.moving >= 0) {
    constexpr Time look{flicks_per_second / 2000};
    b.velocity = 1000 * (3.0 * b.position - 4.0 * place(t - look) + place(t - look - look));
  } else {
    Target rate{object, fn::position};
    rate.velocity = true;
    b.velocity = transform_vector(b.to_world, std::get<Vec3>(read(rate, t)));
  }
  return b;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions: products of T, R and S over segments of time, in sequence.
#include <algorithm>
#include <cmath>

#include "program/compile.h"
#include "program/deferred_evaluation.h"
#include "program/placing.h"

namespace betwixt {
namespace {

// Fixes centres that are objects: takes the object's position when the motion begins, in the space of the moved
// object's positions.
void place_centres(Program::Compiled& compiled, const Node& node, Motion& motion, Time t) {
  Asking asking;
  for (Factor& f : motion.factors) {
    if (f.about.empty()) continue;
    const ObjectId id = compiled.document.find(f.about);
    if (!id || compiled.node_of[id.index] == ObjectId::nothing)
      compiled.notices.push_back("'" + compiled.document.name(ObjectId{node.object}) + "' moves about '" + f.about +
                                 "', which does not exist: it moves about the origin instead");
    f.about.clear();
    if (!id || compiled.node_of[id.index] == ObjectId::nothing) continue;
    const Vec3 place = translation_of(placement(compiled, compiled.node_of[id.index], t, asking).in_world());
    if (const auto centre = carrier_of(compiled, node, t, asking).seen(place))
      f.centre = *centre;
    else
      compiled.notices.push_back("'" + compiled.document.name(ObjectId{node.object}) +
                                 "' has a parent with a scale of 0: its motion about '" + compiled.document.name(id) +
                                 "' is about the origin instead");
  }
}

// Computes a motion that is code, from the film as it is when the motion begins.
void compute(const Program::Compiled& compiled, const Node& node, Moving::Piece& piece) {
  const Binding& b = compiled.find(node.object, fn::motion);
  if (!piece.computed || b.live < 0) return;
  Asking asking;
  const Value v = compiled.live_value(b.live, piece.from, asking);
  if (const auto* m = std::get_if<Moves>(&v)) piece.motion = about_what_is_there(compiled.document.scene(), **m);
  piece.problems = std::move(asking.problems);
}

// Makes the curve from 0 to 1 between two events, by the first one's twerper and the eases of both.
Curve progress(CurveSet& set, const Track& track, const Event& begin, const Event& end) {
  Track one = track;
  one.events = {};
  for (const Event* e : {&begin, &end}) {
    Event p = *e;
    p.value = e == &begin ? 0.0 : 1.0;
    if (p.twerper == Twerper::unset) p.twerper = Twerper::linear;
    one.events.put(std::move(p));
  }
  return set.add(one, Type::scalar);
}

Moving moving(CurveSet& set, const Track& track) {
  Moving made;
  std::vector<Event> events;
  track.events.each([&](const Event& e) {
    if ((std::holds_alternative<Moves>(e.value) || std::holds_alternative<Procedure>(e.value)) && !e.keep)
      events.push_back(e);
  });
  if (events.empty()) return made;
  made.first = events.front().time, made.last = events.back().time;
  made.extend_before = track.before, made.extend_after = track.after;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const auto* plain = std::get_if<Moves>(&events[i].value);
    if (plain && (*plain)->factors.empty()) continue;
    const bool open = i + 1 == events.size();
    Moving::Piece p;
    p.from = events[i].time, p.until = open ? Time{INT64_MAX} : events[i + 1].time, p.open = open;
    p.computed = !plain;
    if (plain) p.motion = **plain;
    if (!open) p.progress = progress(set, track, events[i], events[i + 1]);
    made.pieces.push_back(std::move(p));
  }
  return made;
}

}  // namespace

void compile_motions(CompiledFilm& compiled) {
  const Scene& scene = compiled.document.scene();
  for (Node& n : compiled.nodes) {
    const Slot* slot = scene.objects[n.object].find(fn::motion);
    if (!slot || slot->track->events.empty()) continue;
    Moving made = moving(compiled.set, *slot->track);
    if (made.pieces.empty()) continue;
    n.moving = static_cast<std::int32_t>(compiled.movings.size());
    compiled.movings.push_back(std::move(made));
  }
}

void settle(Program::Compiled& compiled, const std::vector<std::int32_t>& frozen) {
  struct Start {
    Time time;
    std::uint32_t node;
    std::size_t piece;
  };
  std::vector<Start> starts;
  for (std::uint32_t i = 0; i < compiled.nodes.size(); ++i)
    if (const std::int32_t m = compiled.nodes[i].moving; m >= 0) {
      const auto& pieces = compiled.movings[static_cast<std::size_t>(m)].pieces;
      for (std::size_t k = 0; k < pieces.size(); ++k) starts.push_back({pieces[k].from, i, k});
    }
  std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.time < b.time; });
  // In the order of time, because a motion's start depends on earlier motions and releases. Motions that start at this
  // time have done nothing yet.
  auto next = frozen.begin();
  const auto thaw_until = [&](Time until) {
    for (; next != frozen.end(); ++next) {
      const Frozen& f = compiled.frozen[static_cast<std::size_t>(*next)];
      if (compiled.spans[compiled.nodes[f.node].first_span + static_cast<std::uint32_t>(f.span)].from > until) return;
      Asking asking;
      thaw(compiled, *next, asking);
    }
  };
  const auto moving_of = [&](const Start& s) -> Moving& {
    return compiled.movings[static_cast<std::size_t>(compiled.nodes[s.node].moving)];
  };
  for (std::size_t i = 0; i < starts.size();) {
    std::size_t end = i;
    for (; end < starts.size() && starts[end].time == starts[i].time; ++end) {
      auto& pieces = moving_of(starts[end]).pieces;
      const std::size_t k = starts[end].piece;
      if (k > 0) pieces[k].before = at(pieces[k - 1].motion, 1) * pieces[k - 1].before;
    }
    thaw_until(starts[i].time);
    for (std::size_t k = i; k < end; ++k) {
      const Node& node = compiled.nodes[starts[k].node];
      Moving::Piece& piece = moving_of(starts[k]).pieces[starts[k].piece];
      compute(compiled, node, piece);
      place_centres(compiled, node, piece.motion, starts[k].time);
    }
    for (; i < end; ++i) ++moving_of(starts[i]).placed;
  }
  thaw_until({INT64_MAX});
  compiled.caches.filter_inputs.clear();
  compiled.caches.tracers.all.clear();  // their cached positions may be too early
}

std::vector<Motion> Program::motions(ObjectId object) const {
  std::vector<Motion> all;
  const auto node = code_->node_of_object(object);
  if (!node) return all;
  const Node& n = code_->nodes[*node];
  if (n.moving >= 0)
    for (const Moving::Piece& p : code_->movings[static_cast<std::size_t>(n.moving)].pieces) all.push_back(p.motion);
  return all;
}

namespace {

// M = A_k(u) A_(k-1)(1) ... A_1(1), with u of piece k done. The motions act in the space of the position.
std::optional<Mat4> whole_motion(const CurveSet& set, const Moving& m, Time t) {
  constexpr double bound = 1e18;
  const auto at = m.place(t);
  if (!at) return std::nullopt;
  const Moving::Piece& p = *at->piece;
  // While centres are being fixed, starting pieces have done nothing, and later ones do not exist yet.
  if (static_cast<std::size_t>(&p - m.pieces.data()) >= m.placed) {
    if (at->how != Extrapolation::hold) return std::nullopt;
    return p.before;
  }
  const bool beyond = at->time >= p.until && !(at->how == Extrapolation::linear && p.until == m.last);
  double done = p.open ? 0 : 1;
  if (!p.open && !beyond) set.evaluate(p.progress, at->time, &done);
  Mat4 whole = betwixt::at(p.motion, done) * p.before;
  for (double& x : whole.m) x = std::isnan(x) ? 0 : std::clamp(x, -bound, bound);
  return whole;
}

}  // namespace

std::optional<Mat4> moved(const Program::Compiled& c, const Node& n, Time t, Asking& asking) {
  if (n.moving < 0) return std::nullopt;
  const Moving& m = c.movings[static_cast<std::size_t>(n.moving)];
  if (const auto at = m.place(t))
    for (const Problem& p : at->piece->problems) asking.say(p);
  return coded_value(
      c, c.find(n.object, fn::motion), t, asking, [](const Answer& a) { return &a.motion; },
      [&] { return whole_motion(c.set, m, t); });
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions: strings of T, R and S over segments of time, one after the other. (rules, R-H7)
#include <algorithm>
#include <cmath>

#include "program/code.h"

namespace betwixt {
namespace {

// A centre that is an object: where its tracks put it as the motion begins, seen from where the moved one's are.
Motion placed_centres(const Program::Compiled& code, const Node& node, Motion motion, Time t) {
  Asking asking;
  asking.at_rest = true;
  for (Factor& f : motion.factors) {
    if (f.about.empty()) continue;
    const ObjectId id = code.document.find(f.about);
    f.about.clear();
    if (!id || code.node_of[id.index] == ObjectId::nothing) continue;
    f.centre = translation_of(code.placement(code.node_of[id.index], t, asking).world);
    const Hand* hand = code.hand(node, t);
    if (!hand || hand->hold < Hold::hang) continue;
    const Mat4 parent = code.placement(static_cast<std::uint32_t>(hand->parent), t, asking).world;
    double attach[4] = {};
    code.evaluate(code.find(node.object, fn::attach_position), t, asking, attach);
    if (const auto back = inverse(parent)) f.centre = transform_point(*back, f.centre) - vec3(attach);
  }
  return motion;
}

// Each event counts how many motions are done by then; in between, a curve says how much of the next.
Moving moving(Program::Compiled& code, const Node& node, const Track& track) {
  Moving made;
  Track progress = track;
  progress.events = {};
  Mat4 before;
  double done = 0;
  bool open = false;
  std::size_t left = track.events.size();
  track.events.each([&](const Event& e) {
    --left;
    const auto* moves = std::get_if<Moves>(&e.value);
    if (!moves || e.keep) return;
    if (open) ++done, before = at(made.pieces.back().motion, 1) * before;
    open = !(*moves)->factors.empty() && left > 0;
    if (open) made.pieces.push_back({placed_centres(code, node, **moves, e.time), before});
    Event p = e;
    p.value = done;
    if (p.twerper == Twerper::unset) p.twerper = Twerper::linear;
    progress.events.put(std::move(p));
  });
  if (!made.pieces.empty()) made.progress = code.set.add(progress, Type::scalar);
  return made;
}

}  // namespace

void compile_motions(Program::Compiled& code) {
  // What was let go is looked at here without motions, and later with them: nothing of it is kept.
  const std::vector<Frozen> asleep = code.frozen;
  const Scene& scene = code.document.scene();
  for (Node& n : code.nodes) {
    const Slot* slot = scene.objects[n.object].find(fn::motion);
    if (!slot || slot->track->events.empty()) continue;
    Moving made = moving(code, n, *slot->track);
    if (made.pieces.empty()) continue;
    n.moving = static_cast<std::int32_t>(code.movings.size());
    code.movings.push_back(std::move(made));
  }
  code.frozen = asleep;
}

// M = A_k(u) ... A_1(1), u of piece k done: the motions act where the position is.
std::optional<Mat4> Program::Compiled::moved(const Node& n, Time t, const Asking& asking) const {
  constexpr double bound = 1e18;
  if (n.moving < 0 || asking.at_rest) return std::nullopt;
  const Moving& m = movings[static_cast<std::size_t>(n.moving)];
  double done = 0;
  set.evaluate(m.progress, t, &done);
  const auto k = static_cast<std::size_t>(std::clamp(std::floor(done), 0.0, static_cast<double>(m.pieces.size() - 1)));
  const Moving::Piece& piece = m.pieces[k];
  Mat4 whole = betwixt::at(piece.motion, done - static_cast<double>(k)) * piece.before;
  for (double& x : whole.m) x = std::isfinite(x) ? std::clamp(x, -bound, bound) : 0;
  return whole;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions: strings of T, R and S over segments of time, one after the other. (rules, R-H7)
#include <algorithm>
#include <cmath>

#include "program/code.h"

namespace betwixt {
namespace {

// A centre that is an object: where that is as the motion begins, seen from where the positions of the moved one are.
void place_centres(Program::Compiled& code, const Node& node, Motion& motion, Time t) {
  Asking asking;
  for (Factor& f : motion.factors) {
    if (f.about.empty()) continue;
    const ObjectId id = code.document.find(f.about);
    if (!id || code.node_of[id.index] == ObjectId::nothing)
      code.notices.push_back("'" + code.document.name(ObjectId{node.object}) + "' moves about '" + f.about +
                             "', which is not there: about the origin instead");
    f.about.clear();
    if (!id || code.node_of[id.index] == ObjectId::nothing) continue;
    const Vec3 place = translation_of(code.placement(code.node_of[id.index], t, asking).in_world());
    const Sited own = code.placement(code.node_of[node.object], t, asking);
    // in the world: around (above (p + attach)), p behind what was kept
    Mat4 above = own.around, kept;
    const Hand* hand = code.hand(node, t);
    const Frozen* frozen = hand && hand->frozen >= 0 ? &code.frozen[static_cast<std::size_t>(hand->frozen)] : nullptr;
    Vec3 attach;
    if (hand && hand->hold >= Hold::hang) {
      double n[4] = {};
      code.evaluate(code.find(node.object, fn::attach_position), t, asking, n);
      attach = vec3(n);
      above = above * code.placement(static_cast<std::uint32_t>(hand->parent), t, asking).world;
    } else if (frozen && frozen->held) {
      above = above * frozen->parent, attach = frozen->attach;
    }
    if (frozen) kept = frozen->before;
    const auto back = inverse(above), out = inverse(kept);
    if (back && out) f.centre = transform_point(*out, transform_point(*back, place) - attach);
  }
}

// Each event counts how many motions are done by then; in between, a curve says how much of the next.
Moving moving(CurveSet& set, const Track& track) {
  Moving made;
  Track progress = track;
  progress.events = {};
  double done = 0;
  bool open = false;
  std::size_t left = track.events.size();
  track.events.each([&](const Event& e) {
    --left;
    const auto* moves = std::get_if<Moves>(&e.value);
    if (!moves || e.keep) return;
    if (open) ++done;
    open = !(*moves)->factors.empty() && left > 0;
    if (open) made.pieces.push_back({e.time, **moves, {}});
    Event p = e;
    p.value = done;
    if (p.twerper == Twerper::unset) p.twerper = Twerper::linear;
    progress.events.put(std::move(p));
  });
  if (!made.pieces.empty()) made.progress = set.add(progress, Type::scalar);
  return made;
}

}  // namespace

void compile_motions(Program::Compiled& code) {
  struct Start {
    Time time;
    std::uint32_t node;
    std::size_t piece;
  };
  std::vector<Start> starts;
  const Scene& scene = code.document.scene();
  for (std::uint32_t i = 0; i < code.nodes.size(); ++i) {
    Node& n = code.nodes[i];
    const Slot* slot = scene.objects[n.object].find(fn::motion);
    if (!slot || slot->track->events.empty()) continue;
    Moving made = moving(code.set, *slot->track);
    if (made.pieces.empty()) continue;
    for (std::size_t k = 0; k < made.pieces.size(); ++k) starts.push_back({made.pieces[k].from, i, k});
    n.moving = static_cast<std::int32_t>(code.movings.size());
    code.movings.push_back(std::move(made));
  }
  std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.time < b.time; });
  const auto piece = [&](const Start& s) -> Moving::Piece& {
    return code.movings[static_cast<std::size_t>(code.nodes[s.node].moving)].pieces[s.piece];
  };
  // In the order of time: where things are when a motion begins takes the motions before it, and of those that begin
  // with it nothing has been done yet.
  for (std::size_t i = 0; i < starts.size();) {
    std::size_t end = i;
    for (; end < starts.size() && starts[end].time == starts[i].time; ++end)
      if (const Start& s = starts[end]; s.piece > 0) {
        const Moving::Piece& last = (&piece(s))[-1];
        piece(s).before = at(last.motion, 1) * last.before;
      }
    for (; i < end; ++i) place_centres(code, code.nodes[starts[i].node], piece(starts[i]).motion, starts[i].time);
  }
}

std::vector<Motion> Program::motions(ObjectId object) const {
  std::vector<Motion> all;
  const Node& n = code_->nodes[code_->node_of[object.index]];
  if (n.moving >= 0)
    for (const Moving::Piece& p : code_->movings[static_cast<std::size_t>(n.moving)].pieces) all.push_back(p.motion);
  return all;
}

// M = A_k(u) ... A_1(1), u of piece k done: the motions act where the position is.
std::optional<Mat4> Program::Compiled::moved(const Node& n, Time t) const {
  constexpr double bound = 1e18;
  if (n.moving < 0) return std::nullopt;
  const Moving& m = movings[static_cast<std::size_t>(n.moving)];
  double done = 0;
  set.evaluate(m.progress, t, &done);
  const auto k = static_cast<std::size_t>(std::clamp(std::floor(done), 0.0, static_cast<double>(m.pieces.size() - 1)));
  const Moving::Piece& piece = m.pieces[k];
  Mat4 whole = betwixt::at(piece.motion, done - static_cast<double>(k)) * piece.before;
  for (double& x : whole.m) x = std::isnan(x) ? 0 : std::clamp(x, -bound, bound);
  return whole;
}

}  // namespace betwixt

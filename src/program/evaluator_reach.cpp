// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Inverse kinematics: an object that reaches for something turns the joints above it, after all nodes are placed.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "program/compile.h"
#include "program/evaluator.h"
#include "program/ik.h"
#include "program/placing.h"

namespace betwixt {

// Returns the joints of a chain, from the root to the nearest.
std::vector<std::uint32_t> Evaluator::joints_of(std::uint32_t hand) const {
  std::vector<std::uint32_t> joints;
  const std::size_t bones = compiled_.nodes[hand].reaches;
  for (std::int32_t i = parent_[hand]; i >= 0 && joints.size() < bones; i = parent_[static_cast<std::size_t>(i)])
    joints.push_back(static_cast<std::uint32_t>(i));
  std::reverse(joints.begin(), joints.end());
  return joints;
}

Vec3 Evaluator::joint_place(std::uint32_t node) const {
  return transform_point(world(node), vec3(&numbers_[compiled_.nodes[node].pivot]));
}

// Turns a node about its joint, in world space.
void Evaluator::turn_joint(std::uint32_t node, Quat turn) {
  const Vec3 place = joint_place(node);
  const Mat4 around = this->around(node);
  const Mat4 turned = translation(place) * rotation(turn) * translation(-place) * around * worlds_[node];
  const auto back = inverse(around);
  if (!turns_.empty()) turns_[node] = turn * turns_[node];
  put_world(node, back ? *back * turned : turned);
  show_sited(node);
}

// Returns since when the node has hung on the hand or on one of the joints. Returns nullopt if it does not, or always
// has.
std::optional<Time> Evaluator::held_since(std::uint32_t node, std::uint32_t hand,
                                          std::span<const std::uint32_t> joints) const {
  std::optional<Time> since;
  for (auto i = static_cast<std::int32_t>(node); i >= 0;) {
    const auto n = static_cast<std::uint32_t>(i);
    if (n == hand || std::find(joints.begin(), joints.end(), n) != joints.end()) return since;
    const CompiledSpan* const span = held_[n];
    if (span != nullptr && in_reach(span->from)) since = std::max(since.value_or(span->from), span->from);
    i = parent_[n];
  }
  return std::nullopt;
}

void Evaluator::reach(std::uint32_t hand, Asking& asking) {
  const std::uint32_t object = compiled_.nodes[hand].object;
  std::vector<std::uint32_t> chain = joints_of(hand);
  // If the hand has picked up its goal, the goal moves with it. Then the hand reaches for the place where the goal was.
  const auto in_world = [&](std::uint32_t i) {
    const auto since = held_since(i, hand, chain);
    return translation_of(since ? placement(compiled_, i, *since - Time{1}, asking).in_world() : world(i));
  };
  const auto aim = [&](FunctionId f) { return compiled_.aim(object, f, now_, numbers_.data(), in_world, asking); };
  const double share = std::clamp(numbers_[compiled_.find(object, fn::reach_share).offset], 0.0, 1.0);
  const auto goal = share > 0 ? aim(fn::reach) : std::nullopt;
  if (!goal || chain.empty()) return;
  asking.work(20 * chain.size() * chain.size());
  const Mat4 first = world(chain.front());
  chain.push_back(hand);
  std::vector<Vec3> places;
  for (const std::uint32_t node : chain) places.push_back(joint_place(node));
  places = solve_ik(std::move(places), {*goal, aim(fn::reach_pole), share, transform_vector(first, {1, 0, 0})});
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const Vec3 from = joint_place(chain[i + 1]) - joint_place(chain[i]), to = places[i + 1] - places[i];
    const double numbers[] = {from.x, from.y, from.z, to.x, to.y, to.z};
    if (!finite(numbers)) return;
    turn_joint(chain[i], shortest_turn(from, to));
    each_below(chain[i], [&](std::uint32_t below) {
      if (below != chain[i]) compose(below);
    });
  }
}

// Sorts the objects that reach for something: each comes after those that move its goal or its chain.
void Evaluator::arrange_reaches() {
  std::vector<std::vector<std::uint32_t>> moved_by(parent_.size());
  for (const std::uint32_t eye : eyes_) {
    if (compiled_.nodes[eye].looks) moved_by[eye].push_back(eye);
    if (compiled_.nodes[eye].reaches)
      for (const std::uint32_t joint : joints_of(eye)) moved_by[joint].push_back(eye);
  }
  std::vector<std::uint32_t> order;
  std::vector<std::uint8_t> seen(parent_.size());
  const std::function<void(std::uint32_t)> put = [&](std::uint32_t eye) {
    if (std::exchange(seen[eye], 1)) return;
    const auto wait = [&](std::uint32_t node) {
      for (auto i = static_cast<std::int32_t>(node); i >= 0; i = parent_[static_cast<std::size_t>(i)])
        for (const std::uint32_t other : moved_by[static_cast<std::size_t>(i)]) put(other);
    };
    if (compiled_.nodes[eye].reaches) {
      for (const FunctionId f : {FunctionId{fn::reach}, FunctionId{fn::reach_pole}})
        for (const std::uint32_t goal : compiled_.goals(compiled_.nodes[eye].object, f)) wait(goal);
      const auto joints = joints_of(eye);
      if (!joints.empty() && parent_[joints.front()] >= 0) wait(static_cast<std::uint32_t>(parent_[joints.front()]));
    }
    order.push_back(eye);
  };
  for (const std::uint32_t eye : eyes_) put(eye);
  eyes_ = std::move(order);
}

void find_joints(CompiledFilm& film) {
  std::vector<Node>& nodes = film.nodes;
  const auto mark_all = [&] {
    for (Node& n : nodes) n.bends = true;
  };
  for (std::uint32_t hand = 0; hand < nodes.size(); ++hand) {
    if (!nodes[hand].reaches) continue;
    std::vector<std::uint32_t> level{hand};
    for (int bone = 0; bone < nodes[hand].reaches && !level.empty(); ++bone) {
      std::vector<std::uint32_t> above;
      for (const std::uint32_t node : level)
        for (std::uint32_t k = 0; k < nodes[node].spans; ++k) {
          const CompiledSpan& span = film.spans[nodes[node].first_span + k];
          if (span.computed) return mark_all();  // code may choose any parent
          if (span.kind < AttachmentKind::hang || span.parent < 0) continue;
          above.push_back(static_cast<std::uint32_t>(span.parent));
          nodes[above.back()].bends = true;
        }
      std::sort(above.begin(), above.end());
      above.erase(std::unique(above.begin(), above.end()), above.end());
      level = std::move(above);
    }
  }
}

// Returns the rotation that the node itself would need for its present pose.
Quat Evaluator::own_turn(std::uint32_t node) const {
  const CompiledSpan* const h = held_[node];
  const Frozen* const f = h && h->frozen >= 0 ? &compiled_.frozen[static_cast<std::size_t>(h->frozen)] : nullptr;
  const std::int32_t above = parent_[node];
  const Placed parent = above >= 0 ? placed(static_cast<std::uint32_t>(above)) : Placed{};
  const Vec3 attach = vec3(&numbers_[compiled_.nodes[node].attach]);
  const Placed bare = hang(own_placed(node), attach, h, f, above >= 0 ? &parent : nullptr);
  const Quat own = said_by(compiled_.nodes[node], numbers_.data()).turn;
  return normalize(own * conjugate(turn_of(bare.world)) * turn_of(worlds_[node]));
}

std::vector<std::pair<ObjectId, Quat>> reached_turns(const Program::Compiled& c, ObjectId hand, Time t,
                                                     Asking& asking) {
  Evaluator all(c);
  all.to(t, asking);
  std::vector<std::pair<ObjectId, Quat>> out;
  for (const std::uint32_t joint : all.joints_of(c.node_of[hand.index]))
    out.emplace_back(ObjectId{c.nodes[joint].object}, all.own_turn(joint));
  return out;
}

}  // namespace betwixt

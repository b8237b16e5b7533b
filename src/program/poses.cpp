// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/pose.h"
#include "program/evaluator.h"

namespace betwixt {
namespace {

// `world` returns a node's world matrix, for the object and its parent.
template <class World>
Pose pose_of(const Program::Compiled& compiled, std::uint32_t object, Time t, Asking& asking, World&& world) {
  Pose pose;
  if (object >= compiled.node_of.size() || compiled.node_of[object] == ObjectId::nothing) return pose;
  const Node& n = compiled.nodes[compiled.node_of[object]];
  if (!placed(n.kind)) return pose;
  pose.world = world(compiled.node_of[object]);
  pose.local = pose.world;
  const CompiledSpan span = held(compiled, compiled.node_of[object], t, asking);
  pose.attachment = span.kind;
  if (span.parent < 0) return pose;
  const auto parent = static_cast<std::uint32_t>(span.parent);
  pose.parent = {compiled.nodes[parent].object};
  pose.local = inverse(world(parent));
  if (pose.local) pose.local = *pose.local * pose.world;
  return pose;
}

}  // namespace

Pose pose(const Program& program, ObjectId id, Time t) {
  const Program::Compiled& compiled = program.compiled();
  Asking asking;
  return pose_of(compiled, id.index, t, asking,
                 [&](std::uint32_t node) { return placement(compiled, node, t, asking).in_world(); });
}

std::vector<Pose> poses(const Program& program, Time t) {
  const Program::Compiled& compiled = program.compiled();
  Asking asking;
  Evaluator all(compiled);
  all.to(t, asking);
  std::vector<Pose> out;
  out.reserve(compiled.node_of.size());
  for (std::uint32_t i = 0; i < compiled.node_of.size(); ++i)
    out.push_back(pose_of(compiled, i, t, asking, [&](std::uint32_t node) { return all.world(node); }));
  return out;
}

ObjectId camera(const Program& program, Time t) {
  const auto object = program.compiled().camera_at(t);
  return object ? ObjectId{*object} : ObjectId{};
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Skins: meshes deformed by joints, or morphed to other shapes by weights.
#include <algorithm>
#include <cstring>

#include "program/compile.h"
#include "program/evaluator.h"
#include "program/needed.h"
#include "program/placing.h"

namespace betwixt {

std::optional<Skin> compile_skin(const CompiledFilm& compiled, std::uint32_t drawable) {
  const Scene& scene = compiled.document.scene();
  const Node& n = compiled.nodes[drawable];
  const Binding& file = compiled.find(n.object, fn::file);
  if (n.kind != Kind::mesh || file.varies()) return std::nullopt;
  const auto mesh = scene.meshes->find(*std::get<Text>(file.constant));
  if (mesh == scene.meshes->end() || !mesh->second->rig) return std::nullopt;
  Skin skin{drawable, mesh->second, {}, {}};
  const Rig& rig = *mesh->second->rig;
  const auto* names = std::get_if<Names>(&compiled.find(n.object, fn::joints).constant);
  bool moved = false;
  if (names && (*names)->size() == rig.inverse_bind.size())
    for (const std::string& name : **names) {
      const ObjectId id = scene.names.find(name);
      const std::uint32_t node = id ? compiled.node_of[id.index] : ObjectId::nothing;
      skin.joints.push_back(node == ObjectId::nothing ? -1 : static_cast<std::int32_t>(node));
      moved = true;
    }
  for (const Rig::Target& t : rig.targets) {
    const auto f = find_function(scene, Kind::mesh, t.name);
    const Binding* b = f ? &compiled.find(n.object, *f) : nullptr;
    skin.weights.push_back(b && b->channels == 1 ? b : nullptr);
    moved = moved || skin.weights.back() != nullptr;
  }
  return moved ? std::optional(std::move(skin)) : std::nullopt;
}

namespace {

// Returns the joint matrices, or none if the mesh is flattened. `world`: returns a node's transform.
template <class World>
std::vector<Mat4> palette_of(const Skin& skin, World&& world) {
  std::vector<Mat4> all;
  if (skin.joints.empty()) return all;
  const auto own = inverse(world(skin.drawable));
  for (std::size_t j = 0; own && j < skin.joints.size(); ++j)
    all.push_back(skin.joints[j] < 0
                      ? Mat4{}
                      : *own * world(static_cast<std::uint32_t>(skin.joints[j])) * skin.rest->rig->inverse_bind[j]);
  return all;
}

}  // namespace

// Computes the joint matrices of each skin, and marks the skins whose matrices have changed.
void Evaluator::follow_joints() {
  palettes_.resize(compiled_.skins.size());
  for (std::size_t i = 0; i < palettes_.size(); ++i) {
    const Skin& skin = compiled_.skins[i];
    if (deferred_ && compiled_.drawables[skin.drawable].slow >= 0) continue;
    std::vector<Mat4> now = palette_of(skin, [&](std::uint32_t node) { return world(node); });
    std::vector<Mat4>& was = palettes_[i];
    const auto same = [](const Mat4& a, const Mat4& b) { return std::memcmp(&a, &b, sizeof a) == 0; };
    if (std::equal(now.begin(), now.end(), was.begin(), was.end(), same)) continue;
    was = std::move(now);
    marks_.add(skin.drawable, affects::form);
  }
}

std::shared_ptr<const Mesh> Evaluator::posed(std::int32_t skin_number) const {
  const Skin& skin = compiled_.skins[static_cast<std::size_t>(skin_number)];
  std::vector<double> weights;
  for (const Binding* b : skin.weights) weights.push_back(b ? numbers_[b->offset] : 0);
  return deformed(*skin.rest, weights, palettes_[static_cast<std::size_t>(skin_number)]);
}

std::shared_ptr<const Mesh> Program::Compiled::posed(std::int32_t skin_number, Time t, Asking& asking) const {
  const Skin& skin = skins[static_cast<std::size_t>(skin_number)];
  std::vector<double> weights;
  for (const Binding* b : skin.weights) {
    double n[4] = {};
    if (b) evaluate(*b, t, asking, n);
    weights.push_back(n[0]);
  }
  std::optional<Evaluator> all;  // with look-at or inverse kinematics, the joints are cheaper together
  if (looks && !skin.joints.empty()) {
    std::vector<std::uint32_t> nodes{skin.drawable};
    for (const std::int32_t joint : skin.joints)
      if (joint >= 0) nodes.push_back(static_cast<std::uint32_t>(joint));
    all.emplace(*this).place(t, asking, needed(*this, nodes, true, t, asking));
  }
  const auto world = [&](std::uint32_t node) {
    if (all) return all->world(node);
    const Sited placed = placement(*this, node, t, asking);
    return sited ? placed.in_world() : placed.world;
  };
  return deformed(*skin.rest, weights, palette_of(skin, world));
}

}  // namespace betwixt

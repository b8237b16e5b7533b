// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/rig.h"

#include "scene/topology.h"

namespace betwixt {
namespace {

void add(Rig::Vectors& to, const Rig::Vectors& what, double weight) {
  if (what.size() != to.size()) return;
  const auto w = static_cast<float>(weight);
  for (std::size_t i = 0; i < to.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) to[i][k] += w * what[i][k];
}

// The first three rows; a vertex is moved by the weighted sum of its joints' matrices.
using Rows = std::array<double, 12>;

Rows rows_of(const Mat4& m) {
  Rows out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) out[static_cast<std::size_t>(4 * r + c)] = m(r, c);
  return out;
}

Vec3 moved(const Rows& m, Vec3 v, double place) {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z + place * m[3], m[4] * v.x + m[5] * v.y + m[6] * v.z + place * m[7],
          m[8] * v.x + m[9] * v.y + m[10] * v.z + place * m[11]};
}

}  // namespace

std::shared_ptr<const Mesh> deformed(const Mesh& mesh, std::span<const double> weights, std::span<const Mat4> palette) {
  const Rig& rig = *mesh.rig;
  auto out = std::make_shared<Mesh>(mesh);
  out->posed = true, out->rig = nullptr;
  for (std::size_t i = 0; i < rig.targets.size(); ++i) {
    if (weights[i] == 0) continue;
    add(out->positions, rig.targets[i].positions, weights[i]);
    add(out->normals, rig.targets[i].normals, weights[i]);
  }
  if (palette.empty()) {
    for (auto& n : out->normals) n = narrow(normalize(widen(n), {0, 0, 1}));
    return out;
  }
  std::vector<Rows> joints;
  for (const Mat4& m : palette) joints.push_back(rows_of(m));
  for (std::size_t v = 0; v < out->positions.size(); ++v) {
    Rows all{};
    for (std::size_t k = 0; k < 4; ++k)
      if (const double w = rig.weights[v][k]; w != 0)
        for (std::size_t i = 0; i < all.size(); ++i) all[i] += w * joints[rig.joints[v][k]][i];
    out->positions[v] = narrow(moved(all, widen(out->positions[v]), 1));
    out->normals[v] = narrow(normalize(moved(all, widen(out->normals[v]), 0), widen(out->normals[v])));
  }
  return out;
}

}  // namespace betwixt

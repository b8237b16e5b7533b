// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The deformation of a mesh: by joints that its vertices follow, and by weights of target shapes (morphs).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "betwixt/mesh.h"

namespace betwixt {

struct Rig {
  using Vectors = std::vector<std::array<float, 3>>;

  std::vector<std::array<std::uint16_t, 4>> joints;  // of each vertex, indices into `inverse_bind`; or empty
  std::vector<std::array<float, 4>> weights;         // as many; they add up to 1 for each vertex
  std::vector<Mat4> inverse_bind;                    // from the mesh's space to that of each joint, at rest

  struct Target {
    std::string name;   // of the display function with its weight
    Vectors positions;  // offsets at weight 1: as many as the mesh has, or empty
    Vectors normals;
  };
  std::vector<Target> targets;
};

// Returns the mesh with `weights` of the targets (as many), then moved by the joints. `palette` has, for each joint,
// the matrix from the mesh's space to its present place; if empty, the joints do not move it.
std::shared_ptr<const Mesh> deformed(const Mesh&, std::span<const double> weights, std::span<const Mat4> palette);

}  // namespace betwixt

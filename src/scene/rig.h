// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How a mesh is deformed: by joints that its vertices follow, and by weights of other shapes that it may go over to.
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

  std::vector<std::array<std::uint16_t, 4>> joints;  // of each vertex, numbers in `inverse_bind`; or none at all
  std::vector<std::array<float, 4>> weights;         // as many; of each vertex 1 in all
  std::vector<Mat4> inverse_bind;                    // from the mesh's space to that of each joint, at rest

  struct Target {
    std::string name;   // of the display function that is its weight
    Vectors positions;  // what is added where the weight is 1: as many as the mesh has, or none
    Vectors normals;
  };
  std::vector<Target> targets;
};

// The mesh with `weights` of the targets (as many), then moved by the joints: `palette` has of each joint what takes
// the mesh's space to where the joint has it. None: it stays where the targets have put it.
std::shared_ptr<const Mesh> deformed(const Mesh&, std::span<const double> weights, std::span<const Mat4> palette);

}  // namespace betwixt

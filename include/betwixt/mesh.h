// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Triangle meshes in f32 for the graphics interface, and pictures as bytes.
//
// Room: scene
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "betwixt/math.h"

namespace betwixt {

// Eight bits a channel, sRGB, straight alpha, rows from the top, four bytes a pixel: r g b a.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

// A range of triangles that share colour and texture.
struct MeshPart {
  std::uint32_t first = 0, count = 0;      // indices into Mesh::triangles
  std::array<float, 3> color{1, 1, 1};     // linear light
  std::shared_ptr<const Picture> texture;  // null if it has none
  bool tinted = true;                      // whether the object's own colour multiplies it
  bool stroke = false;                     // whether it is the stroke of a flat shape
};

struct Rig;  // src/scene/rig.h

struct Mesh {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;  // as many as positions, unit length
  std::vector<std::array<float, 2>> uvs;      // as many as positions, or empty; (0 0) is the top left of the texture
  std::vector<std::uint32_t> triangles;       // three indices a triangle, counter-clockwise from outside
  std::vector<std::uint32_t> edges;           // two indices an edge, for wireframe
  std::vector<MeshPart> parts;                // cover `triangles`; if empty, the mesh is one plain part
  bool closed = false;                        // whether back faces may be culled, because the inside can never be seen
  std::shared_ptr<const Rig> rig;             // the joints and weights that deform it; null if there are none
  bool posed = false;                         // whether this is a deformed pose, which will soon be replaced by another

  Box box() const;  // an empty mesh has a box at the origin
};

}  // namespace betwixt

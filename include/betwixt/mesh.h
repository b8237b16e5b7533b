// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Triangles, ready for the graphics interface (f32 begins here), and pictures as bytes.
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

// A run of triangles that share a look.
struct MeshPart {
  std::uint32_t first = 0, count = 0;      // in indices, into Mesh::triangles
  std::array<float, 3> color{1, 1, 1};     // linear light
  std::shared_ptr<const Picture> texture;  // may be null
  bool tinted = true;                      // the object's own colour multiplies it
};

struct Rig;  // src/scene/rig.h

struct Mesh {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<float, 3>> normals;  // as many as positions, unit length
  std::vector<std::array<float, 2>> uvs;      // as many as positions, or none; (0 0) is the picture's top left
  std::vector<std::uint32_t> triangles;       // three indices a triangle, counter-clockwise from outside
  std::vector<std::uint32_t> edges;           // two indices an edge: what wireframe draws
  std::vector<MeshPart> parts;                // covers `triangles`; empty: one plain part
  bool closed = false;                        // no inside can be seen: back faces may be culled
  std::shared_ptr<const Rig> rig;             // how joints and weights deform it; null: they do not
  bool posed = false;                         // it has been deformed, and will be otherwise a moment later

  Box box() const;  // the origin, where there is nothing
};

}  // namespace betwixt

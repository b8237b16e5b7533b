// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes and textures that live in the graphics memory: sent once, when they are first drawn, and kept as long as
// somebody holds them.
#pragma once

#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

#include "betwixt/mesh.h"
#include "render/gl.h"

namespace betwixt {

struct StoredTexture {
  std::shared_ptr<const Picture> picture;
  gl::Texture texture;
  bool see_through = false;  // has a pixel that is not solid
};

struct StoredPart {
  std::uint32_t first = 0, count = 0;  // as MeshPart's
  std::array<float, 3> color{1, 1, 1};
  bool tinted = true;
  std::shared_ptr<const StoredTexture> texture;  // may be null
};

struct StoredMesh {
  std::shared_ptr<const Mesh> mesh;
  Box box;
  std::vector<StoredPart> parts;  // at least one where there are triangles; all within bounds
  bool see_through = false;       // one has a texture that is
  gl::VertexArray triangles, edges;
  gl::Buffer vertices, indices, edge_vertices, edge_indices;
  GLsizei edge_count = 0;
};

// Where a program finds its inputs: of a mesh's vertices, of an edge's corners, and the first one of an instance's.
enum Attribute : GLuint {
  at_position = 0,
  at_normal = 1,
  at_uv = 2,
  at_start = 0,
  at_end = 1,
  at_corner = 2,
  at_instance = 3
};

class Store {
 public:
  std::shared_ptr<StoredMesh> mesh(const std::shared_ptr<const Mesh>&);
  std::shared_ptr<const StoredTexture> texture(const std::shared_ptr<const Picture>&);
  // A regular polygon on the unit circle: what balls are drawn with (see balls.h), for those that reach so many pixels.
  const std::shared_ptr<StoredMesh>& disc(double radius);

  // Sends the triangles; what draws the edges as broad lines: four corners an edge, each knowing both ends.
  static void need_triangles(StoredMesh&);
  static void need_edges(StoredMesh&);

 private:
  // What somebody holds, by what it was made from. The others are forgotten whenever it has doubled.
  template <class Source, class Stored>
  struct Kept {
    std::unordered_map<const Source*, std::weak_ptr<Stored>> all;
    std::size_t limit = 64;
    std::weak_ptr<Stored>& at(const Source*);
  };
  Kept<Mesh, StoredMesh> meshes_;
  Kept<Picture, const StoredTexture> textures_;
  std::shared_ptr<StoredMesh> latest_, discs_[4];
};

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes and textures that live in the graphics memory: sent once, dropped when a few frames went by without them.
#pragma once

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
  std::uint64_t used = 0;
};

struct StoredMesh {
  std::shared_ptr<const Mesh> mesh;
  Box box;
  std::vector<MeshPart> parts;  // at least one where there are triangles; all within bounds
  gl::VertexArray triangles, edges;
  gl::Buffer vertices, indices, edge_vertices, edge_indices;
  GLsizei edge_count = 0;
  std::uint64_t used = 0;
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
  void next_frame();  // forgets what was not used for a while
  StoredMesh& mesh(const std::shared_ptr<const Mesh>&);
  const StoredTexture& texture(const std::shared_ptr<const Picture>&);
  // A regular polygon on the unit circle: what balls are drawn with (see balls.h). `detail` 0 to 2.
  StoredMesh& disc(int detail);
  // Sends what draws the edges as broad lines: four corners an edge, each knowing both ends.
  void need_edges(StoredMesh&);

 private:
  std::unordered_map<const Mesh*, StoredMesh> meshes_;
  std::unordered_map<const Picture*, StoredTexture> textures_;
  std::uint64_t frame_ = 0;
  StoredMesh* latest_ = nullptr;
  std::shared_ptr<const Mesh> discs_[3];
};

}  // namespace betwixt

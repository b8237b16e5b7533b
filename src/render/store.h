// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes and textures in graphics memory. They are sent when they are first drawn, and kept as long as they are in use.
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
  mutable gl::Texture texture;  // sent by need_texture()
  mutable bool sent = false;
  mutable gl::Texture numbers;  // the same as numbers, not as sRGB; sent by need_plain_texture()
  mutable bool numbers_sent = false;
  bool see_through = false;  // whether a pixel is not opaque
};

struct StoredPart {
  std::uint32_t first = 0, count = 0;  // as in MeshPart
  std::array<float, 3> color{1, 1, 1};
  bool tinted = true, stroke = false;
  std::shared_ptr<const StoredTexture> texture;  // null if it has none
};

struct StoredMesh {
  std::shared_ptr<const Mesh> mesh;
  Box box;
  std::vector<StoredPart> parts;  // at least one if there are triangles; all within bounds
  bool see_through = false;       // whether one of the textures is
  gl::VertexArray triangles, edges;
  gl::Buffer vertices, indices, edge_vertices, edge_indices;
  GLsizei edge_count = 0;
  std::vector<std::uint32_t> twins;  // see need_twins()
};

// The locations of a program's inputs: a mesh's vertices, an edge's corners, and the first one of an instance.
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
  // Returns a regular polygon on the unit circle, for balls (see balls.h) of this radius in pixels.
  const std::shared_ptr<StoredMesh>& disc(double radius);

  // Sends the triangles. Wide lines have four corners for an edge, each with both ends.
  static void need_triangles(StoredMesh&);
  static void need_edges(StoredMesh&);
  // Finds for each edge of each triangle (3 * triangle + 0 to 2) the same edge of another one, in the other direction;
  // an edge without one is its own twin.
  static void need_twins(StoredMesh&);
  // Returns the texture's id; 0 if its picture is not valid.
  static GLuint need_texture(const StoredTexture&);
  // The same for pictures of numbers, such as normals.
  static GLuint need_plain_texture(const StoredTexture&);

 private:
  // Objects in use, by their sources. Unused ones are dropped whenever the map has doubled.
  template <class Source, class Stored>
  struct Kept {
    std::unordered_map<const Source*, std::weak_ptr<Stored>> all;
    std::size_t limit = 64;
    std::weak_ptr<Stored>& at(const Source*);
  };
  Kept<Mesh, StoredMesh> meshes_;
  Kept<Picture, const StoredTexture> textures_;
  std::shared_ptr<StoredMesh> latest_, discs_[5];
};

}  // namespace betwixt

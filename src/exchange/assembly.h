// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene's meshes become one. What is common to all mesh files: checks, normals, edges, joining.
#pragma once

#include <memory>
#include <string>

#include "betwixt/math.h"
#include "betwixt/mesh.h"
#include "betwixt/result.h"
#include "exchange/meshes.h"

namespace betwixt {

class Assembly {
 public:
  explicit Assembly(std::string path) : path_(std::move(path)) {}

  // A mesh in its own space: positions and triangles; normals and uvs as many as positions, or none; edges as drawn, or
  // none. Of `look` only the color and the texture count. Errors: file.
  Status add(Mesh piece, const Mat4& to_scene, MeshPart look);
  Result<std::shared_ptr<const Mesh>> finish() &&;

  Error error(const std::string& what) const;  // "PATH is broken: what"

 private:
  std::string path_;
  Mesh mesh_;
};

Result<std::shared_ptr<const Mesh>> load_gltf(const std::string& path, Shelf&);
Result<std::shared_ptr<const Mesh>> load_ply(const std::string& path, Shelf&);
Result<std::shared_ptr<const Mesh>> load_by_assimp(const std::string& path, Shelf&);

}  // namespace betwixt

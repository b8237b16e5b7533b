// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A scene's meshes become one. What is common to all mesh files: checks, normals, edges, joining.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "betwixt/math.h"
#include "betwixt/mesh.h"
#include "betwixt/result.h"
#include "exchange/meshes.h"
#include "scene/rig.h"

namespace betwixt {

class Assembly {
 public:
  // Of a mesh that brings no normals: smooth but for creases, or each face by itself, as glTF demands.
  enum class Normals : std::uint8_t { creased, flat };
  // `as`: what the file is read as.
  explicit Assembly(std::string path, std::string as = "mesh", Normals missing = Normals::creased)
      : path_(std::move(path)), as_(std::move(as)), missing_(missing) {}

  // A mesh in its own space: positions and triangles; normals and uvs as many as positions, or none; edges as drawn, or
  // none. Of `look` only the color and the texture count. A piece with a `rig` keeps its vertices; all pieces then have
  // one, with as many targets. Errors: file.
  Status add(Mesh piece, const Mat4& to_scene, MeshPart look);
  Status add(Mesh piece, const Mat4& to_scene, MeshPart look, Rig rig);
  Result<std::shared_ptr<const Mesh>> finish() &&;

  Error error(const std::string& what) const;  // "PATH cannot be read as a mesh: what"

 private:
  Status append(Mesh piece, const Mat4& to_scene, MeshPart look, Rig* rig);
  void take(Rig);

  std::string path_, as_;
  Normals missing_;
  Mesh mesh_;
  std::optional<Rig> rig_;
  std::size_t rig_size_ = 0;  // vertices that it speaks of
};

Result<std::shared_ptr<const Mesh>> load_gltf(const std::string& path, Shelf&);
Result<std::shared_ptr<const Mesh>> load_ply(const std::string& path, Shelf&);
Result<std::shared_ptr<const Mesh>> load_by_assimp(const std::string& path, Shelf&);

}  // namespace betwixt

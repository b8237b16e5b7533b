// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Joins a scene's meshes to one. The common steps of all mesh formats: checks, normals, edges, joining.
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
  // Normals of a mesh that has none: `creased`: smooth except at creases; `flat`: one for each face, as glTF demands.
  enum class Normals : std::uint8_t { creased, flat };
  // `as`: the expected kind of file, for errors.
  explicit Assembly(std::string path, std::string as = "mesh", Normals missing = Normals::creased)
      : path_(std::move(path)), as_(std::move(as)), missing_(missing) {}

  // Adds a mesh in its own space: positions and triangles; one normal and one uv for each position, or none; edges to
  // draw, or none. Only the color and texture of `look` are used. A piece with a `rig` keeps its vertices; all pieces
  // must then have a rig with the same number of targets. Errors: file, range (unpacking.h).
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
  std::size_t rig_size_ = 0;  // the vertices that it covers
};

Result<std::shared_ptr<const Mesh>> load_gltf(const std::string& path, FileSource&);
Result<std::shared_ptr<const Mesh>> load_ply(const std::string& path, FileSource&);
Result<std::shared_ptr<const Mesh>> load_by_assimp(const std::string& path, FileSource&);

}  // namespace betwixt

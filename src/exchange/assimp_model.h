// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A file read by assimp and triangulated, with the queries that meshes and scenes share.
#pragma once

#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "exchange/assembly.h"

namespace betwixt {

class AssimpModel {
 public:
  // `as`: the expected kind of file, for errors. A scene need not have meshes. Errors: file.
  static Result<std::unique_ptr<AssimpModel>> open(const std::string& path, FileSource&, const std::string& as);
  AssimpModel(std::string path, FileSource&, std::string as);

  const aiScene& scene() const { return *scene_; }
  Error error(const std::string& what) const { return Assembly(path_, as_).error(what); }
  const std::string& path() const { return path_; }

  static Mat4 matrix(const aiMatrix4x4&);
  Mat4 upright() const;  // FBX gives the up axis but leaves the rotation to the reader
  Mesh piece(unsigned mesh) const;
  MeshPart look(unsigned material);

 private:
  Status read(bool textures, bool bare);
  std::shared_ptr<const Picture> texture(const aiString& name);

  std::string path_, as_;
  FileSource& files_;
  Assimp::Importer importer_;
  const aiScene* scene_ = nullptr;
  std::vector<std::vector<std::uint32_t>> edges_;  // by mesh
  std::map<std::string, std::shared_ptr<const Picture>> pictures_;
};

}  // namespace betwixt

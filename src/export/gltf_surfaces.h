// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes, materials and pictures of a glTF file, each once.
#pragma once

#include <unordered_map>

#include "export/gltf_parts.h"
#include "export/seen.h"
#include "scene/rig.h"

namespace betwixt::gltf {

class Surfaces {
 public:
  Surfaces(const Program& program, const ExportOptions& options, Timeline& film)
      : program_(program), options_(options), film_(film) {}

  // Adds one of the forms of an object. Returns the number of the mesh.
  Result<std::size_t> add_mesh(const Seen&, std::size_t form, const std::string& name);

  Json meshes = Json::array(), materials = Json::array(), textures = Json::array(), images = Json::array();

 private:
  Json attributes_of(const Seen::Form&);
  void add_rig(const Rig&, bool joints, Json& attributes, Json& targets);
  std::size_t indices(std::vector<std::uint32_t>);
  Result<std::size_t> material(const Seen&, const MeshPart&, const std::string& name);
  Channel colors(const Seen&, const std::array<double, 4>& tint, bool tinted) const;
  Result<std::size_t> add_texture(const std::shared_ptr<const Picture>&);
  Status add_finish(const Finish&, Json& material);
  bool flat_film();

  const Program& program_;
  const ExportOptions& options_;
  Timeline& film_;
  std::optional<bool> flat_;
  std::map<std::pair<const Mesh*, std::array<double, 16>>, Json> attributes_;
  std::map<std::vector<std::uint32_t>, std::size_t> indices_;
  std::unordered_map<std::string, std::size_t> meshes_known_, materials_known_;
  std::unordered_map<const Picture*, std::size_t> textures_known_;
  std::map<std::pair<const Picture*, const Picture*>, std::shared_ptr<const Picture>> packed_;  // roughness, metalness
  // Keeps their addresses from being reused.
  std::vector<std::shared_ptr<const Mesh>> kept_;
  std::vector<std::shared_ptr<const Picture>> pictures_;
};

}  // namespace betwixt::gltf

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "exchange/gltf_model.h"

namespace betwixt {

// Reads the whole scene as one mesh.
Result<std::shared_ptr<const Mesh>> load_gltf(const std::string& path, FileSource& files) {
  auto opened = GltfModel::open(path, files, "mesh");
  if (!opened) return opened.error();
  GltfModel& file = **opened;
  Assembly assembly(path, "mesh", Assembly::Normals::flat);
  std::vector<Mat4> worlds(file.model().nodes.size());
  const auto add = [&](const tinygltf::Primitive& primitive, const Mat4& world) -> Status {
    MeshPart look;
    std::string uv_set;
    if (const Status s = file.look(primitive.material, look, uv_set); !s) return s;
    auto piece = file.triangles(primitive, uv_set);
    return piece ? assembly.add(*std::move(piece), world, std::move(look)) : Status(piece.error());
  };
  const Status done = file.each_node([&](int i, int parent) -> Status {
    const tinygltf::Node& n = file.model().nodes[static_cast<std::size_t>(i)];
    Mat4& world = worlds[static_cast<std::size_t>(i)];
    world = GltfModel::transform(n);
    if (parent >= 0) world = worlds[static_cast<std::size_t>(parent)] * world;
    if (n.mesh < 0) return Nothing{};
    const tinygltf::Mesh* mesh = gltf_at(file.model().meshes, n.mesh);
    if (mesh == nullptr) return file.error(fmt::format("there is no mesh {}", n.mesh));
    for (const auto& primitive : mesh->primitives)
      if (const Status s = add(primitive, world); !s) return s;
    return Nothing{};
  });
  if (!done) return done.error();
  return std::move(assembly).finish();
}

}  // namespace betwixt

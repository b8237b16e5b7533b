// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/assimp_model.h"

namespace betwixt {

// Reads all nodes as one mesh.
Result<std::shared_ptr<const Mesh>> load_by_assimp(const std::string& path, FileSource& files) {
  auto opened = AssimpModel::open(path, files, "mesh");
  if (!opened) return opened.error();
  AssimpModel& file = **opened;
  const aiScene& scene = file.scene();
  Assembly assembly(path);
  std::vector<std::pair<const aiNode*, Mat4>> open{{scene.mRootNode, file.upright()}};
  while (!open.empty()) {
    const auto [node, parent] = open.back();
    open.pop_back();
    const Mat4 own = parent * AssimpModel::matrix(node->mTransformation);
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      const unsigned mesh = node->mMeshes[i];
      if (mesh >= scene.mNumMeshes) continue;
      if (const Status s = assembly.add(file.piece(mesh), own, file.look(scene.mMeshes[mesh]->mMaterialIndex)); !s)
        return s.error();
    }
    for (unsigned i = node->mNumChildren; i-- > 0;) open.emplace_back(node->mChildren[i], own);
  }
  return std::move(assembly).finish();
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes from files: glTF by tinygltf; PLY; OBJ, STL, DAE, FBX and 3DS by assimp.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

// Asked before any file is opened (buffers, textures, material libraries too): may this path be read?
using MayRead = std::function<bool(const std::string& path)>;

// All of the file's scene as one mesh, node transforms applied, y up, in the file's units. Errors: file.
Result<std::shared_ptr<const Mesh>> load_mesh(const std::string& path, const MayRead& may_read);

}  // namespace betwixt

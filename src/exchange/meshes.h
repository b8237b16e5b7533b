// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes from files: glTF by tinygltf; PLY; OBJ, STL, DAE, FBX and 3DS by assimp.
#pragma once

#include <memory>
#include <string>

#include "betwixt/mesh.h"
#include "betwixt/result.h"
#include "exchange/file_source.h"

namespace betwixt {

// Reads the file's whole scene as one mesh, in a process of its own: node transforms applied, y up, in the file's
// units. Errors: file.
Result<std::shared_ptr<const Mesh>> load_mesh(const std::string& path, const MayRead& may_read, bool any_size = false);
// Reads it in this process, without protection.
Result<std::shared_ptr<const Mesh>> parse_mesh(const std::string& path, FileSource&);

}  // namespace betwixt

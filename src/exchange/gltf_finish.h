// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The surface of a glTF material.
#pragma once

#include <functional>

#include "betwixt/finish.h"
#include "exchange/gltf_model.h"
#include "exchange/scene_file.h"

namespace betwixt {

using SayLeftOut = std::function<void(std::string)>;

// Reads the surface of a mesh: its material, shininess, transparency and finish; no finish if the first two say all of
// it. `uv_set`: that of its texture; pictures with other coordinates are left out. Errors: file.
Status put_surface(GltfModel&, const tinygltf::Material&, const std::string& uv_set, const SayLeftOut&, SceneMesh& to);

}  // namespace betwixt

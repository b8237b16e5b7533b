// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The finish of a glTF material.
#pragma once

#include <functional>

#include "betwixt/finish.h"
#include "exchange/gltf_model.h"

namespace betwixt {

using SayLeftOut = std::function<void(std::string)>;

// Returns null if the words metal and plastic, and a shininess, say all of it. `uv_set`: that of its texture; pictures
// with other coordinates are left out. Errors: file.
Result<std::shared_ptr<const Finish>> finish_of(GltfModel&, const tinygltf::Material&, const std::string& uv_set,
                                                const SayLeftOut&);

}  // namespace betwixt

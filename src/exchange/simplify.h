// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes with fewer triangles, for objects that are small in the picture.
#pragma once

#include <memory>

#include "betwixt/mesh.h"
#include "scene/kinds.h"

namespace betwixt {

// Returns a mesh with fewer triangles if it has far more of them than it can cover pixels. The result is off by at most
// a pixel and has no edges. Otherwise, or if `detail` asks for everything, returns the mesh itself. Results are shared
// while someone holds them. Safe from any thread.
std::shared_ptr<const Mesh> simplified(const std::shared_ptr<const Mesh>&, const Detail&);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Meshes with fewer triangles, for things that are small on the picture.
#pragma once

#include <memory>

#include "betwixt/mesh.h"
#include "scene/kinds.h"

namespace betwixt {

// Where a mesh has far more triangles than it can cover pixels: fewer of them, off by no more than a pixel, without
// edges. Else the mesh itself, and where all of it has been asked for. Remembered as long as somebody holds it. Safe
// from any thread.
std::shared_ptr<const Mesh> simplified(const std::shared_ptr<const Mesh>&, const Detail&);

}  // namespace betwixt

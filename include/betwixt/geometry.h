// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Drawn objects as triangles, for programs that export films.
//
// Room: exchange
#pragma once

#include <memory>

#include "betwixt/frame.h"

namespace betwixt {

// A mesh, and the matrix that scales it to the shape's size: spheres of any radius share one mesh.
struct Geometry {
  std::shared_ptr<const Mesh> mesh;  // never null; empty if nothing is drawn
  Mat4 local;                        // mesh space to object space (a scaling; for most shapes the identity)
};

// Returns the triangles of an item, also during a morph to another shape. `around` is the number of faces around the
// widest circle. Equal shapes get the same mesh as long as you hold it. Safe to call from any thread.
Geometry geometry_of(const Item&, int around = 48);

}  // namespace betwixt

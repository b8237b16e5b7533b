// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What is drawn, as triangles: for programs that hand films to others.
//
// Room: exchange
#pragma once

#include <memory>

#include "betwixt/frame.h"

namespace betwixt {

// A mesh and what stretches it to the shape's measures: spheres of any radius share one mesh.
struct Geometry {
  std::shared_ptr<const Mesh> mesh;  // never null; empty for what is not drawn
  Mat4 local;                        // mesh space to object space (a scaling, the identity for most)
};

// Of what an item looks like, on the way to another shape too; so many faces go around the widest circle. Equal shapes
// get the same mesh as long as somebody holds it. Safe from any thread.
Geometry geometry_of(const Item&, int around = 48);

}  // namespace betwixt

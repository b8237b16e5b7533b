// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The items of a frame, made ready to draw: meshes found, matrices relative to the eye, bounds known, rubbish left out.
#pragma once

#include <vector>

#include "render/store.h"
#include "render/view.h"

namespace betwixt {

struct Thing {
  const Item* item = nullptr;
  StoredMesh* mesh = nullptr;    // as detailed as its size on the picture asks for
  StoredMesh* coarse = nullptr;  // for shadows
  Mat4 local, coarse_local;      // mesh space to eye space
  Bounds bounds;
  double depth = 0;      // of the centre
  bool visible = false;  // perhaps in the picture
  bool transparent = false;
  bool mirrored = false;  // the matrix turns triangles inside out
  bool closed = false;    // its back faces are never seen
  bool ball = false;      // drawn as in balls.h; the meshes are discs
};

enum class Purpose : std::uint8_t { surfaces, lines };

// What there is to draw in a picture of that size; nothing where the camera's numbers cannot be used. Fits the view's
// depths to what is visible. Things come in the items' order. For `surfaces` spheres may come as
// balls; for `lines` meshes are coarser, since lines close together make only a grey.
std::vector<Thing> gather(const Frame&, int width, int height, Store&, Purpose, View&);

}  // namespace betwixt

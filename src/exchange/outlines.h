// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Closed contours become triangles here.
#pragma once

#include "betwixt/mesh.h"
#include "exchange/fonts.h"
#include "scene/strokes.h"

namespace betwixt {

// What counts as inside: what the contours go round at all, only what they go round counter-clockwise, or what they go
// round an odd number of times.
enum class Winding : std::uint8_t { nonzero, positive, odd };

// Twice the area as seen from `facing`; positive counter-clockwise.
double turn(const Contour&, Vec3 facing);
// Whether a point lies in it, in the plane.
bool contains(const Contour&, Vec3);

// An outer contour with its holes.
struct Island {
  Contour outer;
  Contours holes;
};
// What contours in the plane fill, in pieces that lie apart, their borders without crossings.
std::vector<Island> islands(const Contours&, Winding);

// Filled. With a depth, a closed body about the outline's plane: front, back and walls, smooth where the outline is.
Mesh fill(const Outline&, double depth = 0, Winding = Winding::nonzero);
// As a pen draws it. A stroke has a part of its own, and what is filled ends where it begins.
Mesh drawn(const Outline&, const Pen&, double depth, Winding);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts closed contours to triangles.
#pragma once

#include "betwixt/mesh.h"
#include "exchange/fonts.h"
#include "scene/strokes.h"

namespace betwixt {

// The filling rule: inside are the points that the contours enclose at all (nonzero), counter-clockwise (positive), or
// an odd number of times (odd).
enum class Winding : std::uint8_t { nonzero, positive, odd };

// Returns twice the signed area seen from `facing`; positive for counter-clockwise.
double turn(const Contour&, Vec3 facing);
// Returns whether the point is inside the contour, in the plane.
bool contains(const Contour&, Vec3);

// An outer contour with its holes.
struct Island {
  Contour outer;
  Contours holes;
};
// Returns the separate pieces that the contours fill in the plane. Their borders do not cross.
std::vector<Island> islands(const Contours&, Winding);

// Returns the filled outline. With a depth, a closed body about the outline's plane: front, back and walls, smooth
// where the outline is smooth.
Mesh fill(const Outline&, double depth = 0, Winding = Winding::nonzero);
// Returns the outline as drawn by a pen. A stroke is a separate part, and the filling ends where the stroke begins.
Mesh drawn(const Outline&, const Pen&, double depth, Winding);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Closed contours become triangles here.
#pragma once

#include "betwixt/mesh.h"
#include "exchange/fonts.h"

namespace betwixt {

// What counts as inside: what the contours go round at all, or only what they go round counter-clockwise.
enum class Winding : std::uint8_t { nonzero, positive };

// Where a (nearly) flat outline faces: +z if it lies in a plane of one z, else by the turn of its contours.
Vec3 facing(const Outline&);

// Filled. With a depth, a closed body about the outline's plane: front, back and walls, smooth where the outline is.
Mesh fill(const Outline&, double depth = 0, Winding = Winding::nonzero);

}  // namespace betwixt

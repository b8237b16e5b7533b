// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where an eye goes that is free: cameras from cameras.
#pragma once

#include "betwixt/frame.h"
#include "betwixt/pick.h"

namespace betwixt::studio {

// Around a place, upright: about the world's y axis and up, radians. It never tips over.
Camera orbited(const Camera&, Vec3 about, double around, double up);
// What is so far before the eye goes along with the hand, by parts of the picture (right, down).
Camera panned(const Camera&, double aspect, double dx, double dy, double depth);
// What is `factor` of the way to it; the place stays where it is in the picture.
Camera zoomed(const Camera&, Vec3 place, double factor);
// From a direction that is away from the eye, at a place that stays as far away.
Camera looking_along(const Camera&, Vec3 direction, Vec3 place, double distance);
// All of a box in a picture so wide by high.
Camera framed(const Camera&, const Box&, double aspect);
// Orthographic or not, with what is so far away as large as it was.
Camera with_perspective(const Camera&, bool, double aspect, double depth);
// The same seen in a larger picture: what was the whole one is a part of it, so wide and so high.
Camera widened(const Camera&, double part_of_width, double part_of_height);

}  // namespace betwixt::studio

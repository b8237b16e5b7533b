// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Moves of the free camera. Each function returns a new camera.
#pragma once

#include "betwixt/frame.h"
#include "betwixt/pick.h"

namespace betwixt::studio {

// Orbits around a place: `around` about the world's y axis, `up` in elevation, both in radians. The camera stays
// upright.
Camera orbited(const Camera&, Vec3 about, double around, double up);
// Pans so that points at `depth` follow the pointer; dx and dy are parts of the picture, to the right and down.
Camera panned(const Camera&, double aspect, double dx, double dy, double depth);
// Dollies, so that the distance to a place is multiplied by `factor`; the place stays where it is in the picture.
Camera zoomed(const Camera&, Vec3 place, double factor);
// Looks in a direction, with `place` in the middle at this distance.
Camera looking_along(const Camera&, Vec3 direction, Vec3 place, double distance);
// Fits a box into a picture of this aspect ratio.
Camera framed(const Camera&, const Box&, double aspect);
// Switches between perspective and orthographic projection; objects at `depth` keep their size in the picture.
Camera with_perspective(const Camera&, bool, double aspect, double depth);
// Widens the view for a larger picture, of which the whole old one is the given part in width and height.
Camera widened(const Camera&, double part_of_width, double part_of_height);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Objects on axes: their position is given in the numbers of the axes.
#pragma once

#include "program/compiled.h"
#include "scene/axes.h"
#include "scene/kinds.h"

namespace betwixt {

// Returns the coordinates of axes, or of the axes that an object is on.
Result<AxesSpace> axes_space(const Program::Compiled&, ObjectId, Time, Asking&);
// Returns the axes that an object is on by `on`, or none.
ObjectId axes_of(const Scene&, const Object&);
// Returns whether the position of an object is numbers of axes. (A chart on axes puts only its pieces there.)
bool position_by_axes(const Scene&, const Object&);
// Returns code that computes the place of such an object from its position.
const Value& placed_by_axes();
// Returns whether the points of an object are numbers of axes. (The points of plots are places already.)
bool points_by_axes(const Scene&, const Object&);
// Returns the places of points that are numbers of axes; those without a place are breaks.
Points placed_points(const Program::Compiled&, std::uint32_t object, const Points&, Time, Asking&);

}  // namespace betwixt

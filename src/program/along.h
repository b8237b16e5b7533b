// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Objects that move along a line: where the line is, in the space of their positions.
#pragma once

#include "program/compiled.h"

namespace betwixt {

// Returns the point at a fraction of the length of an object's line, in world space.
Result<Vec3> place_on(const Program::Compiled&, std::string_view road, double share, double seconds, Asking&);
// Returns that point as the value of an object's position or rotation. Returns nullopt and reports the reason if there
// is none.
std::optional<Value> value_along(const Program::Compiled&, std::uint32_t object, FunctionId, ObjectId road,
                                 double share, Time, Asking&);

}  // namespace betwixt

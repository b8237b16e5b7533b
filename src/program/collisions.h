// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Collisions: the position of an object that cannot move through its obstacles. The path is computed in short steps
// from the beginning of the film, like a stepped procedure (steps.h); so it may read the past, and any frame can be
// asked for. Within a step, the time of a collision is found to the flick.
#pragma once

#include <memory>

#include "program/compiled.h"

namespace betwixt {

// Returns the law by which the position of a live value moves among its obstacles.
std::unique_ptr<NamedProcedure> make_collision(const Object&, std::int32_t live, std::string name);

// Returns the position that an object has among its obstacles. `free`: its position without them.
Vec3 among_obstacles(const Program::Compiled&, const Live&, Vec3 free, Time, Asking&);

}  // namespace betwixt

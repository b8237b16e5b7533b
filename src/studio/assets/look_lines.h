// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines that give objects a look or another shape.
#pragma once

#include <string>
#include <vector>

#include "betwixt/object.h"
#include "studio/timeline/event_lines.h"

namespace betwixt::studio {

// The kind of data that a dragged look has: "color gold" or "material metal".
inline constexpr const char* look_data = "application/x-betwixt-look";

// Gives objects a look: `set ball.color gold`. It is an event if the function has events, or if `makes_events`.
Lines look_lines(const Document&, const std::vector<ObjectId>&, const std::string& look, Time, bool makes_events);

// Gives objects the shape of a file: `set cow.file "dog.obj"`. An object of another kind gets it from a new hidden
// mesh: `create dog mesh file="dog.obj" display=off`, `set ball.geometry shape(dog)`. Everything else of it stays.
Lines shape_lines(const Document&, const std::vector<ObjectId>&, const std::string& path, const std::string& name);
// The same with the shape of a kind: `create box1 box display=off`, `set ball.geometry shape(box1)`. A kind of "" gives
// back their own shapes.
Lines kind_lines(const Document&, const std::vector<ObjectId>&, const std::string& kind);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sizes of objects at a time, as the picture shows them.
#pragma once

#include <vector>

#include "betwixt/math.h"
#include "scene/document.h"

namespace betwixt {

// The bounds of an object in the world, with everything attached to it.
struct Measured {
  ObjectId id;
  Vec3 low, high;
  Mat4 to_world;  // from the space of its position
  Vec3 position;  // its own
  Mat4 world;     // from its own space
  bool any = false;
  Vec3 middle() const { return 0.5 * (low + high); }
  Vec3 size() const { return high - low; }
};
std::vector<Measured> measured(const Scene&, const std::vector<ObjectId>&, Time);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The patterns of materials (patterns.inc), as text for shaders and as functions.
#pragma once

#include "betwixt/finish.h"

namespace betwixt {

extern const char* const pattern_shader;

// What a pattern makes of a surface at a point of the object space.
struct PatternPoint {
  Vec3 color;
  double roughness = 0, metalness = 0;
  double height = 0;  // of its bumps, in the pattern's own units
};
// `width`: how wide a pixel is there, in object space. Details that are finer are left out.
PatternPoint pattern_at(const Finish&, Vec3 color, Vec3 at, Vec3 normal, double width);
// The mean over a body, for those who have no patterns.
PatternPoint mean_of_pattern(const Finish&, Vec3 color);

}  // namespace betwixt

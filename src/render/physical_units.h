// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The texture units of physical surfaces, and vectors as shaders want them.
#pragma once

#include <array>

#include "betwixt/math.h"

namespace betwixt {

// Texture units.
inline constexpr int picture_at = 0, shadows_at = 1, depths_at = 2, around_at = 3, behind_at = 4, normals_at = 5,
                     roughness_at = 6, metalness_at = 7, occlusion_at = 8, emission_at = 9, seen_at = 10, slide_at = 11,
                     behind_depth_at = 12;
inline std::array<float, 4> four(Vec3 v, double w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

}  // namespace betwixt

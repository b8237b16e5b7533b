// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers for tests of meshes.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "scene/primitives.h"
#include "scene/topology.h"

namespace betwixt {

inline void expect_sound(const Mesh& m, const char* what) {
  ASSERT_EQ(m.normals.size(), m.positions.size()) << what;
  EXPECT_TRUE(m.uvs.empty() || m.uvs.size() == m.positions.size()) << what;
  for (const auto& n : m.normals) EXPECT_NEAR(length(widen(n)), 1, 1e-6) << what;
  for (const auto& uv : m.uvs)
    for (const float f : uv) EXPECT_TRUE(f >= 0 && f <= 1) << what << " " << f;
  for (const auto i : m.triangles) ASSERT_LT(i, m.positions.size()) << what;
  for (const auto i : m.edges) ASSERT_LT(i, m.positions.size()) << what;
  for (std::size_t i = 0; i < m.triangles.size(); i += 3) {  // normals and triangles face the same way
    const auto at = [&](std::size_t k) { return widen(m.positions[m.triangles[i + k]]); };
    const Vec3 face = cross(at(1) - at(0), at(2) - at(0));
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_GT(dot(face, widen(m.normals[m.triangles[i + k]])), 0) << what << " " << i;
  }
}

}  // namespace betwixt

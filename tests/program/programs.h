// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Short functions that compile scenes and read their frames.
#pragma once

#include <gtest/gtest.h>

#include "betwixt/program.h"
#include "support/objects.h"

namespace betwixt {

inline Program compile(const Scene& s) { return Program::compile(Document(std::make_shared<const Scene>(s))); }
inline Mat4 world(const Program& p, ObjectId id, double seconds = 0) {
  return *std::get<Matrix>(p.read({id, Query::world}, from_seconds(seconds)));
}
inline void expect_near(const Mat4& a, const Mat4& b, double by = 1e-12) {
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(a.m[i], b.m[i], by) << i;
}
inline void expect_near(Vec3 a, Vec3 b, double by = 1e-12) {
  EXPECT_NEAR(length(a - b), 0, by) << a.x << " " << a.y << " " << a.z;
}

}  // namespace betwixt

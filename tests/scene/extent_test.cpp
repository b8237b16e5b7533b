// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/extent.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

TEST(Extent, HoldsTheShape) {
  Shape s;
  s.kind = Kind::torus;
  EXPECT_EQ(extent(s).high, (Vec3{1.3, 0.3, 1.3}));
  s.kind = Kind::plane;
  s.size = {4, 2, 1};
  EXPECT_EQ(extent(s).low, (Vec3{-2, -1, 0}));
  s.kind = Kind::points;
  s.width = 0.5;
  s.points = Points(std::vector<Vec3>{{1, 2, 3}, {-1, 5, 0}});
  EXPECT_EQ(extent(s).low, (Vec3{-1.25, 1.75, -0.25}));
  EXPECT_EQ(extent(s).high, (Vec3{1.25, 5.25, 3.25}));
  s.points = Points();
  EXPECT_TRUE(extent(s).empty());
  s.kind = Kind::mesh;
  EXPECT_TRUE(extent(s).empty());
}

}  // namespace
}  // namespace betwixt

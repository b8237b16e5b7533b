// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the triangles of the items of frames.
#include <gtest/gtest.h>

#include "betwixt/geometry.h"
#include "betwixt/picture.h"

namespace betwixt {
namespace {

TEST(GeometryOf, AnItemOnTheWayIsBetweenBothShapes) {
  Shape small, large;
  small.kind = large.kind = Kind::box;
  small.size = {1, 1, 1}, large.size = {3, 1, 1};
  Item item;
  item.shape = std::make_shared<Shape>(small);
  const auto width = [&] {
    const Geometry g = geometry_of(item);
    return transform_vector(g.local, {g.mesh->box().high.x, 0, 0}).x;
  };
  EXPECT_NEAR(width(), 0.5, 1e-6);
  item.toward = std::make_shared<Shape>(large), item.blend = 0.5;
  EXPECT_NEAR(width(), 1, 1e-6);
}

TEST(GeometryOf, MoreFacesGoAroundWhereTheyAreAskedFor) {
  Shape ball;
  ball.kind = Kind::sphere;
  Item item;
  item.shape = std::make_shared<Shape>(ball);
  EXPECT_GT(geometry_of(item, 96).mesh->triangles.size(), 3 * geometry_of(item, 48).mesh->triangles.size());
}

TEST(ToPng, SaysWhatCannotBeOne) {
  EXPECT_EQ(to_png(Picture{2, 2, std::vector<std::uint8_t>(16)})->substr(1, 3), "PNG");
  EXPECT_EQ(to_png(Picture{2, 2, {}}).error().code, ErrorCode::range);
}

}  // namespace
}  // namespace betwixt

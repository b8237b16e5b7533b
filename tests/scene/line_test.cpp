// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/line.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/kinds.h"

namespace betwixt {
namespace {

Shape curve(std::vector<Vec3> points, bool smooth, bool closed) {
  Shape s;
  s.kind = Kind::curve, s.points = Points(std::move(points)), s.smooth = smooth, s.closed = closed;
  return s;
}

void expect_near(Vec3 a, Vec3 b, double off) { EXPECT_LE(length(a - b), off) << a.x << ' ' << a.y << ' ' << a.z; }

TEST(Line, OfStraightPiecesIsMeasuredAlongThem) {
  const MeasuredLine line(line_of(curve({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}}, false, false)));
  EXPECT_DOUBLE_EQ(line.length(), 4);
  expect_near(line.at(0.5).point, {2, 0, 0}, 1e-12);
  expect_near(line.at(0.875).point, {3, 0.5, 0}, 1e-12);
  expect_near(line.at(0.875).direction, {0, 1, 0}, 1e-12);
  expect_near(line.at(1.25).point, {3, 2, 0}, 1e-12);    // straight on behind its end
  expect_near(line.at(-0.25).point, {-1, 0, 0}, 1e-12);  // and before its beginning
}

TEST(Line, ThatIsClosedGoesRoundAgain) {
  const MeasuredLine line(line_of(curve({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, false, true)));
  EXPECT_DOUBLE_EQ(line.length(), 4);
  expect_near(line.at(0.875).point, {0, 0.5, 0}, 1e-12);
  expect_near(line.at(2.375).point, line.at(0.375).point, 1e-9);
  expect_near(line.at(-0.125).point, {0, 0.5, 0}, 1e-12);
}

TEST(Line, OfASmoothCurveGoesThroughItsPointsAndHasItsLength) {
  const std::vector<Vec3> points{{-6, 0, 0}, {-2, 3, 1}, {2, -3, 0}, {6, 0, 2}};
  const Line line = line_of(curve(points, true, false));
  for (const Vec3 p : points) {
    double nearest = 1e9;
    for (const Vec3 q : line.points) nearest = std::min(nearest, length(p - q));
    EXPECT_LE(nearest, 1e-12);
  }
  // Catmull and Rom's cubics in Hermite's form, summed in 100,000 steps a piece.
  double long_way = 0;
  const auto tangent = [&](std::size_t i) {
    const Vec3 before = i > 0 ? points[i - 1] : 2.0 * points[0] - points[1];
    const Vec3 after = i + 1 < points.size() ? points[i + 1] : 2.0 * points[i] - points[i - 1];
    return 0.5 * (after - before);
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    Vec3 last = points[i];
    for (int k = 1; k <= 100'000; ++k) {
      const double u = k / 100'000.0, v = 1 - u;
      const Vec3 p = (1 + 2 * u) * v * v * points[i] + u * v * v * tangent(i) + u * u * (3 - 2 * u) * points[i + 1] -
                     u * u * v * tangent(i + 1);
      long_way += length(p - last), last = p;
    }
  }
  EXPECT_NEAR(MeasuredLine(line).length(), long_way, 2e-3 * long_way);
  EXPECT_LE(MeasuredLine(line).length(), long_way);  // its chords are shorter
}

TEST(Line, OfACircleIsItsCircumference) {
  Shape disc;
  disc.kind = Kind::disc, disc.radius = 2;
  const MeasuredLine line(line_of(disc));
  EXPECT_NEAR(line.length(), 4 * pi, 1e-3);
  expect_near(line.at(0.25).point, {0, 2, 0}, 1e-9);
  expect_near(line.at(0.25).direction, {-1, 0, 0}, 0.02);
  Shape arc;
  arc.kind = Kind::arc, arc.radius = 2, arc.from = 0, arc.to = pi / 2, arc.width = 0.2;
  EXPECT_NEAR(MeasuredLine(line_of(arc)).length(), pi, 1e-3);
  expect_near(MeasuredLine(line_of(arc)).at(1).point, {0, 2, 0}, 1e-9);
}

TEST(Line, WithoutALengthIsAPlace) {
  const MeasuredLine one(line_of(curve({{1, 2, 3}}, true, true)));
  expect_near(one.at(0.7).point, {1, 2, 3}, 0);
  expect_near(MeasuredLine(line_of(curve({{1, 2, 3}, {1, 2, 3}}, false, false))).at(0.3).point, {1, 2, 3}, 0);
  EXPECT_TRUE(MeasuredLine(line_of(curve({}, true, false))).empty());
  EXPECT_TRUE(MeasuredLine(line_of(curve({{NAN, 0, 0}}, true, false))).empty());
  Shape ball;
  ball.kind = Kind::sphere;
  EXPECT_TRUE(MeasuredLine(line_of(ball)).empty());
  // Points that fall together are passed over.
  const MeasuredLine twice(line_of(curve({{0, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 0, 0}}, false, false)));
  expect_near(twice.at(0).direction, {1, 0, 0}, 0);
  expect_near(twice.at(1).point, {2, 0, 0}, 0);
}

TEST(Line, OfMillionsOfPointsIsAsLongAsThese) {
  std::vector<Vec3> many;
  for (int i = 0; i < 1'000'000; ++i) many.push_back({i * 1e-3, 0, 0});
  const MeasuredLine line(line_of(curve(many, true, false)));
  EXPECT_NEAR(line.length(), 999.999, 1e-6);
}

}  // namespace
}  // namespace betwixt

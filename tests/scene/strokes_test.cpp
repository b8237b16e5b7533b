// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the visible parts of lines with arc lengths in closed form. tests/exchange tests the areas of strokes.
#include "scene/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "scene/kinds.h"

namespace betwixt {
namespace {

using Way = std::vector<Vec3>;

double length_of(const DrawnPart& s) {
  double sum = 0;
  for (std::size_t i = 1; i < s.points.size() + (s.closed ? 1 : 0); ++i)
    sum += length(s.points[i % s.points.size()] - s.points[i - 1]);
  return sum;
}
double length_of(const std::vector<DrawnPart>& all) {
  double sum = 0;
  for (const DrawnPart& s : all) sum += length_of(s);
  return sum;
}
Way circle(double radius, int n) {
  Way all;
  for (int i = 0; i < n; ++i) all.push_back({radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 0});
  return all;
}

const Way corner{{0, 0, 0}, {3, 0, 0}, {3, 4, 0}};

TEST(Stretches, AreTheWholeLineWhereNothingIsSaid) {
  for (const bool closed : {false, true}) {
    const auto all = stretches(corner, closed, {});
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].points, corner);
    EXPECT_EQ(all[0].closed, closed);
  }
  EXPECT_TRUE(stretches({}, true, {}).empty());
}

TEST(Stretches, AreTrimmedByLength) {
  const auto some = stretches(corner, false, {0, 0, 0.2, 0.6});  // of 7 metres: from 1.4 to 4.2
  ASSERT_EQ(some.size(), 1U);
  ASSERT_EQ(some[0].points.size(), 3U);
  EXPECT_NEAR(length(some[0].points[0] - Vec3{1.4, 0, 0}), 0, 1e-12);
  EXPECT_EQ(some[0].points[1], (Vec3{3, 0, 0}));
  EXPECT_NEAR(length(some[0].points[2] - Vec3{3, 1.2, 0}), 0, 1e-12);
  // Closed, there are 5 metres more.
  EXPECT_NEAR(length_of(stretches(corner, true, {0, 0, 0.25, 1})), 9, 1e-12);
  EXPECT_NEAR(length_of(stretches(circle(2, 4000), true, {0, 0, 0.1, 0.35})), 0.25 * 4 * pi, 1e-5);
  for (const Dashes none : {Dashes{0, 0, 0, 0}, Dashes{0, 0, 1, 1}, Dashes{0, 0, 0.7, 0.3}, Dashes{0.2, 0.2, 0, 0}})
    EXPECT_TRUE(stretches(corner, true, none).empty());
}

TEST(Stretches, AreDashesOfTheirLength) {
  const auto dashes = stretches(corner, false, {0.5, 0.25, 0, 1});  // 9 of 0.75, and 0.25 of the tenth
  ASSERT_EQ(dashes.size(), 10U);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(length_of(dashes[i]), 0.5, 1e-12) << i;
  EXPECT_NEAR(length_of(dashes[9]), 0.25, 1e-12);
  EXPECT_NEAR(length(dashes[4].points.front() - corner[1]), 0, 1e-12) << "from 3 to 3.5: it begins at the corner";
  // Trimmed, each stays where it was.
  const auto later = stretches(corner, false, {0.5, 0.25, 1.0 / 7, 2.0 / 7});
  ASSERT_EQ(later.size(), 2U);
  EXPECT_NEAR(later[0].points[0].x, 1, 1e-12);
  EXPECT_NEAR(later[0].points.back().x, 1.25, 1e-12);
  EXPECT_NEAR(later[1].points[0].x, 1.5, 1e-12);
  // Round a circle: the sum in closed form.
  const double round = 4 * pi, period = 0.5, whole = std::floor(round / period);
  EXPECT_NEAR(length_of(stretches(circle(2, 4000), true, {0.3, 0.2, 0, 1})),
              0.3 * whole + std::min(0.3, round - period * whole), 1e-5);
}

TEST(Stretches, DashesOfNoLengthAreDots) {
  const auto dots = stretches(corner, false, {0, 1, 0, 1});
  ASSERT_EQ(dots.size(), 7U);
  EXPECT_EQ(dots[2].points.front(), dots[2].points.back());
  EXPECT_NEAR(dots[2].points.front().x, 2, 1e-12);
}

TEST(Stretches, GapsOfNothingAndTooManyAreOneLine) {
  EXPECT_EQ(stretches(corner, true, {0.2, 0, 0, 1}).size(), 1U);
  EXPECT_EQ(stretches(corner, false, {1e-9, 1e-9, 0, 1}).size(), 1U);
  EXPECT_EQ(stretches(corner, false, {0, std::numeric_limits<double>::denorm_min(), 0, 1}).size(), 1U);
}

TEST(Pens, OfShapes) {
  Shape s;
  s.kind = Kind::rectangle, s.stroke_width = 0.1;
  EXPECT_EQ(pen_of(s).width, 0) << "no colour was said";
  s.filled = false;
  EXPECT_EQ(pen_of(s).width, 0.1);
  EXPECT_FALSE(pen_of(s).color) << "it is the object's";
  s.filled = true, s.stroke = {0, 0, 0};
  EXPECT_EQ(pen_of(s).width, 0.1);
  EXPECT_EQ(pen_of(s).color, (Vec3{0, 0, 0})) << "black is a colour";
  const Pen half = between({true, 0, {}, {}}, pen_of(s), 0.5);
  EXPECT_NEAR(half.width, 0.05, 1e-15);
  EXPECT_EQ(half.color, (Vec3{0, 0, 0})) << "what only one has grows";
}

// How often contours go round a point.
int winding(const Contours& all, Vec3 p) {
  int n = 0;
  for (const Way& way : all)
    for (std::size_t i = 0; i < way.size(); ++i) {
      const Vec3 &a = way[i], &b = way[(i + 1) % way.size()];
      const double side = (b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y);
      n += a.y <= p.y && b.y > p.y && side > 0 ? 1 : a.y > p.y && b.y <= p.y && side < 0 ? -1 : 0;
    }
  return n;
}
// `corners`: also from points that are beside no side.
double distance_to(const Way& closed, Vec3 p, bool corners) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < closed.size(); ++i) {
    const Vec3 a = closed[i], d = closed[(i + 1) % closed.size()] - a;
    const double along = dot(p - a, d) / dot(d, d);
    if (corners || (along >= 0 && along <= 1)) least = std::min(least, length(p - a - std::clamp(along, 0.0, 1.0) * d));
  }
  return least;
}

// A stroke is what is at most half a width from its line, also where it is wider than the shape; pointed corners reach
// farther.
TEST(Strokes, AreWhatIsNearTheLineHoweverWide) {
  std::mt19937 random(4);
  const auto number = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  for (int k = 0; k < 300; ++k) {
    // On an ellipse: few corners, or so many that it is smooth; both ways round.
    Way way;
    if (k % 2 == 0) {
      way = circle(1, 3 + static_cast<int>(random() % 90));
    } else {
      std::vector<double> angles(3 + random() % 9);
      for (double& a : angles) a = number(0, 2 * pi);
      std::sort(angles.begin(), angles.end());
      for (const double a : angles) way.push_back({std::cos(a), std::sin(a), 0});
    }
    const double squeeze = number(0.2, 1), width = number(0.05, 5);
    for (Vec3& p : way) p.y *= squeeze;
    if (k % 3 == 0) std::reverse(way.begin(), way.end());
    const bool round = k % 5 < 2;
    Pen pen;
    pen.width = width, pen.round = round;
    const Contours areas = stroke_areas({way}, pen, {0, 0, 1});
    for (int i = 0; i < 200; ++i) {
      const Vec3 p{number(-1 - width, 1 + width), number(-1 - width, 1 + width), 0};
      const double away = distance_to(way, p, true) / (width / 2);
      if (distance_to(way, p, round) / (width / 2) < 0.98) {
        EXPECT_NE(winding(areas, p), 0) << k << ": " << p.x << ' ' << p.y << ", width " << width;
      }
      if (away > (round ? 1.07 : 4.01)) {
        EXPECT_EQ(winding(areas, p), 0) << k << ": " << p.x << ' ' << p.y << ", width " << width;
      }
    }
  }
}

TEST(Strokes, WiderThanACircleLeaveNoHole) {
  for (const double width : {1.8, 2.2, 3.0, 5.0, 50.0}) {
    Pen pen;
    pen.width = width;
    const Contours areas = stroke_areas({circle(1, 96)}, pen, {0, 0, 1});
    EXPECT_EQ(areas.size(), width < 2 ? 2U : 1U) << width;
    EXPECT_EQ(winding(areas, {0.001, 0.002, 0}) != 0, width > 2) << width;
    EXPECT_NE(winding(areas, {0.5 + width / 4, 0.01, 0}), 0) << width;
  }
}

TEST(DrawnExtents, HoldTheStroke) {
  Shape s;
  s.kind = Kind::rectangle, s.size = {4, 2, 1}, s.stroke = {1, 1, 1}, s.stroke_width = 0.5, s.depth = 0.2;
  const Extent e = extent(s);
  EXPECT_NEAR(e.high.x, 2.25, 1e-12);
  EXPECT_NEAR(e.low.y, -1.25, 1e-12);
  EXPECT_NEAR(e.high.z, 0.1, 1e-12);
  s.kind = Kind::regular, s.sides = 3, s.radius = 1, s.stroke_width = 0.1;
  EXPECT_NEAR(extent(s).high.y, 1 + 0.1, 1e-12) << "a corner of 60 degrees reaches out twice half the width";
  s.filled = false, s.trim_to = 0.01;
  EXPECT_LT(extent(s).high.x - extent(s).low.x, 0.2) << "only what is drawn counts";
  Shape l;
  l.kind = Kind::line, l.size = {10, 0, 0}, l.width = 0.2, l.trim_from = 0.2, l.trim_to = 0.5;
  EXPECT_NEAR(extent(l).low.x, 1.9, 1e-12);
  EXPECT_NEAR(extent(l).high.x, 5.1, 1e-12);
  l.trim_to = 0;
  EXPECT_TRUE(extent(l).empty());
}

TEST(Rings, AreHolesOneBehindTheOther) {
  const Way a{{1, 1, 0}, {2, 1, 0}, {2, 2, 0}}, b{{3, 3, 0}, {4, 3, 0}, {4, 4, 0}, {3, 4, 0}};
  Way both = a;
  both.push_back(a[0]);
  both.insert(both.end(), b.begin(), b.end());
  EXPECT_EQ(rings(both), (Contours{a, b})) << "the last one ends by itself";
  both.push_back(b[0]);
  EXPECT_EQ(rings(both), (Contours{a, b}));
  EXPECT_TRUE(rings({}).empty());
}

}  // namespace
}  // namespace betwixt

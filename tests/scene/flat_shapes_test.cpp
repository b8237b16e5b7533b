// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the areas of flat shapes with closed forms, and turns gears against each other.
#include "scene/flat_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene/kinds.h"

namespace betwixt {
namespace {

// Anticlockwise counts, holes do not (Gauss's shoelace).
double area(const Contours& contours) {
  double sum = 0;
  for (const auto& c : contours)
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Vec3 p = c[i], q = c[(i + 1) % c.size()];
      sum += (p.x * q.y - q.x * p.y) / 2;
    }
  return sum;
}

Shape shape(Kind kind) {
  Shape s;
  s.kind = kind;
  return s;
}

TEST(FlatShapes, HaveTheAreasOfTheirFormulas) {
  Shape card = shape(Kind::rectangle);
  card.size = {3, 2, 1};
  EXPECT_DOUBLE_EQ(area(rectangle_contours(card)), 6);
  card.corner = 0.5;
  EXPECT_NEAR(area(rectangle_contours(card)), 6 - (4 - pi) * 0.25, 1e-3);
  card.corner = 9;  // no rounder than it is wide
  EXPECT_NEAR(area(rectangle_contours(card)), 2 + pi, 4e-3);

  Shape ring = shape(Kind::ring);
  ring.radius = 2, ring.inner = 1.5;
  EXPECT_NEAR(area(ring_contours(ring)), pi * (4 - 2.25), 3e-3);

  Shape arc = shape(Kind::arc);
  arc.radius = 2, arc.width = 0.5, arc.from = -0.3, arc.to = 1.2;
  EXPECT_NEAR(area(arc_contours(arc)), 1.5 * 2 * 0.5, 1e-3);  // angle, times radius, times width
  std::swap(arc.from, arc.to);
  EXPECT_NEAR(area(arc_contours(arc)), 1.5, 1e-3) << "the other way round it is the same part";
  arc.to = arc.from + 30;
  EXPECT_NEAR(area(arc_contours(arc)), 2 * pi * 2 * 0.5, 3e-3) << "no more than all round";
  arc.width = 4, arc.to = arc.from + 1;
  EXPECT_NEAR(area(arc_contours(arc)), 8, 6e-3) << "a slice of a cake of radius 4";

  Shape cell = shape(Kind::regular);
  for (const double n : {3.0, 5.0, 6.0, 17.0}) {
    cell.sides = n, cell.radius = 2;
    EXPECT_NEAR(area(regular_contours(cell)), n / 2 * 4 * std::sin(2 * pi / n), 1e-12);
  }
  Shape star = shape(Kind::star);
  star.sides = 5, star.radius = 2, star.inner = 0.7;
  EXPECT_NEAR(area(star_contours(star)), 5 * 2 * 0.7 * std::sin(pi / 5), 1e-12);

  Shape arrow = shape(Kind::arrow);
  arrow.size = {3, 4, 0}, arrow.width = 0.2;  // a shaft of 4.2, a head of 0.8 by 0.6
  EXPECT_NEAR(area(arrow_contours(arrow)), 4.2 * 0.2 + 0.8 * 0.6 / 2, 1e-12);
  EXPECT_NEAR(extent(arrow).high.y, 4, 1e-12);
}

double across(Vec3 a, Vec3 b, Vec3 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }
bool inside(const std::vector<Vec3>& c, Vec3 p) {
  bool in = false;
  for (std::size_t i = 0, j = c.size() - 1; i < c.size(); j = i++)
    if ((c[i].y > p.y) != (c[j].y > p.y) && (across(c[j], c[i], p) < 0) != (c[i].y < c[j].y)) in = !in;
  return in;
}

// Two gears of one module at the distance of their pitch circles, turned by their ratio: they touch and never overlap
// by more than a chord is off its curve.
TEST(FlatShapes, GearsTurnEachOther) {
  const auto gear = [](double teeth, double module) {
    Shape s = shape(Kind::gear);
    s.sides = teeth, s.module = module;
    return gear_contours(s)[0];
  };
  constexpr int a = 24, b = 40;
  const auto one = gear(a, 0.1), two = gear(b, 0.1);
  const double distance = (a + b) * 0.1 / 2;
  const auto turned = [](Vec3 p, double angle, double x) {
    return Vec3{std::cos(angle) * p.x - std::sin(angle) * p.y + x, std::sin(angle) * p.x + std::cos(angle) * p.y, 0};
  };
  for (int k = 0; k < 20; ++k) {
    const double turn = 2 * pi / a * k / 20;
    // A tooth of the first to the right; a gap of the second to the left, which b's half a tooth brings there.
    const double first = -pi / 2 + turn, second = pi / 2 + pi / b - turn * a / b;
    double nearest = 1;
    for (const Vec3 p : two) {
      const Vec3 at = turned(p, second, distance), in_one = turned(at, -first, 0);
      if (length(at) > a * 0.1 / 2 + 0.2) continue;
      double away = 1;  // from the other's outline
      for (std::size_t i = 0; i < one.size(); ++i) {
        const Vec3 u = one[i], v = one[(i + 1) % one.size()];
        const double t = std::clamp(dot(in_one - u, v - u) / dot(v - u, v - u), 0.0, 1.0);
        away = std::min(away, length(in_one - (u + t * (v - u))));
      }
      nearest = std::min(nearest, away);
      if (inside(one, in_one)) {
        EXPECT_LT(away, 1e-3) << k;
      }
    }
    EXPECT_LT(nearest, 2e-3) << k;
  }
  EXPECT_NEAR(area({one}), pi * 1.2 * 1.2, 0.25);  // about that of its pitch circle
}

TEST(FlatShapes, NumbersThatMakeNoShapeMakeNone) {
  const double bad[] = {0, -1, std::numeric_limits<double>::infinity(), std::nan("")};
  for (const KindRow& row : kinds()) {
    if (row.contours == nullptr) continue;
    for (const double x : bad) {
      Shape s = shape(row.kind);
      s.radius = s.inner = s.width = s.sides = s.module = s.from = s.to = s.corner = x, s.size = {x, x, x};
      s.dash = s.gap = s.trim_from = x, s.points = s.holes = std::vector<Vec3>(4, {x, x, 0});
      for (const auto& c : row.contours(s))
        for (const Vec3 p : c) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << row.name;
    }
  }
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the triangles of strokes and holes: areas and volumes in closed form, and point by point with distances.
#include "exchange/outlines.h"

#include <random>

#include "exchange/some_shapes.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

using Corner = std::array<Vec3, 3>;

// Of one part, or of all.
std::vector<Corner> faces(const Mesh& m, int part = -1) {
  std::vector<Corner> all;
  std::size_t first = 0, end = m.triangles.size();
  if (part >= 0) first = m.parts[static_cast<std::size_t>(part)].first;
  if (part >= 0) end = first + m.parts[static_cast<std::size_t>(part)].count;
  const auto at = [&](std::size_t i) { return widen(m.positions[m.triangles[i]]); };
  for (std::size_t i = first; i < end; i += 3) all.push_back({at(i), at(i + 1), at(i + 2)});
  return all;
}
double area(const std::vector<Corner>& all) {
  double sum = 0;
  for (const auto& [a, b, c] : all) sum += length(cross(b - a, c - a)) / 2;
  return sum;
}
double volume(const Mesh& m) {  // Gauss
  double sum = 0;
  for (const auto& [a, b, c] : faces(m)) sum += dot(a, cross(b, c)) / 6;
  return sum;
}
Mesh mesh_of(const Shape& s) { return *realise(s).mesh; }
double fill_area(const Shape& s) { return area(faces(mesh_of(s), 0)); }
double stroke_area(const Shape& s) { return area(faces(mesh_of(s), 1)); }

Shape stroked(Kind kind, double width) {
  Shape s = shape(kind);
  s.stroke = {1, 0, 0}, s.stroke_width = width;
  return s;
}

TEST(Strokes, HaveTheAreasOfTheirFormulas) {
  Shape card = stroked(Kind::rectangle, 0.5);
  card.size = {4, 2, 1};
  EXPECT_NEAR(stroke_area(card), 12 * 0.5, 1e-5) << "its corners are whole";
  EXPECT_NEAR(fill_area(card), 3.5 * 1.5, 1e-5) << "what is filled ends where the stroke begins";
  card.dash = 1, card.gap = 1;
  EXPECT_NEAR(stroke_area(card), 6 * 0.5, 1e-5) << "six dashes of a metre";
  EXPECT_NEAR(fill_area(card), 8 - 6 * 0.5 / 2, 1e-5) << "half of each is inside";
  card.dash = card.gap = 0, card.trim_to = 0.25;
  EXPECT_NEAR(stroke_area(card), 3 * 0.5, 1e-5) << "a quarter of the way round, along the lower side";
  card.trim_to = 0.5;  // round one corner: a square of the width more than two ends that are cut off there
  EXPECT_NEAR(stroke_area(card), 6 * 0.5, 1e-5);

  Shape disc = stroked(Kind::disc, 0.3);
  disc.radius = 2;
  EXPECT_NEAR(stroke_area(disc), 2 * pi * 2 * 0.3, 4e-3);
  EXPECT_NEAR(fill_area(disc), pi * 1.85 * 1.85, 6e-3);
  disc.trim_from = 0.125, disc.trim_to = 0.5;
  EXPECT_NEAR(stroke_area(disc), 0.375 * 2 * pi * 2 * 0.3, 2e-3);
  disc.filled = false, disc.stroke = {-1, -1, -1};
  EXPECT_NEAR(area(faces(mesh_of(disc))), 0.375 * 2 * pi * 2 * 0.3, 2e-3);
  disc.trim_to = 0;
  EXPECT_TRUE(mesh_of(disc).triangles.empty());

  Shape cell = stroked(Kind::regular, 0.1);
  cell.sides = 6, cell.radius = 1;  // corners of 120 degrees, whole
  EXPECT_NEAR(stroke_area(cell), 6 * 0.1, 1e-5);
}

// Beyond what is pointed or cut off: quarters of a disc at corners, halves at ends; a disc here has 32 sides.
TEST(Strokes, MayBeRound) {
  const double disc = 16 * std::sin(2 * pi / 32);  // of radius 1
  Shape card = stroked(Kind::rectangle, 0.5);
  card.size = {4, 2, 1}, card.stroke_round = true;
  EXPECT_NEAR(stroke_area(card), 12 * 0.5 - 0.25 * 0.25 * (4 - disc), 1e-5) << "its corners are rounded";
  card.trim_to = 0.25;
  EXPECT_NEAR(stroke_area(card), 3 * 0.5 + 0.25 * 0.25 * disc, 1e-5) << "and its ends";
  card.trim_to = 1, card.dash = 0, card.gap = 1;
  EXPECT_NEAR(stroke_area(card), 12 * 0.25 * 0.25 * disc, 1e-5) << "dashes of no length are dots";
}

// Against the grid: a point belongs to them where the winding number of all contours says so.
TEST(Islands, AreWhatContoursFill) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  for (int round = 0; round < 20; ++round) {
    Contours contours(1 + round % 4);
    for (Contour& c : contours)
      for (int i = 0; i < 3 + round % 5; ++i) c.push_back({place(random), place(random), 0});
    for (const Winding rule : {Winding::nonzero, Winding::odd}) {
      const auto all = islands(contours, rule);
      for (int i = 0; i < 200; ++i) {
        const Vec3 p{place(random), place(random), 0};
        int winding = 0;
        for (const Contour& c : contours) {
          double turned = 0;
          for (std::size_t k = 0; k < c.size(); ++k) {
            const Vec3 a = c[k] - p, b = c[(k + 1) % c.size()] - p;
            turned += std::atan2(cross(a, b).z, dot(a, b));
          }
          winding += static_cast<int>(std::lround(turned / (2 * pi)));
        }
        int inside = 0;
        for (const Island& island : all) {
          bool here = contains(island.outer, p);
          for (const Contour& hole : island.holes) here = here && !contains(hole, p);
          inside += here ? 1 : 0;
        }
        EXPECT_EQ(inside, (rule == Winding::odd ? winding % 2 != 0 : winding != 0) ? 1 : 0) << round;
      }
    }
  }
}

TEST(Strokes, ThatAreNoLongerAtSharpCornersAreCutThere) {
  Shape s = stroked(Kind::polygon, 0.2);
  s.points = std::vector<Vec3>{{0, 0, 0}, {10, 0.3, 0}, {10, -0.3, 0}};
  EXPECT_GT(extent(s).low.x, -0.2) << "a point of 1.7 m would be longer than four widths";
}

TEST(Strokes, ArcsAreTrimmedThemselves) {
  Shape arc = shape(Kind::arc);
  arc.radius = 2, arc.width = 0.5, arc.from = 0.3, arc.to = 0.3 + 3;
  arc.trim_from = 0.25;
  EXPECT_NEAR(area(faces(mesh_of(arc))), 0.75 * 3 * 2 * 0.5, 2e-3);
  EXPECT_LT(extent(arc).high.x, 2.25 * std::cos(0.3 + 0.75) + 1e-9) << "its beginning is away";
  std::swap(arc.from, arc.to);
  EXPECT_GT(extent(arc).high.x, 2.14) << "it begins at the other end";
  arc.trim_from = 0, arc.dash = 1, arc.gap = 0.5;
  EXPECT_NEAR(area(faces(mesh_of(arc))), 4 * 1 * 0.5, 2e-3) << "four dashes in 6 metres";
}

// Points by chance: in the stroke where they are near enough to the contour, in the filling where they are inside and
// away from it, never in both, never twice.
TEST(Strokes, CoverWhatIsNearTheContour) {
  std::mt19937 chance(11);
  std::vector<Shape> all;
  for (const Kind k : {Kind::rectangle, Kind::ring, Kind::regular, Kind::star, Kind::gear, Kind::arrow, Kind::disc}) {
    Shape s = stroked(k, 0.06);
    s.size = {1.6, 0.9, k == Kind::arrow ? 0 : 1.0}, s.inner = 0.4, s.corner = 0.2, s.sides = k == Kind::gear ? 12 : 5,
    s.module = 0.15, s.width = 0.3;
    all.push_back(s);
    s.stroke_width = 0.4;  // wider than some details
    all.push_back(s);
  }
  all.push_back(polygon({{-1, -1, 0}, {1, 1, 0}, {1, -1, 0}, {-1, 1, 0}, {0, 0.5, 0}}));  // crosses itself
  all.back().stroke = {1, 1, 1}, all.back().stroke_width = 0.2;
  for (const Shape& s : all) {
    const Contours contours = row_of(s.kind).contours(s);
    const Mesh mesh = mesh_of(s);
    const auto filling = faces(mesh, 0), stroke = faces(mesh, 1);
    const auto covers = [](const std::vector<Corner>& some, Vec3 p) {
      int n = 0;
      for (const auto& [a, b, c] : some) {
        const double u = cross(b - a, p - a).z, v = cross(c - b, p - b).z, w = cross(a - c, p - c).z;
        n += u > 0 && v > 0 && w > 0;
      }
      return n;
    };
    int agree = 0;
    for (int k = 0; k < 3000; ++k) {
      const Vec3 p{1.7 * (2 * std::generate_canonical<double, 30>(chance) - 1),
                   1.7 * (2 * std::generate_canonical<double, 30>(chance) - 1), 0};
      double away = 10;
      int round = 0;
      for (const auto& c : contours)
        for (std::size_t i = 0; i < c.size(); ++i) {
          const Vec3 a = c[i], b = c[(i + 1) % c.size()];
          const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
          away = std::min(away, length(p - (a + t * (b - a))));
          if ((a.y > p.y) != (b.y > p.y) && (cross(b - a, p - a).z > 0) == (b.y > a.y)) round += b.y > a.y ? 1 : -1;
        }
      const int in_fill = covers(filling, p), in_stroke = covers(stroke, p);
      EXPECT_LE(in_fill + in_stroke, 1) << name_of(s.kind);
      // Near corners a stroke lacks what is round, and reaches out.
      if (away < 0.49 * s.stroke_width && in_stroke == 1) ++agree;
      if (away < 0.49 * s.stroke_width && in_stroke == 0) agree -= 20;
      if (away > 2 * s.stroke_width) {
        EXPECT_EQ(in_stroke, 0) << name_of(s.kind);
        EXPECT_EQ(in_fill, round != 0) << name_of(s.kind) << ' ' << p.x << ' ' << p.y;
      }
    }
    EXPECT_GT(agree, 0) << name_of(s.kind) << ' ' << s.stroke_width;
  }
}

TEST(Strokes, HaveAColorOfTheirOwn) {
  const Mesh m = mesh_of(stroked(Kind::star, 0.1));
  ASSERT_EQ(m.parts.size(), 2U);
  EXPECT_TRUE(m.parts[0].tinted);
  EXPECT_FALSE(m.parts[1].tinted);
  EXPECT_EQ(m.parts[1].color, (std::array<float, 3>{1, 0, 0}));
  Shape bare = shape(Kind::star);
  bare.filled = false, bare.stroke_width = 0.1, bare.inner = 0.4, bare.sides = 5;
  EXPECT_TRUE(mesh_of(bare).parts.back().tinted) << "none was said: it is the object's";
}

TEST(Strokes, AreExtrudedWithTheirShapes) {
  Shape s = stroked(Kind::disc, 0.2);
  s.radius = 1, s.depth = 0.5;
  const Mesh m = mesh_of(s);
  EXPECT_TRUE(m.closed);
  EXPECT_NEAR(volume(m), pi * 1.1 * 1.1 * 0.5, 3e-3);
  s.filled = false;
  EXPECT_NEAR(volume(mesh_of(s)), 2 * pi * 0.2 * 0.5, 1e-3) << "a hoop";
}

TEST(Strokes, OfLettersFollowTheirContours) {
  Shape s = text("O");
  const double whole = front(mesh_of(s));
  s.stroke = {1, 0, 0}, s.stroke_width = 0.01;
  double round = 0;
  for (const auto& c : letter("O", 0))
    for (std::size_t i = 0; i < c.size(); ++i) round += length(c[(i + 1) % c.size()] - c[i]);
  EXPECT_NEAR(stroke_area(s), round * 0.01, 1e-4);
  EXPECT_NEAR(fill_area(s), whole - round * 0.005, 3e-4);
}

TEST(Holes, AreCutOut) {
  Shape wall = polygon({{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {0, 4, 0}});
  const std::vector<Vec3> window{{1, 1, 0}, {2, 1, 0}, {2, 3, 0}, {1, 3, 0}};
  wall.holes = window;
  EXPECT_NEAR(front(mesh_of(wall)), 24 - 2, 1e-5);
  std::vector<Vec3> two = window;
  for (const Vec3 p : {window[0], Vec3{1.5, 2, 0}, Vec3{1.5, 5, 0}, Vec3{4, 5, 0}, Vec3{4, 2, 0}}) two.push_back(p);
  wall.holes = two;  // overlaps the first in a half by 1, and reaches a metre out of the wall
  EXPECT_NEAR(front(mesh_of(wall)), 24 - (2 + 2.5 * 2 - 0.5), 1e-5);
  Shape other = wall;
  std::vector<Vec3> turned(wall.points->rbegin(), wall.points->rend());
  other.points = turned;
  EXPECT_NEAR(front(mesh_of(other)), front(mesh_of(wall)), 1e-5) << "whichever way it goes round";
  wall.holes = window, wall.depth = 2;
  EXPECT_NEAR(volume(mesh_of(wall)), 44, 1e-4);
  EXPECT_TRUE(mesh_of(wall).closed);
  wall.stroke = {1, 0, 0}, wall.stroke_width = 0.2, wall.depth = 0;
  EXPECT_NEAR(stroke_area(wall), (20 + 6) * 0.2, 1e-5) << "holes have a stroke too";
  // Upright, it is the same.
  Shape upright = polygon({{0, 0, 0}, {0, 0, 6}, {0, 4, 6}, {0, 4, 0}});
  upright.holes = std::vector<Vec3>{{0, 1, 1}, {0, 1, 2}, {0, 3, 2}, {0, 3, 1}};
  EXPECT_NEAR(area(faces(mesh_of(upright))), 22, 1e-5);
}

TEST(Holes, StayHolesOnTheWay) {
  Shape ring = shape(Kind::ring), small = ring;
  ring.radius = 2, ring.inner = 1, small.radius = 1, small.inner = 0.5;
  Shape halfway = ring;
  halfway.radius = 1.5, halfway.inner = 0.75;
  EXPECT_NEAR(front(*realise_blend(ring, small, 0.5).mesh), front(mesh_of(halfway)), 1e-4);
}

}  // namespace
}  // namespace betwixt

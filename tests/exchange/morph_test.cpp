// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "exchange/fonts.h"
#include "exchange/geometry.h"
#include "exchange/some_shapes.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

bool same(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.normals == b.normals && a.triangles == b.triangles && a.edges == b.edges;
}

// shows: G88
TEST(Blend, EndsAreExact) {
  Shape far = shape(Kind::sphere);
  far.radius = 3;
  const std::vector<std::pair<Shape, Shape>> pairs{{text("Twixt"), text("be")},
                                                   {text("O", 0.2), polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})},
                                                   {shape(Kind::sphere), far},
                                                   {shape(Kind::sphere), shape(Kind::box)}};
  for (const auto& [a, b] : pairs) {
    EXPECT_TRUE(same(*realise_blend(a, b, 0).mesh, *realise(a).mesh));
    EXPECT_TRUE(same(*realise_blend(a, b, 1).mesh, *realise(b).mesh));
    EXPECT_EQ(realise_blend(a, b, 1).local, realise(b).local);
  }
}

TEST(Blend, OutlinesPassThroughWhatLiesBetween) {
  const std::vector<std::pair<Shape, Shape>> pairs{
      {text("I"), text("W")},
      {text("BETWIXT"), text("tween")},
      {text("8", 0.1), text("%", 0.3)},
      {text("O"), text("")},
      {polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), polygon({{0, 0, 0}, {0, 3, 0}, {3, 0, 0}})}};
  for (const auto& [a, b] : pairs) {
    EXPECT_TRUE(can_blend(a, b));
    const double from = front(*realise(a).mesh), to = front(*realise(b).mesh);
    // Near its ends a blend looks like them: nothing pops.
    EXPECT_NEAR(front(*realise_blend(a, b, 1e-4).mesh), from, 2e-3);
    EXPECT_NEAR(front(*realise_blend(a, b, 1 - 1e-4).mesh), to, 2e-3);
    for (const double s : {0.25, 0.5, 0.75}) {
      const auto m = realise_blend(a, b, s).mesh;
      EXPECT_FALSE(m->triangles.empty());
      const auto box = m->box(), p = realise(a).mesh->box(), q = realise(b).mesh->box();
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GE(box.low[i], std::min(p.low[i], q.low[i]) - 1e-5F);
        EXPECT_LE(box.high[i], std::max(p.high[i], q.high[i]) + 1e-5F);
      }
    }
  }
  EXPECT_TRUE(realise_blend(text("8", 0.1), text("B", 0.3), 0.5).mesh->closed);
  EXPECT_NEAR(realise_blend(text("8", 0.1), text("B", 0.3), 0.5).mesh->box().high[2], 0.1, 1e-6);
  // A square to a larger one: halfway it is the square halfway.
  const Shape small = polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
              large = polygon({{3, 3, 0}, {0, 3, 0}, {0, 0, 0}, {3, 0, 0}});
  EXPECT_NEAR(front(*realise_blend(small, large, 0.5).mesh), 4, 1e-5);
}
bool has_point(const Mesh& m, Vec3 p) {
  return std::any_of(m.positions.begin(), m.positions.end(),
                     [&](const auto& q) { return length(widen(q) - p) < 1e-6; });
}
struct Span {
  double low = INFINITY, high = -INFINITY;
};
Span across(const std::vector<Contour>& contours) {
  Span x;
  for (const auto& c : contours)
    for (const Vec3 p : c) x = {std::min(x.low, p.x), std::max(x.high, p.x)};
  return x;
}

TEST(Blend, EqualLettersKeepTheirShape) {
  const struct {
    std::string from, to;
    Corners stay;  // the letters that are in both: at x in the one, at y in the other
  } cases[] = {{"ab", "axb", {{0, 0, 0}, {1, 2, 0}}},
               {"axb", "ab", {{0, 0, 0}, {2, 1, 0}}},
               {"between", "betwixt", {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}},
               {"cat", "the cat", {{0, 3, 0}, {1, 4, 0}, {2, 5, 0}}},
               {"i\nwe", "we", {{1, 0, 0}, {2, 1, 0}}}};
  for (const auto& [from, to, stay] : cases)
    for (const double s : {0.25, 0.5, 0.9}) {
      const auto m = realise_blend(text(from), text(to), s).mesh;
      for (const Vec3 pair : stay) {
        const auto a = letter(from, static_cast<std::size_t>(pair.x)), b = letter(to, static_cast<std::size_t>(pair.y));
        for (std::size_t c = 0; c < a.size(); ++c)
          for (std::size_t i = 0; i < a[c].size(); ++i)
            EXPECT_TRUE(has_point(*m, (1 - s) * a[c][i] + s * b[c][i])) << from << " " << to << " " << s;
      }
    }
}

TEST(Blend, ALetterComesBetweenItsNeighbours) {
  const auto m = realise_blend(text("ab"), text("axb"), 0.5).mesh;
  EXPECT_NEAR(front(*m), front(*realise(text("ab")).mesh) + front(*realise(text("x")).mesh) / 4, 1e-5);
  const auto half = [](Span p, Span q) { return Span{(p.low + q.low) / 2, (p.high + q.high) / 2}; };
  const Span a = across(letter("ab", 0)), b = across(letter("ab", 1)), x = across(letter("axb", 1));
  const double gap = (a.high + b.low) / 2;
  const Span places[] = {half(a, across(letter("axb", 0))), half({gap, gap}, x), half(b, across(letter("axb", 2)))};
  EXPECT_LT(places[0].high, places[1].low);
  EXPECT_LT(places[1].high, places[2].low);
  for (const auto& p : m->positions)
    EXPECT_TRUE(std::any_of(std::begin(places), std::end(places), [&](Span place) {
      return p[0] > place.low - 1e-6 && p[0] < place.high + 1e-6;
    })) << p[0];
}

TEST(Blend, ADotComesOutOfItsOwnLetter) {
  for (const double s : {0.1, 0.5, 0.9}) {
    const auto m = realise_blend(text("between"), text("betwixt"), s).mesh;
    for (std::size_t k = 4; k < 7; ++k) {  // nothing between the letters that change either
      const Span a = across(letter("between", k - 1)), b = across(letter("betwixt", k - 1)),
                 c = across(letter("between", k)), d = across(letter("betwixt", k));
      const double low = (1 - s) * a.high + s * b.high, high = (1 - s) * c.low + s * d.low;
      for (const auto& p : m->positions) EXPECT_FALSE(p[0] > low + 1e-6 && p[0] < high - 1e-6) << k << " " << s;
    }
  }
}

TEST(Blend, LongTextsGoInOrder) {
  const std::string many(1200, 'l');
  const auto m = realise_blend(text(many), text(many + "l"), 0.5).mesh;
  EXPECT_NEAR(front(*m) / front(*realise(text("l")).mesh), 1200.25, 0.05);
}

TEST(Blend, MeasuresGoOnBeyondTheEnds) {
  Shape a = shape(Kind::sphere), b = a;
  a.radius = 1, b.radius = 3;
  EXPECT_EQ(realise_blend(a, b, 0.5).local, scaling({2, 2, 2}));
  EXPECT_EQ(realise_blend(a, b, 1.5).local, scaling({4, 4, 4}));
  Shape p = shape(Kind::polyline), q = p;
  p.points = Corners{{0, 0, 0}, {1, 0, 0}}, q.points = Corners{{0, 2, 0}, {1, 4, 0}};
  EXPECT_EQ(realise_blend(p, q, 0.5).mesh->positions[1], (std::array<float, 3>{1, 2, 0}));
}

// shows: G51 G88
TEST(Blend, MeshesGoVertexByVertex) {
  const auto twin = [](double scale) {
    Shape s = shape(Kind::mesh);
    Mesh m = *realise(shape(Kind::box)).mesh;
    for (auto& p : m.positions) p = narrow(scale * widen(p));
    s.mesh = std::make_shared<const Mesh>(std::move(m));
    return s;
  };
  const Shape a = twin(1), b = twin(3);
  EXPECT_EQ(realise_blend(a, b, 0).mesh, a.mesh);
  EXPECT_EQ(realise_blend(a, b, 1).mesh, b.mesh);
  EXPECT_NEAR(signed_volume(*realise_blend(a, b, 0.5).mesh), 8, 1e-5);
  EXPECT_NEAR(signed_volume(*realise_blend(a, b, 1.5).mesh), 64, 1e-4);
  EXPECT_TRUE(can_blend(a, b));
}

// shows: G88
TEST(Blend, SaysWhyItSteps) {
  std::string why;
  EXPECT_FALSE(can_blend(shape(Kind::sphere), shape(Kind::box), &why));
  EXPECT_EQ(why, "1225 vertices and 24 vertices");
  Shape a = shape(Kind::polyline), b = a;
  a.points = Corners(3, Vec3{}), b.points = Corners(5, Vec3{});
  EXPECT_FALSE(can_blend(a, b, &why));
  EXPECT_EQ(why, "3 points and 5 points");
  EXPECT_EQ(realise_blend(shape(Kind::sphere), shape(Kind::box), 0.99).mesh, realise(shape(Kind::sphere)).mesh);
  EXPECT_EQ(realise_blend(shape(Kind::sphere), shape(Kind::box), 1.5).mesh, realise(shape(Kind::box)).mesh);
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/geometry.h"

#include <gtest/gtest.h>

#include <thread>

#include "exchange/fonts.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

using Corners = std::vector<Vec3>;

Shape shape(Kind kind) {
  Shape s;
  s.kind = kind;
  return s;
}
Shape polygon(Corners points) {
  Shape s = shape(Kind::polygon);
  s.points = std::move(points);
  return s;
}
Shape text(std::string words, double depth = 0) {
  Shape s = shape(Kind::text);
  s.text = std::move(words);
  s.font = std::string("DejaVu Sans");
  s.depth = depth;
  return s;
}

// Area towards +z.
double front(const Mesh& m) {
  double sum = 0;
  for (std::size_t i = 0; i < m.triangles.size(); i += 3) {
    const Vec3 a = widen(m.positions[m.triangles[i]]), b = widen(m.positions[m.triangles[i + 1]]),
               c = widen(m.positions[m.triangles[i + 2]]);
    sum += std::max(0.0, cross(b - a, c - a).z / 2);
  }
  return sum;
}
double width(const Mesh& m) { return static_cast<double>(m.box().high[0]) - static_cast<double>(m.box().low[0]); }

bool same(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.normals == b.normals && a.triangles == b.triangles && a.edges == b.edges;
}

TEST(Geometry, MeasuresAreInTheScaling) {
  Shape s = shape(Kind::sphere), t = s;
  s.radius = 2, t.radius = 5;
  const Geometry a = realise(s), b = realise(t);
  EXPECT_EQ(a.mesh, b.mesh);
  EXPECT_EQ(a.local, scaling({2, 2, 2}));
  EXPECT_EQ(b.local, scaling({5, 5, 5}));
  EXPECT_NE(a.mesh, realise(s, 2).mesh);
  Shape c = shape(Kind::cone);
  c.radius = 3, c.height = 7;
  EXPECT_EQ(realise(c).local, scaling({3, 7, 3}));
  Shape box = shape(Kind::box);
  box.size = {1, 2, 3};
  EXPECT_EQ(realise(box).local, scaling({1, 2, 3}));
}

TEST(Geometry, EqualShapesShareAMeshFromAnyThread) {
  std::vector<std::shared_ptr<const Mesh>> got(8);
  std::vector<std::thread> threads;
  for (auto& g : got) threads.emplace_back([&g] { g = realise(text("share", 0.1)).mesh; });
  for (auto& t : threads) t.join();
  for (const auto& g : got) EXPECT_EQ(g, realise(text("share", 0.1)).mesh);
}

TEST(Geometry, NothingAndAbsurdMeasuresAreEmpty) {
  for (int k = 0; k <= static_cast<int>(Kind::camera); ++k)
    for (const double measure : {0.0, 1e300, 1e-300, -1.0, 1e17}) {
      Shape s = shape(static_cast<Kind>(k));
      s.size = {measure, measure, measure};
      s.radius = s.height = s.tube = s.width = s.depth = measure;
      s.text = std::string("x");
      for (const Corners& points : {Corners{}, Corners{{0, 0, 0}}, Corners(5, Vec3{1, 1, 1}),
                                    Corners{{measure, 0, 0}, {0, measure, 1}, {-measure, 0, measure}}}) {
        s.points = points;
        const Geometry g = realise(s);
        ASSERT_TRUE(g.mesh);
        for (const auto& p : g.mesh->positions)
          for (const float f : p) EXPECT_TRUE(std::isfinite(f)) << k << " " << measure;
        for (const double m : g.local.m) EXPECT_TRUE(std::isfinite(m)) << k << " " << measure;
      }
    }
  EXPECT_TRUE(realise(shape(Kind::mesh)).mesh->positions.empty());
  Shape none = shape(Kind::sphere);
  none.radius = 0;
  EXPECT_TRUE(realise(none).mesh->positions.empty());
}

TEST(Geometry, PolygonsAreFilledWhateverTheirForm) {
  EXPECT_NEAR(front(*realise(polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}})).mesh), 4, 1e-6);
  EXPECT_NEAR(front(*realise(polygon({{0, 0, 0}, {0, 2, 0}, {2, 2, 0}, {2, 0, 0}})).mesh), 4, 1e-6) << "clockwise";
  EXPECT_NEAR(front(*realise(polygon({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0.5, 0}, {0, 2, 0}})).mesh), 2.5, 1e-6)
      << "concave";
  EXPECT_NEAR(front(*realise(polygon({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}})).mesh), 2, 1e-6)
      << "figure of eight";
  // A five-pointed star drawn in one go: its middle is filled.
  Corners star;
  for (int i = 0; i < 5; ++i) star.push_back({std::sin(4 * pi * i / 5), std::cos(4 * pi * i / 5), 0});
  const double inner = std::cos(2 * pi / 5) / std::cos(pi / 5);
  EXPECT_NEAR(front(*realise(polygon(star)).mesh), 5 * inner * std::sin(pi / 5), 1e-5);
  const Mesh upright = *realise(polygon({{0, 0, 0}, {0, 0, 2}, {0, 2, 2}, {0, 2, 0}})).mesh;
  for (const auto& n : upright.normals) EXPECT_NEAR(std::abs(n[0]), 1, 1e-6);
  EXPECT_EQ(upright.edges.size(), 2U * 4);
}

TEST(Geometry, TextIsWideAsItsLettersAndCentred) {
  const Mesh i = *realise(text("I")).mesh, w = *realise(text("W")).mesh;
  ASSERT_FALSE(i.triangles.empty());
  EXPECT_LT(width(i), width(w) / 3);
  EXPECT_NEAR(w.box().low[0], -w.box().high[0], 0.02);
  EXPECT_NEAR(w.box().low[1], 0, 1e-3) << "on the baseline";
  EXPECT_NEAR(w.box().high[1], 0.729, 5e-3) << "a capital's height in this font";
  Shape big = text("W");
  big.size.y = 3;
  EXPECT_NEAR(width(*realise(big).mesh), 3 * width(w), 1e-5);
  EXPECT_NEAR(front(*realise(big).mesh), 9 * front(w), 1e-4);
  const Mesh two = *realise(text("W\nW")).mesh;
  EXPECT_NEAR(two.box().low[1], -1.2, 1e-3);
  for (const auto& n : w.normals) EXPECT_EQ(n, (std::array<float, 3>{0, 0, 1}));
  EXPECT_FALSE(w.closed);
  EXPECT_TRUE(realise(text(" \n ")).mesh->triangles.empty());
  EXPECT_TRUE(realise(text("")).mesh->triangles.empty());
  realise(text("\xff\xfe broken \xc0 UTF-8 \xf0\x9f\x92\xa9 مرحبا"));
}

TEST(Geometry, DeepTextIsAClosedBody) {
  for (const char* words : {"I", "O", "B8&@", "Betwixt", "fi%"}) {
    const Mesh flat = *realise(text(words)).mesh, deep = *realise(text(words, 0.25)).mesh;
    EXPECT_TRUE(deep.closed) << words;
    EXPECT_NEAR(signed_volume(deep), 0.25 * front(flat), 1e-5) << words;
    EXPECT_NEAR(deep.box().low[2], -0.125, 1e-6);
    EXPECT_NEAR(deep.box().high[2], 0.125, 1e-6);
    for (const auto& n : deep.normals) EXPECT_NEAR(length(widen(n)), 1, 1e-6);
  }
  EXPECT_EQ(realise(text("I", 0.25)).mesh->edges.size(), 2U * 12) << "a box";
}

TEST(Fonts, MissingOnesHaveANearMiss) {
  EXPECT_TRUE(find_font("DejaVu Sans"));
  EXPECT_TRUE(find_font("dejavu sans"));
  const auto missing = find_font("DejaVu Sons");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, Code::name);
  EXPECT_EQ(missing.error().message, "this machine has no font called \"DejaVu Sons\"");
  EXPECT_EQ(missing.error().hint, "did you mean \"DejaVu Sans\"?");
  EXPECT_FALSE(text_outline("x", "No Such Font At All").contours.empty()) << "another one stands in";
}

TEST(Fonts, ContoursBelongToLetters) {
  const Outline outline = text_outline("ai b\ne\u0301:", "DejaVu Sans");
  std::vector<std::pair<std::string, std::size_t>> got;
  for (const auto& letter : outline.letters) got.emplace_back(letter.text, letter.first);
  // An a, a b and an e have a hole each, an i has a dot, and an accent goes with its letter.
  EXPECT_EQ(got, (decltype(got){{"a", 0}, {"i", 2}, {"b", 4}, {"e\u0301", 6}, {":", 9}}));
  EXPECT_EQ(outline.contours.size(), 11U);
  EXPECT_TRUE(text_outline(" \n ", "DejaVu Sans").letters.empty());
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

// The contours of one letter of a text.
std::vector<Contour> letter(const std::string& words, std::size_t i) {
  const Outline o = text_outline(words, "DejaVu Sans");
  const auto at = [&](std::size_t n) { return o.contours.begin() + static_cast<std::ptrdiff_t>(n); };
  return {at(o.letters[i].first), i + 1 < o.letters.size() ? at(o.letters[i + 1].first) : o.contours.end()};
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
  EXPECT_EQ(why, "1225 vertices against 24");
  Shape a = shape(Kind::polyline), b = a;
  a.points = Corners(3, Vec3{}), b.points = Corners(5, Vec3{});
  EXPECT_FALSE(can_blend(a, b, &why));
  EXPECT_EQ(why, "3 points against 5");
  EXPECT_EQ(realise_blend(shape(Kind::sphere), shape(Kind::box), 0.99).mesh, realise(shape(Kind::sphere)).mesh);
  EXPECT_EQ(realise_blend(shape(Kind::sphere), shape(Kind::box), 1.5).mesh, realise(shape(Kind::box)).mesh);
}

}  // namespace
}  // namespace betwixt

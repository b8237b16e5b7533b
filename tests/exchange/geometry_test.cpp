// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/geometry.h"

#include <gtest/gtest.h>

#include <thread>

#include "exchange/fonts.h"
#include "exchange/some_shapes.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

double width(const Mesh& m) { return m.box().high.x - m.box().low.x; }

TEST(Geometry, MeasuresAreInTheScaling) {
  Shape s = shape(Kind::sphere), t = s;
  s.radius = 2, t.radius = 5;
  const Geometry a = realise(s), b = realise(t);
  EXPECT_EQ(a.mesh, b.mesh);
  EXPECT_EQ(a.local, scaling({2, 2, 2}));
  EXPECT_EQ(b.local, scaling({5, 5, 5}));
  EXPECT_NE(a.mesh, realise(s, {96}).mesh);
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

// A page: each letter is that of a text of its own, and they stand side by side.
TEST(Geometry, ManyLettersAreEachTheirOwn) {
  const auto area = [](const Mesh& m) {
    double sum = 0;
    for (std::size_t i = 0; i < m.triangles.size(); i += 3) {
      const auto at = [&](std::size_t k) {
        const auto& p = m.positions[m.triangles[i + k]];
        return Vec3{p[0], p[1], p[2]};
      };
      sum += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
    }
    return sum;
  };
  std::string page;
  for (int line = 0; line < 100; ++line) page += "The quick brown fox jumps over a lazy dog.\n";
  double one = 0;
  for (const char c : std::string("Thequickbrownfoxjumpsoveralazydog."))
    one += area(*realise(text(std::string(1, c))).mesh);
  EXPECT_NEAR(area(*realise(text(page)).mesh), 100 * one, 1e-3 * 100 * one);
  const Mesh deep = *realise(text("ox", 0.3)).mesh;
  EXPECT_TRUE(deep.closed);
  EXPECT_EQ(deep.triangles.size(),
            realise(text("o", 0.3)).mesh->triangles.size() + realise(text("x", 0.3)).mesh->triangles.size());
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

}  // namespace
}  // namespace betwixt

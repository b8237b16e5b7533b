// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/primitives.h"

#include <gtest/gtest.h>

#include <map>

#include "scene/meshes.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

double area(const Mesh& m) {
  double sum = 0;
  for (std::size_t i = 0; i < m.triangles.size(); i += 3) {
    const Vec3 a = widen(m.positions[m.triangles[i]]), b = widen(m.positions[m.triangles[i + 1]]),
               c = widen(m.positions[m.triangles[i + 2]]);
    sum += length(cross(b - a, c - a)) / 2;
  }
  return sum;
}

// Every edge twice, once each way; counted without the code under test.
bool watertight(const Mesh& m) {
  std::map<std::array<float, 3>, int> names;
  const auto id = [&](std::uint32_t i) {
    auto p = m.positions[i];
    for (auto& f : p) f += 0.0F;
    return names.try_emplace(p, static_cast<int>(names.size())).first->second;
  };
  std::map<std::pair<int, int>, int> uses;
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    ++uses[{id(m.triangles[i]), id(m.triangles[i % 3 == 2 ? i - 2 : i + 1])}];
  for (const auto& [edge, n] : uses)
    if (uses[{edge.second, edge.first}] != n) return false;
  return true;
}

TEST(Primitives, AreSoundAndClosed) {
  for (const int n : {3, 4, 12, 24, 48, 96}) {
    const std::map<const char*, Mesh> bodies{{"sphere", sphere_mesh(n, std::max(2, n / 2))},
                                             {"box", box_mesh()},
                                             {"round box", round_box_mesh({1, 0.5, 0.7}, 0.1, std::max(1, n / 8))},
                                             {"ball of a box", round_box_mesh({1, 1, 1}, 1, std::max(1, n / 8))},
                                             {"cylinder", cylinder_mesh(n)},
                                             {"cone", cone_mesh(n)},
                                             {"torus", torus_mesh(1, 0.3, n, n)}};
    for (const auto& [name, mesh] : bodies) {
      if (n > 3) expect_sound(mesh, name);
      EXPECT_TRUE(mesh.closed) << name;
      EXPECT_TRUE(watertight(mesh)) << name << " " << n;
      EXPECT_TRUE(is_closed(mesh)) << name << " " << n;
      EXPECT_GT(signed_volume(mesh), 0) << name;
    }
    expect_sound(disc_mesh(n), "disc");
    EXPECT_FALSE(disc_mesh(n).closed);
    EXPECT_FALSE(is_closed(disc_mesh(n)));
  }
  expect_sound(plane_mesh(), "plane");
}

TEST(Primitives, MeasureWhatTheFormulasSay) {
  // The error of an inscribed body shrinks with the square of the detail.
  for (const int n : {24, 48, 96, 192}) {
    const double close = 30.0 / (n * n);
    EXPECT_NEAR(signed_volume(sphere_mesh(n, n / 2)) / (4 * pi / 3), 1, close);
    EXPECT_NEAR(area(sphere_mesh(n, n / 2)) / (4 * pi), 1, close);
    EXPECT_NEAR(signed_volume(cylinder_mesh(n)) / pi, 1, close);
    EXPECT_NEAR(area(cylinder_mesh(n)) / (4 * pi), 1, close);
    // The core, a slab on each face, a quarter of a cylinder on each edge, and eighths of a ball.
    const double a = 1.8, b = 0.8, c = 1.2, r = 0.1;
    const double volume =
        a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) + 4 * pi / 3 * r * r * r;
    const double surface = 2 * (a * b + b * c + c * a) + 2 * pi * r * (a + b + c) + 4 * pi * r * r;
    const Mesh round = round_box_mesh({1, 0.5, 0.7}, r, n / 8);
    EXPECT_NEAR(signed_volume(round) / volume, 1, close);
    EXPECT_NEAR(area(round) / surface, 1, close);
    EXPECT_NEAR(signed_volume(cone_mesh(n)) / (pi / 3), 1, close);
    EXPECT_NEAR(area(cone_mesh(n)) / (pi + pi * std::sqrt(2)), 1, close);
    EXPECT_NEAR(signed_volume(torus_mesh(2, 0.5, n, n)) / (2 * pi * pi * 2 * 0.25), 1, close);
    EXPECT_NEAR(area(disc_mesh(n)) / pi, 1, close);
  }
  EXPECT_NEAR(signed_volume(box_mesh()), 1, 1e-6);
  EXPECT_NEAR(area(box_mesh()), 6, 1e-6);
}

TEST(Primitives, SphereWearsAMapAsAGlobeDoes) {
  const Mesh m = sphere_mesh(96, 48);
  for (std::size_t i = 0; i < m.positions.size(); ++i) {
    const Vec3 p = widen(m.positions[i]);
    EXPECT_NEAR(m.uvs[i][1], std::acos(p.y) / pi, 1e-3);
    if (std::hypot(p.x, p.z) < 1e-3 || std::abs(m.uvs[i][0] - 0.5F) > 0.49F) continue;
    EXPECT_NEAR(m.uvs[i][0], 0.5 + std::atan2(p.x, p.z) / (2 * pi), 1e-5);
  }
}

TEST(Primitives, WireframeHasNoDiagonals) {
  EXPECT_EQ(box_mesh().edges.size(), 2U * 12);
  EXPECT_EQ(plane_mesh().edges.size(), 2U * 4);
  EXPECT_EQ(disc_mesh(24).edges.size(), 2U * 24);
  EXPECT_EQ(cylinder_mesh(24).edges.size(), 2U * 3 * 24);
  EXPECT_EQ(cone_mesh(24).edges.size(), 2U * 2 * 24);
  EXPECT_EQ(sphere_mesh(24, 12).edges.size(), 2U * (24 * 12 + 24 * 11));  // meridians and parallels
}

TEST(Primitives, TubeIsARoundClosedLine) {
  const double d = 0.2, r = d / 2;
  const Mesh straight = tube_mesh({{0, 0, 0}, {3, 0, 0}}, d, 64);
  expect_sound(straight, "tube");
  EXPECT_TRUE(watertight(straight));
  EXPECT_NEAR(signed_volume(straight) / (pi * r * r * 3 + 4 * pi / 3 * r * r * r), 1, 0.01);
  const Box box = straight.box();
  EXPECT_NEAR(box.low[0], -r, 1e-6);
  EXPECT_NEAR(box.high[0], 3 + r, 1e-6);
  // Corners, a way back, the same point twice.
  const Mesh bent = tube_mesh({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0.2, 0}, {1, 1, 1}}, d, 16);
  EXPECT_TRUE(watertight(bent));
  for (const auto& p : bent.positions)
    for (const float f : p) EXPECT_TRUE(f >= -r - 1e-6 && f <= 1 + r + 1e-6);
  for (const auto& n : bent.normals) EXPECT_NEAR(length(widen(n)), 1, 1e-6);
  EXPECT_TRUE(tube_mesh({}, d, 8).triangles.empty());
  EXPECT_TRUE(watertight(tube_mesh({{1, 2, 3}}, d, 8)));
}

// What a tube says of its edges against a search through all sides of all triangles.
TEST(Primitives, ATubesEdgesAreThoseWhereItBends) {
  using Edge = std::pair<std::array<float, 3>, std::array<float, 3>>;
  const auto places = [](const Mesh& m, const std::vector<std::uint32_t>& edges) {
    std::vector<Edge> all;
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
      auto e = std::pair(m.positions[edges[i]], m.positions[edges[i + 1]]);
      if (e.second < e.first) std::swap(e.first, e.second);
      all.push_back(e);
    }
    std::sort(all.begin(), all.end());
    return all;
  };
  std::vector<Vec3> spiral, gentle{{0, 0, 0}, {1, 0.01, 0.02}, {2, 0.024, 0.041}, {3, 0.3, 0.1}};
  for (int i = 0; i < 60; ++i) spiral.push_back({i * 0.1, std::cos(i * 0.7), std::sin(i * 0.7)});
  for (const auto& line : {spiral, gentle, std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}}})
    for (const int around : {3, 4, 7, 24}) {
      const Mesh m = tube_mesh(line, 0.05, around);
      const auto edges = places(m, m.edges);
      EXPECT_EQ(edges, places(m, crease_edges(m))) << line.size() << " points, " << around << " sides";
      EXPECT_FALSE(edges.empty());
    }
}

TEST(Primitives, BallsAndLines) {
  const Mesh balls = balls_mesh({{0, 0, 0}, {5, 0, 0}}, 2, sphere_mesh(64, 32));
  EXPECT_NEAR(signed_volume(balls) / (2 * 4 * pi / 3), 1, 0.02);
  EXPECT_NEAR(balls.box().high[0], 6, 0.01);
  const Mesh line = line_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
  EXPECT_EQ(line.edges, (std::vector<std::uint32_t>{0, 1, 1, 2}));
  EXPECT_TRUE(line.triangles.empty());
  EXPECT_TRUE(line_mesh({}).edges.empty());
}

}  // namespace
}  // namespace betwixt

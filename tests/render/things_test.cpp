// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

TEST(RenderPlace, OrthographicPointIsWhereItMustBe) {
  Frame f = frame();
  f.items.push_back(item(square(), translation({2, 3, 0}) * scaling({0.4, 0.4, 1}), {1, 1, 1}));
  const auto [x, y] = middle(draw(f, {200, 100, 1, "shaded"}));
  // 10 m are 100 pixels; the middle of the picture is (100, 50), rows go down.
  EXPECT_NEAR(x, 100 + 20, 0.01);
  EXPECT_NEAR(y, 50 - 30, 0.01);
}

TEST(RenderPlace, PerspectivePointIsWhereItMustBe) {
  Frame f = frame(10);
  f.camera.orthographic = false;
  f.camera.fov = 2 * std::atan(0.5);  // at distance d the picture is d metres wide
  f.items.push_back(item(sphere(0.2), translation({1, -1.5, -10}), {1, 1, 1}));
  for (const int samples : {1, 4, 9, 16}) {
    const auto [x, y] = middle(draw(f, {400, 300, samples, "shaded"}));
    EXPECT_NEAR(x, 200 + 400 * (1.0 / 20), 0.3) << samples;
    EXPECT_NEAR(y, 150 + 400 * (1.5 / 20), 0.3) << samples;
  }
}

TEST(RenderPlace, ABallCoversWhatItsOutlineEncloses) {
  Frame f = frame(5);
  f.camera.orthographic = false;
  f.camera.fov = 2 * std::atan(0.5);
  f.items.push_back(item(sphere(1), Mat4{}, {1, 1, 1}));
  const Picture p = draw(f, {500, 500, 1, "shaded"});
  int covered = 0;
  for (int x = 0; x < 500; ++x) covered += pixel(p, x, 250).r > 128 ? 1 : 0;
  // The outline is seen under asin(1 / 5); 500 pixels are 1 m at 1 m distance.
  EXPECT_NEAR(covered, 2 * 500 * std::tan(std::asin(1.0 / 5)), 2);
}

TEST(RenderPlace, AStretchedBallToo) {
  Frame f = frame();
  f.items.push_back(item(sphere(1), rotation(axis_angle({0, 0, 1}, 0.5)) * scaling({4, 1, 2}), {1, 1, 1}));
  const Picture p = draw(f, {200, 200, 1, "shaded"});
  // Half the height of the box around an ellipse with half-axes 4 and 1, turned by 0.5.
  const double half = std::hypot(4 * std::sin(0.5), std::cos(0.5)) * 20;
  int top = 200, bottom = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      if (pixel(p, x, y).r > 128) top = std::min(top, y), bottom = std::max(bottom, y + 1);
  EXPECT_NEAR(top, 100 - half, 1.5);
  EXPECT_NEAR(bottom, 100 + half, 1.5);
}

TEST(RenderPlace, BallsMeetOtherThingsWhereTheirSurfaceIs) {
  // A square at z = 0.6 cuts the unit ball in a circle of radius 0.8.
  Frame f = frame();
  f.items.push_back(item(sphere(1), Mat4{}, {1, 0, 0}));
  f.items.push_back(item(square(), translation({0, 0, 0.6}) * scaling({4, 4, 1}), {0, 1, 0}));
  const Picture p = draw(f, {500, 500, 1, "shaded"});
  int red = 0;
  for (int x = 0; x < 500; ++x) red += pixel(p, x, 250).r > 128 ? 1 : 0;
  EXPECT_NEAR(red, 1.6 * 50, 2);
}

TEST(RenderPlace, FarFromTheOriginNothingMoves) {
  const Vec3 far{3e8, -2e8, 1e8};
  Frame near = frame();
  near.items.push_back(item(sphere(1.5), translation({1, 2, 0}), {1, 0.5, 0.2}, Material::plastic));
  Frame there = near;
  there.camera.world = translation(far + Vec3{0, 0, 10});
  there.items[0].world = translation(far + Vec3{1, 2, 0});
  EXPECT_EQ(draw(near).rgba, draw(there).rgba);
}

TEST(RenderFacing, AMirroredClosedMeshStillShowsItsOutside) {
  // Faces +z and may be culled; mirrored in x it must be seen from +z and not from -z.
  for (const double sx : {1.0, -1.0}) {
    Frame f = frame();
    f.items.push_back(item(square(true), scaling({sx * 4, 4, 1}), {1, 1, 1}));
    EXPECT_EQ(pixel(draw(f), 50, 50).r, 255) << sx;
    f.camera.world = rotation(axis_angle({0, 1, 0}, pi)) * translation({0, 0, 10});
    EXPECT_EQ(pixel(draw(f), 50, 50).r, 0) << sx;
  }
}

TEST(RenderFacing, LightFallsOnTheSameSideOfAMirroredThing) {
  Frame f = frame();
  Light sun;
  sun.sun = true, sun.direction = {0, 0, -1};
  f.lights.push_back(sun);
  f.items.push_back(item(square(true), scaling({4, 4, 1}), {0.5, 0.5, 0.5}, Material::matte));
  const Pixel plain = pixel(draw(f), 50, 50);
  f.items[0].world = scaling({-4, 4, 1});
  EXPECT_EQ(pixel(draw(f), 50, 50), plain);
  EXPECT_GT(plain.r, 128);
}

TEST(RenderRobust, ThingsThatCannotBeDrawnAreLeftOut) {
  const double nan = std::nan(""), huge = std::numeric_limits<double>::infinity();
  Frame f = frame();
  f.items.push_back(item(square(), translation({2, 2, 0}), {1, 1, 1}));
  const Picture expected = draw(f);
  Mat4 bad;
  bad(1, 2) = nan;
  f.items.push_back(item(sphere(), bad, {1, 1, 1}));
  f.items.push_back(item(sphere(), translation({huge, 0, 0}), {1, 1, 1}));
  f.items.push_back(item(sphere(), translation({0, 0, 1e300}), {1, 1, 1}));
  f.items.push_back(item(sphere(), scaling({0, 0, 0}), {1, 1, 1}));
  f.items.push_back(item(sphere(), scaling({0, 1, 0}), {1, 1, 1}));
  f.items.push_back(item(sphere(), Mat4{}, {nan, 1, 1}));
  f.items.push_back(item(nullptr, Mat4{}, {1, 1, 1}));
  f.items.push_back(item(std::make_shared<Shape>(), Mat4{}, {1, 1, 1}));
  EXPECT_EQ(draw(f).rgba, expected.rgba);
}

TEST(RenderRobust, MeshesWithBrokenIndicesDrawNothing) {
  auto mesh = std::make_shared<Mesh>(*square()->mesh);
  mesh->triangles = {0, 1, 4000000000U};
  mesh->edges = {0, 77};
  auto shape = std::make_shared<Shape>();
  shape->kind = Kind::mesh, shape->mesh = mesh;
  Frame f = frame();
  f.items.push_back(item(shape, scaling({5, 5, 1}), {1, 1, 1}));
  for (const Style& style : styles()) EXPECT_EQ(pixel(draw(f, {20, 20, 1, std::string(style.name)}), 10, 10).r, 0);
}

TEST(RenderRobust, ACameraWithoutSenseSeesTheBackground) {
  Frame f = frame();
  f.items.push_back(item(square(), Mat4{}, {1, 1, 1}));
  f.camera.world(0, 3) = std::nan("");
  f.background = Vec3{0, 1, 0};
  EXPECT_EQ(pixel(draw(f), 50, 50), (Pixel{0, 255, 0, 255}));
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests contact shading: where it must be darker, by the positions of objects, and where nothing may change.
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

// All light comes from everywhere, the same from each side.
Frame evenly_lit() {
  Frame f;
  f.background = Vec3{0, 0, 1};
  f.surroundings.ambient = Vec3{0.5, 0.5, 0.5}, f.surroundings.contact = true;
  f.lights = {lamp({0, 500, 0}, 1)};  // reaches nothing
  return f;
}
Frame without(Frame f) {
  f.surroundings.contact = false;
  return f;
}
Item card(const Mat4& world) { return item(square(), world, {0.8, 0.8, 0.8}, Material::matte); }
Mat4 turned(Vec3 axis, double degrees) { return rotation(axis_angle(axis, degrees * pi / 180)); }

int largest_difference(const Picture& a, const Picture& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
  return most;
}

TEST(RenderContact, WhatIsFlatStaysAsItIs) {
  for (const int samples : {1, 4, 9})
    for (const double tilt : {10.0, 80.0}) {
      Frame f = evenly_lit();
      f.camera.world = translation({0, 0, 6});
      f.items = {card(turned({1, 0.3, 0}, tilt) * scaling({40, 40, 1}))};
      const RenderOptions options{120, 90, samples, "shaded"};
      EXPECT_LE(largest_difference(draw(f, options), draw(without(f), options)), 1) << samples << " " << tilt;
      f.camera.orthographic = true, f.camera.height = 8;
      EXPECT_LE(largest_difference(draw(f, options), draw(without(f), options)), 1) << samples << " " << tilt;
    }
  Frame floor = evenly_lit();
  floor.camera.world = look_at({0, 2, 8}, {});
  floor.surroundings.ground = Vec3{0.5, 0.5, 0.5};
  EXPECT_LE(largest_difference(draw(floor), draw(without(floor))), 1);
}

// Two walls that meet at a right angle in the line x = 0, looked at from the middle between them.
Frame corner() {
  Frame f = evenly_lit();
  f.camera.world = translation({0, 0, 10});
  f.camera.orthographic = true, f.camera.height = 10;
  const Mat4 wide = scaling({30, 30, 1}) * translation({0.5, 0, 0});
  f.items = {card(turned({0, 1, 0}, -45) * wide), card(turned({0, 1, 0}, 45) * scaling({-1, 1, 1}) * wide)};
  return f;
}

// The share of the light from everywhere that one wall keeps from the other, `away` metres from where they meet: each
// way up, by its cosine, as much as what it meets is near, which is nothing at `reach` metres.
double share_in_corner(double away, double reach) {
  constexpr int turns = 400, rises = 2000;
  double sum = 0;
  for (int i = 0; i < turns; ++i) {
    const double toward = std::cos(pi * ((i + 0.5) / turns - 0.5));  // half of the ways around go away from the wall
    double below = 0, some = 0;
    for (int k = 0; k < rises; ++k) {  // up the other wall: how near that is, and by how much the share below it grows
      const double up = reach * (k + 1) / rises, along = away / toward, d = std::hypot(up, along);
      if (d >= reach) break;
      some += std::pow(1 - std::pow(d / reach, 4), 2) * (up * up / (d * d) - below);
      below = up * up / (d * d);
    }
    sum += some / 2 / turns;
  }
  return sum;
}

TEST(RenderContact, ACornerKeepsHalfOfTheLightAway) {
  constexpr int size = 1000;
  const Picture p = draw(corner(), {size, size, 1, "shaded"}),
                plain = draw(without(corner()), {size, size, 1, "shaded"});
  const auto kept = [&](int from_edge) {  // the mean along the edge
    double all = 0, some = 0;
    for (int y = 400; y < 600; ++y) {
      all += decoded(pixel(plain, size / 2 + from_edge, y).r / 255.0);
      some += decoded(pixel(p, size / 2 + from_edge, y).r / 255.0);
    }
    return 1 - some / all;
  };
  const double metre = size / 10.0, reach = 10.0 / 5;
  EXPECT_NEAR(share_in_corner(1e-6, reach), 0.5, 0.01) << "half of what there is to see is the other wall";
  for (const int x : {2, 4, 8, 16, 24, 60, 90})
    EXPECT_NEAR(kept(x), share_in_corner((x + 0.5) / metre * std::sqrt(2), reach), 0.06) << x;
  EXPECT_EQ(kept(160), 0);
}

TEST(RenderContact, CornersAreDarkerTheNearer) {
  const Picture p = draw(corner(), {400, 400, 4, "shaded"}), plain = draw(without(corner()), {400, 400, 4, "shaded"});
  EXPECT_LT(pixel(p, 200, 200).r, pixel(plain, 200, 200).r - 25);
  for (int x = 202; x < 240; ++x) EXPECT_GE(pixel(p, x, 200).r, pixel(p, x - 1, 200).r - 1) << x;
  for (int x = 1; x < 199; ++x) {  // both walls alike; to a pixel, as every other one is measured
    const auto [low, high] =
        std::minmax({pixel(p, 398 - x, 200).r, pixel(p, 399 - x, 200).r, pixel(p, 400 - x, 200).r});
    EXPECT_GE(pixel(p, x, 200).r, low - 4) << x;
    EXPECT_LE(pixel(p, x, 200).r, high + 4) << x;
  }
  for (const int x : {20, 100, 130, 270, 300, 380}) EXPECT_NEAR(pixel(p, x, 200).r, pixel(plain, x, 200).r, 1) << x;
  for (int y = 40; y < 360; ++y)
    EXPECT_NEAR(pixel(p, 205, y).r, pixel(p, 205, 200).r, 2) << "no noise, no stripes " << y;
}

TEST(RenderContact, EdgesAreNotDarker) {
  Frame f = corner();  // from behind it is an edge
  f.camera.world = look_at({0, 0, -10}, {});
  EXPECT_LE(largest_difference(draw(f), draw(without(f))), 1);
}

TEST(RenderContact, NoRingsOnAWallBehindWhatStandsBeforeIt) {
  for (const bool orthographic : {true, false})
    for (const double before : {2.5, 3.5, 7.0})
      for (const int samples : {1, 4, 9}) {
        Frame f = evenly_lit();
        f.camera.world = translation({0, 0, 10});
        f.camera.orthographic = orthographic, f.camera.height = 10;
        f.items = {card(scaling({60, 60, 1})), card(translation({0.3, 0, before}) * turned({0, 0, 1}, 20)),
                   item(sphere(0.4), translation({-3, 0.5, before + 0.4}), {1, 0, 0}, Material::matte)};
        const RenderOptions options{240, 180, samples, "shaded"};
        EXPECT_TRUE(draw(f, options).rgba == draw(without(f), options).rgba)
            << orthographic << " " << before << " " << samples;
      }
}

// A box of 2 m on the floor, whose front meets it in the middle of the picture.
TEST(RenderContact, ABoxDarkensTheFloorFromItsEdgeToAsFarAsItReaches) {
  Frame f = evenly_lit();
  f.camera.world = look_at({0, 6, 8}, {0, 0, 1});
  f.camera.fov = 0.9;
  f.surroundings.ground = Vec3{0.5, 0.5, 0.5};
  for (const double turn : {0.0, 90.0, 180.0, 270.0})
    f.items.push_back(card(turned({0, 1, 0}, turn) * translation({0, 1, 1}) * scaling({2, 2, 1})));
  const RenderOptions options{400, 400, 4, "shaded"};
  const Picture p = draw(f, options), plain = draw(without(f), options);
  const int reach = 400 / 5;
  int last = pixel(p, 200, 201).r;
  EXPECT_LT(last, 0.86 * pixel(plain, 200, 201).r);
  for (int y = 201; y < 201 + reach; ++y) {
    EXPECT_GE(pixel(p, 200, y).r, last - 1) << y;
    last = pixel(p, 200, y).r;
  }
  for (int y = 200 + reach + 4; y < 400; ++y)
    for (int x = 0; x < 400; ++x) ASSERT_EQ(pixel(p, x, y), pixel(plain, x, y)) << x << " " << y;
}

// The floor goes on behind all that is on it, where depths end: that is no wall.
TEST(RenderContact, NoLineAcrossTheFloorTowardsTheHorizon) {
  for (const double height : {0.4, 1.5, 5.0})
    for (const bool orthographic : {false, true}) {
      Frame f = evenly_lit();
      f.camera.world = look_at({1, height, 5}, {0.5, 0.6, 0}), f.camera.fov = 0.9;
      f.camera.orthographic = orthographic, f.camera.height = 4;
      f.surroundings.ground = Vec3{0.5, 0.5, 0.5};
      f.items = {item(sphere(0.5), translation({0.5, 0.5, 0}), {0.8, 0.8, 0.8}, Material::matte)};
      const RenderOptions options{1280, 720, 1, "shaded"};
      const Picture p = draw(f, options), plain = draw(without(f), options);
      int most = 0;
      for (int y = 0; y < p.height; ++y)
        for (const int x : {5, 100, 250, 1030, 1180, 1275})
          most = std::max(most, std::abs(pixel(p, x, y).r - pixel(plain, x, y).r));
      EXPECT_LE(most, 1) << height << orthographic;
    }
}

Frame ball_on_floor() {
  Frame f = evenly_lit();
  f.camera.world = look_at({0, 3, 8}, {0, 0.7, 0});
  f.surroundings.ground = Vec3{0.5, 0.5, 0.5};
  f.items = {item(sphere(1), translation({0, 1, 0}), {0.8, 0.8, 0.8}, Material::matte)};
  return f;
}
Pixel where(const Frame& f, const Picture& p, Vec3 spot) {
  const Vec3 off = spot - translation_of(f.camera.world);
  const auto along = [&](int axis) { return dot(off, column(f.camera.world, axis)); };
  const double scale = 0.5 * p.width / std::tan(f.camera.fov / 2) / -along(2);
  return pixel(p, static_cast<int>(0.5 * p.width + scale * along(0)),
               static_cast<int>(0.5 * p.height - scale * along(1)));
}

TEST(RenderContact, ThingsStandOnTheFloor) {
  const RenderOptions options{480, 270, 4, "shaded"};
  const Frame f = ball_on_floor();
  const Picture p = draw(f, options), plain = draw(without(f), options);
  const auto darker = [&](Vec3 spot) { return where(f, plain, spot).r - where(f, p, spot).r; };
  EXPECT_GT(darker({0, 0, 0.45}), 8);  // the nearest of the floor that is seen under the ball
  for (double z = 0.5; z < 1.5; z += 0.05) EXPECT_LE(darker({0, 0, z}), darker({0, 0, z - 0.05}) + 1) << z;
  EXPECT_LT(darker({0, 0, 2.5}), 2);
  EXPECT_LT(darker({3, 0, 0}), 2);
  EXPECT_LT(darker({0, 1.4, 0.9}), 2) << "the ball is round, not hollow";
  Frame lifted = f;
  lifted.items[0].world = translation({0, 2.2, 0});
  EXPECT_LT(where(f, draw(without(lifted), options), {0, 0, 0.55}).r - where(f, draw(lifted, options), {0, 0, 0.55}).r,
            3);
}

// What a ball of 1 m keeps away from a place of the floor on which it stands: all of it is above the floor, so that is
// the square of the sine of half the angle that it is seen under, by the cosine to its centre.
double share_of_ball(double away) { return std::pow(1 + away * away, -1.5); }

TEST(RenderContact, ABallKeepsAsMuchAwayAsItCovers) {
  for (const double up : {0.25, 0.5, 1.0})
    for (const int size : {540, 1080}) {
      Frame f = evenly_lit();
      f.camera.world = look_at({0, 20 * up, 20}, {}), f.camera.orthographic = true, f.camera.height = 14;
      f.surroundings.ground = Vec3{0.5, 0.5, 0.5};
      f.items = {item(sphere(1), translation({0, 1, 0}), {0.8, 0.8, 0.8}, Material::matte)};
      const RenderOptions options{size, size, 4, "shaded"};
      const Picture p = draw(f, options), plain = draw(without(f), options);
      const auto kept = [&](Vec3 spot) {
        const auto along = [&](int axis) { return dot(spot, column(f.camera.world, axis)) * size / 14; };
        const int x = static_cast<int>(0.5 * size + along(0)), y = static_cast<int>(0.5 * size - along(1));
        return 1 - decoded(pixel(p, x, y).r / 255.0) / decoded(pixel(plain, x, y).r / 255.0);
      };
      // The nearest that is seen under the ball, in front: where the line of sight that touches it meets the floor.
      const double nearest = std::tan(std::atan(up) / 2), metre = 14.0 / size;
      for (double away = nearest + 2 * metre / up; away < 2; away += 0.1)
        // Seen at such a slant, a metre of the floor is nine pixels, as wide as what is averaged.
        EXPECT_NEAR(kept({0, 0, away}), share_of_ball(away), up < 0.3 && size == 540 ? 0.18 : 0.12)
            << up << ' ' << size << ' ' << away;
      for (double away = 1.1; away < 2; away += 0.1)  // beside the ball
        for (const double side : {-away, away})
          EXPECT_NEAR(kept({side, 0, 0}), share_of_ball(away), 0.12) << up << ' ' << size << ' ' << side;
    }
}

// The floor before the ball, and beside it: there are no dots and streaks in what gets darker evenly.
TEST(RenderContact, TheSpotUnderABallIsEven) {
  Frame f = evenly_lit();
  f.camera.world = look_at({0, 1.6, 5}, {0, 0.4, 0}), f.camera.fov = 0.7;
  f.surroundings.ground = Vec3{0.5, 0.5, 0.5};
  f.items = {item(sphere(0.5), translation({0, 0.5, 0}), {0.8, 0.8, 0.8}, Material::matte)};
  const RenderOptions options{960, 540, 4, "shaded"};
  const Picture p = draw(f, options), plain = draw(without(f), options);
  const auto kept = [&](int x, int y) {
    return 1 - decoded(pixel(p, x, y).r / 255.0) / decoded(pixel(plain, x, y).r / 255.0);
  };
  int last = 0;  // row in which the ball is seen
  for (int y = 0; y < 540; ++y)
    if (pixel(plain, 480, y).r > pixel(plain, 5, 539).r + 20) last = y;
  double bends = 0, sum = 0;
  int count = 0;
  for (int y = last - 6; y < last + 16; ++y)
    for (const int side : {-1, 1})
      for (int away = 60; away < 180; ++away, ++count) {
        const int x = 480 + side * away;
        bends += std::pow(kept(x - 3, y) - 2 * kept(x, y) + kept(x + 3, y), 2), sum += kept(x, y);
      }
  EXPECT_GT(sum / count, 0.12);
  EXPECT_LT(std::sqrt(bends / count), 0.014);
}

TEST(RenderContact, WhatShinesByItselfAndDrawingsStayAsTheyAre) {
  Frame f = corner();
  for (Item& i : f.items) i.material = Material::glow;
  EXPECT_LE(largest_difference(draw(f), draw(without(f))), 1);
  f = corner(), f.surroundings.flat = true;
  EXPECT_EQ(draw(f).rgba, draw(without(f)).rgba);
}

TEST(RenderContact, PicturesAreOpaqueAndKnowNothingOfThoseBefore) {
  for (const int samples : {1, 4, 9, 16}) {
    const RenderOptions options{160, 90, samples, "shaded"};
    Frame f = ball_on_floor();
    f.items.push_back(item(sphere(0.5), translation({1.2, 0.5, 1}), {1, 0, 0}, Material::plastic));
    f.items.back().transparency = 0.5;
    const auto kept = renderer(options);
    Picture p;
    ASSERT_TRUE(kept->render(without(f), p));
    ASSERT_TRUE(kept->render(f, p));
    EXPECT_EQ(p.rgba, draw(f, options).rgba) << samples;
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) ASSERT_EQ(p.rgba[i], 255) << samples;
    ASSERT_TRUE(kept->render(without(f), p));
    EXPECT_EQ(p.rgba, draw(without(f), options).rgba) << samples;
  }
}

}  // namespace
}  // namespace betwixt

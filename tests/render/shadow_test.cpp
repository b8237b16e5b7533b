// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests shadows: fine near the camera's subject, from several lights, and soft ones with the width of closed forms.
#include <algorithm>
#include <array>
#include <functional>
#include <random>

#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

// A ball of 0.1 m on a plane of 1,000 m, seen from 1 m away. The sun is at 45 degrees on the left.
Frame small_ball() {
  Frame f;
  f.camera.world = look_at({0, 0.8, 0.8}, {0.1, 0, 0});
  f.background = Vec3{};
  f.items.push_back(item(square(), look_at({}, {0, -1, 0}) * scaling({1000, 1000, 1}), {1, 1, 1}, Material::matte));
  f.items.push_back(item(sphere(0.1), translation({0, 0.1, 0}), {1, 0, 0}, Material::matte));
  Light sun;
  sun.sun = true, sun.direction = normalize(Vec3{1, -1, 0});
  f.lights = {sun};
  return f;
}

// Counts the pixels of the middle row, right of the ball, that are neither lit nor dark.
int between(const Picture& p) {
  const int dark = pixel(p, p.width / 2, p.height / 2).g, lit = pixel(p, p.width - 2, p.height / 2).g;
  EXPECT_GT(lit, dark + 50);
  int n = 0;
  for (int x = p.width / 2; x < p.width; ++x) {
    const int g = pixel(p, x, p.height / 2).g;
    n += g > dark + (lit - dark) / 10 && g < lit - (lit - dark) / 10;
  }
  return n;
}

TEST(RenderShadow, ASmallBallBesideALargePlaneHasACrispOne) {
  const RenderOptions options{640, 360, 4, "shaded"};
  const Frame f = small_ball();
  const Picture alone = draw(f, options);
  EXPECT_LE(between(alone), 6);
  for (const Vec3 far : {Vec3{0, 0.1, 300}, {0, 0.1, 30}, {-50, 3, 90}}) {  // behind the camera, all of them
    Frame with = f;
    with.items.push_back(item(sphere(0.1), translation(far), {1, 0, 0}, Material::matte));
    EXPECT_EQ(draw(with, options).rgba, alone.rgba) << far.z;
  }
}

// A hill that reaches into the plane is large in the picture, so that near things are small beside it.
TEST(RenderShadow, AHillBehindLeavesItCrisp) {
  const RenderOptions options{640, 360, 4, "shaded"};
  Frame f = small_ball();
  f.camera.world = look_at({0, 0.4, 0.8}, {0.1, 0, 0});
  EXPECT_LE(between(draw(f, options)), 6);
  f.items.push_back(item(sphere(40), translation({0, -20, -90}), {0.4, 0.6, 0.3}, Material::matte));
  EXPECT_LE(between(draw(f, options)), 6);
}

// So many objects that the size of the plane does not matter.
TEST(RenderShadow, ManySmallThingsFarOffLeaveItCrisp) {
  const RenderOptions options{640, 360, 4, "shaded"};
  Frame f = small_ball();
  for (const Vec3 far : {Vec3{-400, 0.1, 300}, {380, 0.1, 420}, {60, 0.1, 250}})  // behind the camera
    f.items.push_back(item(sphere(0.1), translation(far), {1, 0, 0}, Material::matte));
  EXPECT_LE(between(draw(f, options)), 6);
}

// One renderer, two cameras in turn: data that it keeps from one picture must not change the other.
TEST(RenderShadow, WhatIsFineFollowsTheCamera) {
  const RenderOptions options{320, 180, 4, "shaded"};
  const auto keeping = renderer(options);
  Frame f = small_ball();
  f.items.push_back(item(sphere(0.1), translation({200, 0.1, 0}), {0, 0, 1}, Material::matte));
  for (const double x : {0.0, 200.0, 0.1, 100.0, 200.1}) {
    f.camera.world = look_at({x, 0.8, 0.8}, {x + 0.1, 0, 0});
    Picture p;
    ASSERT_TRUE(keeping->render(f, p));
    EXPECT_EQ(p.rgba, draw(f, options).rgba) << x;
  }
}

double linear(const Pixel& p) { return decoded(p.g / 255.0); }

// A camera from above, with 100 pixels for `height` metres: x of the world is right, z is down.
Frame from_above(double height) {
  Frame f;
  f.camera.world = translation({0, 20, 0}) * rotation(axis_angle({1, 0, 0}, -pi / 2));
  f.camera.orthographic = true, f.camera.height = height;
  f.background = Vec3{}, f.surroundings.ambient = Vec3{};
  f.items.push_back(item(square(), rotation(axis_angle({1, 0, 0}, -pi / 2)) * scaling({60, 60, 1}), {0.5, 0.5, 0.5},
                         Material::matte));
  f.items[0].casts = false;
  return f;
}
double seen_from_above(const Picture& p, double height, double x, double z) {
  const double scale = p.height / height;
  return linear(pixel(p, static_cast<int>(p.width / 2.0 + x * scale), static_cast<int>(p.height / 2.0 + z * scale)));
}

Light sun(Vec3 direction, Casting casting, double strength = 1) {
  Light l;
  l.sun = true, l.direction = normalize(direction), l.casting = casting, l.color = strength * Vec3{1, 1, 1};
  return l;
}
// Returns the light that a sun sends to the floor of `from_above`.
double sent(const Light& sun) { return 0.8 * 0.5 * sun.color.x * -sun.direction.y; }

// A ball 3 m above the floor. The centres of the suns' shadows are at (3, 0) and (3, 1.2).
Frame two_suns(Casting first, Casting second) {
  Frame f = from_above(10);
  f.items.push_back(item(sphere(1), translation({0, 3, 0}), {1, 1, 1}, Material::matte));
  f.lights = {sun({1, -1, 0}, first), sun({1, -1, 0.4}, second, 0.9)};
  return f;
}

TEST(RenderShadow, WhatTwoSunsLeaveIsDarkerThanWhatOneDoes) {
  const Frame f = two_suns(Casting::on, Casting::on);
  const Picture p = draw(f);
  const double a = sent(f.lights[0]), b = sent(f.lights[1]);
  EXPECT_NEAR(seen_from_above(p, 10, -3, 0), a + b, 0.01);
  EXPECT_NEAR(seen_from_above(p, 10, 3, -0.6), b, 0.01) << "what the first leaves";
  EXPECT_NEAR(seen_from_above(p, 10, 3, 1.8), a, 0.01) << "what the second leaves";
  EXPECT_NEAR(seen_from_above(p, 10, 3, 0.6), 0, 0.01) << "what both leave";
}

TEST(RenderShadow, TheStrongestCastsWhereNobodySaysOtherwise) {
  const auto shadows = [](Casting first, Casting second) {
    const Frame f = two_suns(first, second);
    const Picture p = draw(f);
    const double all = sent(f.lights[0]) + sent(f.lights[1]);
    return std::pair(seen_from_above(p, 10, 3, -0.6) < 0.8 * all, seen_from_above(p, 10, 3, 1.8) < 0.8 * all);
  };
  EXPECT_EQ(shadows(Casting::strongest, Casting::strongest), std::pair(true, false));
  EXPECT_EQ(shadows(Casting::off, Casting::strongest), std::pair(false, false));
  EXPECT_EQ(shadows(Casting::off, Casting::on), std::pair(false, true));
  EXPECT_EQ(shadows(Casting::strongest, Casting::soft), std::pair(true, true));
  EXPECT_EQ(shadows(Casting::off, Casting::off), std::pair(false, false));
}

// Six suns with shadows: those of the two weakest are missing, in any order of the suns.
TEST(RenderShadow, FourCastThemTheStrongestFirst) {
  Frame f = from_above(10);
  f.items.push_back(item(sphere(0.3), translation({0, 3, 0}), {1, 1, 1}, Material::matte));
  const auto place = [](int k) { return Vec3{3 * std::cos(k * pi / 3), 0, 3 * std::sin(k * pi / 3)}; };
  const int strength[] = {3, 1, 5, 2, 6, 4};
  for (int k = 0; k < 6; ++k) f.lights.push_back(sun(place(k) - Vec3{0, 3, 0}, Casting::on, 0.05 * strength[k]));
  for (int turn = 0; turn < 2; ++turn) {
    double all = 0;
    for (const Light& l : f.lights) all += sent(l);
    const Picture p = draw(f);
    for (int k = 0; k < 6; ++k)
      EXPECT_NEAR(seen_from_above(p, 10, place(k).x, place(k).z),
                  all - (strength[k] > 2 ? 0.8 * 0.5 * 0.05 * strength[k] / std::sqrt(2) : 0), 0.004)
          << k << ' ' << turn;
    std::reverse(f.lights.begin(), f.lights.end());
  }
}

TEST(RenderShadow, ThingsNeedNotCastAny) {
  Frame f = two_suns(Casting::on, Casting::soft);
  f.items[1].casts = false;
  const Picture p = draw(f);
  for (const double z : {-0.6, 0.6, 1.8})
    EXPECT_NEAR(seen_from_above(p, 10, 3, z), seen_from_above(p, 10, -3, 0), 0.005);
}

// A plate over the half x < 0 of the floor, `high` metres above it.
Frame plate(double high, const Light& light) {
  Frame f = from_above(2);
  const Mat4 lying = rotation(axis_angle({1, 0, 0}, -pi / 2));
  f.items.push_back(
      item(square(), translation({-2, high, 0}) * lying * scaling({4, 4, 1}), {1, 1, 1}, Material::matte));
  f.lights = {light};
  return f;
}

// Returns the share of the light at each pixel of a row around x, 2 m wide.
std::vector<double> profile(Frame f, double x) {
  const RenderOptions options{200, 20, 4, "shaded"};
  f.camera.world = translation({x, 0, 0}) * f.camera.world, f.camera.height = 0.2;
  const Picture with = draw(f, options);
  f.lights[0].casting = Casting::off;
  const Picture without = draw(f, options);
  std::vector<double> r;
  for (int i = 0; i < 200; ++i) r.push_back(linear(pixel(with, i, 10)) / linear(pixel(without, i, 10)));
  return r;
}

// Returns the share of a disc of radius 1 on one side of a line at distance s from its centre.
double share(double s) {
  s = std::clamp(s, -1.0, 1.0);
  return 0.5 + (s * std::sqrt(1 - s * s) + std::asin(s)) / pi;
}

// `wanted` returns the expected share of the light at x.
void expect_profile(const std::vector<double>& is, double middle, const std::function<double(double)>& wanted) {
  double worst = 0, wide = 0, wide_wanted = 0;
  for (int i = 0; i < 200; ++i) {
    const double x = middle + (i + 0.5 - 100) / 100;
    if (x < 0.05) continue;  // there the plate is seen
    const double w = wanted(x), v = is[static_cast<std::size_t>(i)];
    worst = std::max(worst, std::abs(v - w));
    wide += v > 0.1 && v<0.9, wide_wanted += w> 0.1 && w < 0.9;
  }
  EXPECT_LT(worst, 0.12);  // by up to two texels it lies nearer: so far above a surface maps are looked up
  EXPECT_NEAR(wide, wide_wanted, std::max(2.0, 0.12 * wide_wanted));
}

TEST(RenderShadow, ASoftSunsPenumbraIsThatOfADisc) {
  for (const double high : {1.0, 2.0, 4.0}) {
    const Frame f = plate(high, sun({1, -1, 0}, Casting::soft));
    const double half = 3 * pi / 180;
    expect_profile(profile(f, high), high,
                   [&](double x) { return share(std::tan(std::atan(x / high) - pi / 4) / std::tan(half)); });
  }
}

// The lamp is a disc of a fortieth of its range, here 0.5 m, at 8 m above the floor.
TEST(RenderShadow, ASoftLampsPenumbraIsThatOfADisc) {
  for (const double high : {1.0, 3.0}) {
    Light light = lamp({-2, 8, 0}, 20);
    light.casting = Casting::soft;
    const double edge = 2 * high / (8 - high), half = 0.5 * high / (8 - high);
    expect_profile(profile(plate(high, light), edge), edge, [&](double x) { return share((x - edge) / half); });
  }
}

TEST(RenderShadow, SoftOnesAreCrispWhereThingsTouch) {
  // The edge of a box's shadow is sharp at the box and wider farther out.
  Frame f = from_above(4);
  f.items.push_back(item(square(), translation({0, 0.75, 0}) * scaling({0.5, 1.5, 1}), {1, 1, 1}, Material::matte));
  f.lights = {sun({0, -1, 1}, Casting::soft)};
  const Picture p = draw(f, {400, 400, 4, "shaded"});
  const auto between = [&](double z) {
    int n = 0;
    const double lit = seen_from_above(p, 4, -1.5, z);
    for (double x = 0; x < 0.8; x += 0.01) {
      const double v = seen_from_above(p, 4, x, z) / lit;
      n += v > 0.1 && v < 0.9;
    }
    return n;
  };
  EXPECT_LE(between(0.1), 5);
  EXPECT_GT(between(1.2), between(0.1) + 3);
}

// Computes visibility of the sun in another way: whether a ray to it meets any of these balls and axis-aligned boxes.
struct Solid {
  Vec3 center, half;
  bool ball;
};
bool in_shadow(Vec3 p, Vec3 to_sun, const std::vector<Solid>& solids, double grown) {
  return std::any_of(solids.begin(), solids.end(), [&](const Solid& s) {
    const Vec3 c = s.center - p;
    if (s.ball) {
      const double r = s.half.x + grown, along = dot(c, to_sun);
      return r > 0 && along > -r && dot(c, c) - along * along < r * r;
    }
    if (std::min({s.half.x, s.half.y, s.half.z}) + grown <= 0) return false;
    double from = 0, to = INFINITY;
    for (int i = 0; i < 3; ++i) {
      const double h = s.half[i] + grown, a = (c[i] - h) / to_sun[i], b = (c[i] + h) / to_sun[i];
      from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
    }
    return from < to;
  });
}
std::shared_ptr<const Shape> box(Vec3 size) {
  auto shape = std::make_shared<Shape>();
  shape->kind = Kind::box, shape->size = size;
  return shape;
}
Item item_of(const Solid& s) {
  return item(s.ball ? sphere(s.half.x) : box(2 * s.half), translation(s.center), {0.02, 0.02, 0.02}, Material::matte);
}

// A ground, objects on it, and a sun.
Frame standing(const std::vector<Solid>& solids, Vec3 to_sun, Vec3 eye, Vec3 target) {
  Frame f;
  f.camera.world = look_at(eye, target), f.camera.fov = 0.9;
  f.background = Vec3{}, f.surroundings.ambient = Vec3{}, f.surroundings.ground = Vec3{0.5, 0.5, 0.5};
  for (const Solid& s : solids) f.items.push_back(item_of(s));
  f.lights = {sun(-to_sun, Casting::on)};
  return f;
}

// Returns the point where a pixel's ray meets the ground, or nullopt if it is far, or if a solid is (nearly) in the
// way.
std::optional<Vec3> on_ground(const Frame& f, const RenderOptions& o, int x, int y, const std::vector<Solid>& solids) {
  const double scale = 2 * std::tan(f.camera.fov / 2) / o.width;
  const Vec3 way =
      transform_vector(f.camera.world, {(x + 0.5 - o.width / 2.0) * scale, (o.height / 2.0 - y - 0.5) * scale, -1});
  const Vec3 eye = translation_of(f.camera.world);
  if (way.y > -0.15) return {};
  const Vec3 spot = eye + -eye.y / way.y * way;
  const double pixel = scale * length(spot - eye);
  if (in_shadow(eye, normalize(way), solids, 2 * pixel)) return {};
  return spot;
}

// Counts the pixels that show the ground, and those with wrong light. Leaves out pixels within `slack` metres of the
// edge of a shadow.
struct Found {
  int dark = 0, lit = 0, wrong = 0;
};
Found compared(const Frame& f, const std::vector<Solid>& solids, Vec3 to_sun, double slack,
               const RenderOptions& options) {
  const Picture p = draw(f, options);
  const double all = sent(f.lights.front());
  Found r;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) {
      const auto spot = on_ground(f, options, x, y, solids);
      if (!spot) continue;
      const bool dark = in_shadow(*spot, to_sun, solids, -slack);
      if (!dark && in_shadow(*spot, to_sun, solids, slack)) continue;
      const bool is = linear(pixel(p, x, y)) < 0.5 * all;
      ++(dark ? r.dark : r.lit), r.wrong += is != dark;
    }
  return r;
}

// Every object casts a shadow if it has at least a thousandth of the size of the largest.
TEST(RenderShadow, AllCastHoweverSmallOthersAre) {
  const RenderOptions options{320, 180, 4, "shaded"};
  std::mt19937 random(7);
  const auto any = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
  for (const double unit : {0.01, 1.0, 1000.0})
    for (int turn = 0; turn < 6; ++turn) {
      std::vector<Solid> solids;
      for (const Vec3 c : {Vec3{0, 1, 0}, {2.5, 0.7, -1}, {-2, 0.5, 1}})
        solids.push_back({unit * c, unit * c.y * Vec3{1, 1, 1}, turn % 2 == 0 || c.x == 0});
      for (int k = 0; k < 1 + turn % 3; ++k) {
        const double r = std::pow(10.0, any(-3, -0.7));
        solids.push_back(
            {unit * Vec3{any(-3, 3), r + any(0, 3), any(-2, 2)}, unit * r * Vec3{1, 1, 1}, any(0, 1) < 0.5});
      }
      const Vec3 to_sun = normalize(Vec3{any(-1, 1), any(0.8, 2), any(-1, 0.5)});
      const Frame f = standing(solids, to_sun, unit * Vec3{1, 4, 8}, unit * Vec3{0, 0.5, 0});
      const Found found = compared(f, solids, to_sun, 0.07 * unit, options);
      EXPECT_GT(found.dark, 300) << unit << ' ' << turn;
      EXPECT_LE(found.wrong, 5) << unit << ' ' << turn << " of " << found.dark << " and " << found.lit;
    }
}

// A street of houses up to a kilometre away, with a figure and the head of a nail near the camera.
TEST(RenderShadow, WhatIsNearAndWhatIsFarCastTogether) {
  const RenderOptions options{640, 360, 4, "shaded"};
  std::vector<Solid> solids = {{{0.5, 0.9, 0}, {0.25, 0.9, 0.2}, false}, {{-0.7, 0.02, 1}, {0.02, 0.02, 0.02}, true}};
  for (const double z : {-15, -40, -100, -250, -500, -1000})
    solids.push_back({{14, 4, z}, {4, 4, 4}, false}), solids.push_back({{-14, 4, z}, {4, 4, 4}, false});
  const Vec3 to_sun = normalize(Vec3{-1, 1, 0.2});
  const Frame f = standing(solids, to_sun, {0, 3, 5}, {0, 0, -6});
  const std::vector<Solid> near(solids.begin(), solids.begin() + 2);
  const Found found = compared(f, solids, to_sun, 0.3, options),
              fine = compared(f, near, to_sun, 0.03, {640, 360, 4, "shaded"});
  EXPECT_GT(found.dark, 3000);
  EXPECT_LE(found.wrong, 20);
  EXPECT_GT(fine.dark, 500);
  Frame alone = f;
  alone.items.resize(2);
  EXPECT_LE(compared(alone, near, to_sun, 0.02, options).wrong, 5);
}

// Shadows of resting objects stay the same while a small object moves, near the camera and far from it.
TEST(RenderShadow, WhatIsSmallAndMovesDoesNotStirOthers) {
  const RenderOptions options{320, 180, 4, "shaded"};
  const std::vector<Solid> solids = {{{0, 1, 0}, {1, 1, 1}, true}, {{2.5, 0.5, -1}, {0.5, 0.5, 0.5}, false}};
  const Vec3 to_sun = normalize(Vec3{-0.6, 1, 0.3});
  const Frame plain = standing(solids, to_sun, {1, 3, 7}, {0.7, 0.5, 0});
  const Picture before = draw(plain, options);
  const auto keeping = renderer(options);
  for (int k = 0; k < 12; ++k) {
    std::vector<Solid> with = solids;
    with.push_back({Vec3{1, 3, 7} + 0.4 * (k + 1) * Vec3{-0.15, -0.27 + 0.03 * k, -0.95}, {0.01, 0.01, 0.01}, true});
    Frame f = standing(with, to_sun, {1, 3, 7}, {0.7, 0.5, 0});
    Picture p;
    ASSERT_TRUE(keeping->render(f, p));
    int others = 0;
    for (int y = 0; y < p.height; ++y)
      for (int x = 0; x < p.width; ++x) {
        const auto spot = on_ground(f, options, x, y, with);
        if (!spot || in_shadow(*spot, to_sun, {with.back()}, 0.05)) continue;
        others += std::abs(pixel(p, x, y).g - pixel(before, x, y).g) > 90;
      }
    EXPECT_LE(others, 10) << k;  // of thousands, where edges are
  }
}

// The shaded side of a box and its shadow are dark, without a line of light between them.
TEST(RenderShadow, NoLightLeaksInBetweenABoxAndItsShadow) {
  for (const Vec3 to_sun : {Vec3{-0.6, 1, -0.8}, {0.2, 2, -1}, {0.5, 0.5, -0.5}})
    for (const double size : {0.1, 1.0, 30.0}) {
      Frame f = standing({{size * Vec3{0, 0.5, 0}, size * Vec3{0.5, 0.5, 0.5}, false}}, normalize(to_sun),
                         size * Vec3{0.3, 1.5, 5}, size * Vec3{0, 0.4, 0});
      f.items.push_back(item(sphere(0.01 * size), translation(size * Vec3{-3, 2, -3}), {0.5, 0.5, 0.5}));
      const Picture p = draw(f, {1280, 720, 4, "shaded"});
      const Mat4 to_eye = *inverse(f.camera.world);
      int light = 0;
      for (double x = -0.4; x < 0.4; x += 0.005) {
        const Vec3 e = transform_point(to_eye, size * Vec3{x, 0, 0.5});
        const double scale = 640 / std::tan(f.camera.fov / 2) / -e.z;
        const int px = static_cast<int>(640 + scale * e.x), py = static_cast<int>(360 - scale * e.y);
        for (int y = py - 4; y <= py + 4; ++y) light += pixel(p, px, y).g > 30;
      }
      EXPECT_EQ(light, 0) << size << ' ' << to_sun.y;
    }
}

// A lamp in the middle of a ring of balls: each ball has a shadow behind it, in every direction.
TEST(RenderShadow, ALampAmidThingsCastsAllAround) {
  for (const Casting casting : {Casting::on, Casting::soft})
    for (const double unit : {0.01, 1.0, 1000.0}) {
      Frame f = from_above(16 * unit);
      f.camera.world = translation({0, 20 * unit, 0}) * rotation(axis_angle({1, 0, 0}, -pi / 2));
      f.items[0].world = rotation(axis_angle({1, 0, 0}, -pi / 2)) * scaling({60 * unit, 60 * unit, 1});
      const int count = 9;
      const auto at = [&](double k, double away) {
        return Vec3{away * std::cos(2 * pi * k / count), 0, away * std::sin(2 * pi * k / count)};
      };
      for (int k = 0; k < count; ++k)
        f.items.push_back(
            item(sphere(0.4 * unit), translation(unit * (at(k, 3) + Vec3{0, 0.4, 0})), {1, 1, 1}, Material::matte));
      f.items.push_back(item(sphere(0.01 * unit), translation(unit * Vec3{1, 0.5, 1}), {1, 1, 1}, Material::matte));
      f.lights = {lamp({0, 1.2 * unit, 0}, 12 * unit)};
      f.lights[0].casting = casting;
      const Picture p = draw(f, {400, 400, 4, "shaded"});
      for (int k = 0; k < count; ++k) {
        const Vec3 behind = unit * at(k, 3.7), between = unit * at(k + 0.5, 3.7);
        EXPECT_LT(seen_from_above(p, 16 * unit, behind.x, behind.z),
                  0.2 * seen_from_above(p, 16 * unit, between.x, between.z))
            << k << ' ' << unit;
      }
    }
}

// A picture has the same bits, whatever was drawn before.
TEST(RenderShadow, WhatLightsCastIsComparedToo) {
  const RenderOptions options{100, 100, 4, "shaded"};
  const auto keeping = renderer(options);
  for (const auto& [first, second] : {std::pair{Casting::on, Casting::on},
                                      {Casting::on, Casting::off},
                                      {Casting::soft, Casting::on},
                                      {Casting::soft, Casting::soft},
                                      {Casting::off, Casting::soft},
                                      {Casting::strongest, Casting::strongest}}) {
    Picture p;
    ASSERT_TRUE(keeping->render(two_suns(first, second), p));
    EXPECT_EQ(p.rgba, draw(two_suns(first, second), options).rgba);
  }
}

}  // namespace
}  // namespace betwixt

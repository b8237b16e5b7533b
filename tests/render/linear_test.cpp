// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests pictures of linear light with closed forms: as seen on a screen they equal the usual pictures, transparency is
// the uncovered part, and light keeps its brightness.
#include <limits>

#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

RenderOptions linear_options(int samples = 4, const std::string& style = "shaded") {
  RenderOptions o{100, 100, samples, style};
  o.linear = true;
  return o;
}
RenderOptions unclamped_options() {
  RenderOptions o = linear_options();
  o.unclamped = true;
  return o;
}

LinearPicture light_of(const Frame& f, const RenderOptions& options = linear_options()) {
  LinearPicture p;
  const Status s = renderer(options)->render(f, p);
  EXPECT_TRUE(s) << (s ? "" : s.error().message);
  return p;
}

using Four = std::array<float, 4>;
Four at(const LinearPicture& p, int x, int y) {
  const float* const c = &p.rgba.at(4 * (static_cast<std::size_t>(y) * 100 + static_cast<std::size_t>(x)));
  return {c[0], c[1], c[2], c[3]};
}
// Within what half floats and the programs' own arithmetic can differ by.
void expect_near(const Four& is, const std::array<double, 4>& wanted, double within = 2e-3) {
  for (std::size_t c = 0; c < 4; ++c)
    EXPECT_NEAR(is[c], wanted[c], within * std::max(1.0, wanted[c])) << "channel " << c;
}

Frame clear_frame() {
  Frame f = frame();
  f.background.reset();
  f.surroundings.clear = true;
  return f;
}

// Lit and glowing things, glass, metal, a floor and what is around them.
Frame busy() {
  Frame f;
  f.camera.world = look_at({0, 4, 14}, {0, 1, 0});
  f.lights = {lamp({5, 9, 5}, 40), lamp({-5, 4, 5}, 20)};
  for (int i = 0; i < 12; ++i) {
    const Material materials[] = {Material::plastic, Material::matte, Material::metal, Material::glow};
    f.items.push_back(item(i % 3 ? sphere(0.8) : square(), translation({i - 6.0, 1.0 + i % 3, -1.0 * (i % 4)}),
                           {0.1 * (i % 10), 0.5, 0.7}, materials[i % 4]));
    f.items.back().shininess = 0.5, f.items.back().transparency = i % 5 == 0 ? 0.5 : 0;
  }
  return f;
}
std::vector<Frame> scenes_of_all_kinds() {
  Frame plain = busy(), colored = busy(), ground = busy(), sky = busy(), fog = busy(), contact = busy(), flat = busy();
  colored.background = Vec3{0.2, 0.4, 0.1}, colored.surroundings.below = Vec3{0.01, 0.02, 0.5};
  ground.surroundings.ground = Vec3{0.5, 0.4, 0.3};
  sky.surroundings.ground = Vec3{0.5, 0.4, 0.3}, sky.surroundings.sky = true;
  fog.surroundings.fog = {{0.5, 0.6, 0.7}, 12, 18};
  contact.surroundings.ground = Vec3{0.5, 0.4, 0.3}, contact.surroundings.contact = true;
  flat.surroundings.flat = true;
  return {plain, colored, ground, sky, fog, contact, flat};
}

// Within a byte but for a few: what is blended more than once is rounded as often in bytes, and what is brighter than
// white through glass is cut there sample by sample.
testing::AssertionResult alike(const Picture& a, const Picture& b) {
  if (a.rgba.size() != b.rgba.size()) return testing::AssertionFailure() << "of other sizes";
  int farther = 0, most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const int apart = std::abs(a.rgba[i] - b.rgba[i]);
    farther += apart > 1, most = std::max(most, apart);
  }
  // Bytes may put a pixel of an edge on the other side of a limit where edges become smooth.
  if (most <= 16 && farther <= 50) return testing::AssertionSuccess();
  return testing::AssertionFailure() << farther << " channels of 40000 are apart, one by " << most;
}

TEST(RenderLinear, WhatIsShownOfLightIsWhatOthersShow) {
  for (const Style& style : styles())
    for (const int samples : {1, 4, 9, 16}) {
      const auto shallow = renderer({100, 100, samples, std::string(style.name)});
      const auto light = renderer(linear_options(samples, std::string(style.name)));
      int number = 0;
      auto scenes = scenes_of_all_kinds();
      if (style.name != "shaded") scenes.resize(2);  // of the others lines show nothing
      for (const Frame& f : scenes) {
        Picture bytes, same, shown;
        LinearPicture drawn;
        ASSERT_TRUE(shallow->render(f, bytes) && light->render(f, drawn) && light->render(f, same));
        to_shown(drawn, shown);
        EXPECT_TRUE(alike(shown, bytes)) << style.name << ", " << samples << " samples, scene " << number;
        EXPECT_EQ(same.rgba, shown.rgba) << "bytes of a renderer of linear light are what is shown of its light";
        for (std::size_t i = 3; i < drawn.rgba.size(); i += 4) ASSERT_EQ(drawn.rgba[i], 1) << style.name << number;
        ++number;
      }
    }
}

TEST(RenderLinear, OthersHaveNoLightAndNothingClear) {
  const auto shallow = renderer({100, 100, 4, "shaded"});
  LinearPicture light;
  const Status s = shallow->render(frame(), light);
  ASSERT_FALSE(s);
  EXPECT_EQ(s.error().code, ErrorCode::range);
  for (Frame f : scenes_of_all_kinds()) {  // it is black, to the horizon
    f.surroundings.clear = true;
    Picture p;
    ASSERT_TRUE(shallow->render(f, p));
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) ASSERT_EQ(p.rgba[i], 255);
    EXPECT_EQ(pixel(p, 0, 0), (Pixel{0, 0, 0, 255}));
  }
}

// A square of 1.37 by 1.41 m over nothing, 10 pixels a metre: pixels have the share of it that they are covered by.
TEST(RenderLinear, WhatNothingCoversIsClear) {
  Frame f = clear_frame();
  f.items.push_back(item(square(), translation({0.3, 0.2, 0}) * scaling({4, 4, 1}), {0.5, 0.25, 1}));
  for (const std::string style : {"shaded", "wireframe", "hidden-line"}) {
    const LinearPicture p = light_of(f, linear_options(4, style));
    for (const auto& [x, y] : {std::pair{0, 0}, {99, 99}, {20, 50}, {50, 20}})
      EXPECT_EQ(at(p, x, y), (Four{0, 0, 0, 0})) << style;
  }
  const LinearPicture p = light_of(f);
  expect_near(at(p, 50, 50), {0.5, 0.25, 1, 1});
  f.background = Vec3{1, 0, 0}, f.surroundings.below = Vec3{0, 1, 0}, f.surroundings.sky = true;
  EXPECT_EQ(light_of(f).rgba, p.rgba) << "nothing of what else would be behind it";
}

// The border runs through the middle of a column of pixels: half of their samples, however many, are covered.
TEST(RenderLinear, BordersAreAsClearAsTheyAreUncovered) {
  Frame f = clear_frame();
  f.items.push_back(item(square(), translation({-2.45, 0, 0}) * scaling({5, 20, 1}), {0.8, 0.4, 0.2}));
  for (const int samples : {4, 16}) {
    const LinearPicture p = light_of(f, linear_options(samples));
    for (const int y : {0, 33, 99}) {
      expect_near(at(p, 49, y), {0.8, 0.4, 0.2, 1});
      expect_near(at(p, 50, y), {0.4, 0.2, 0.1, 0.5});
      expect_near(at(p, 51, y), {0, 0, 0, 0});
    }
    Picture shown;
    to_shown(p, shown);  // the colour is that of the whole, and the opacity its half
    EXPECT_EQ(pixel(shown, 50, 50), (Pixel{encoded_byte(0.8), encoded_byte(0.4), encoded_byte(0.2), 128}));
  }
}

// What is laid over a colour afterwards is what is drawn over it: (1 - alpha) of what is behind, plus its own.
TEST(RenderLinear, LaidOverAColorItIsAsIfDrawnOverIt) {
  const Vec3 behind{0.9, 0.1, 0.6};
  auto all = scenes_of_all_kinds();
  std::erase_if(all, [](const Frame& f) { return f.surroundings.ground.has_value(); });  // and what comes with it
  for (std::size_t k = 0; k < all.size(); ++k)
    for (const std::string style : {"shaded", "wireframe"}) {
      Frame f = all[k];
      f.surroundings.ground.reset(), f.surroundings.below.reset(), f.background = behind;
      // Nine samples: edges that are smooth by those of the pixels around depend on what is behind.
      const LinearPicture drawn = light_of(f, linear_options(9, style));
      f.surroundings.clear = true;
      const LinearPicture over = light_of(f, linear_options(9, style));
      for (std::size_t i = 0; i < drawn.rgba.size(); ++i)
        ASSERT_NEAR(over.rgba[i] + (1 - over.rgba[i / 4 * 4 + 3]) * (i % 4 < 3 ? behind[static_cast<int>(i % 4)] : 1),
                    drawn.rgba[i], 4e-3)
            << style << " " << k << " at " << i / 4 % 100 << ' ' << i / 400;
    }
}

TEST(RenderLinear, GlassOverNothing) {
  Frame f = clear_frame();
  f.lights = {lamp({0, 0, 50}, 1)};  // reaches nothing
  f.surroundings.ambient = Vec3{0.5, 0.5, 0.5};
  f.items.push_back(item(square(), scaling({50, 50, 1}), {0.8, 0.4, 0.2}, Material::matte));
  f.items[0].transparency = 0.75;
  expect_near(at(light_of(f), 50, 50), {0.1, 0.05, 0.025, 0.25});
  // Two over each other let through the product of what each does.
  f.items.push_back(item(square(), translation({0, 0, 1}) * scaling({50, 50, 1}), {0, 0, 1}, Material::matte));
  f.items[1].transparency = 0.5;
  expect_near(at(light_of(f), 50, 50), {0.05, 0.025, 0.0125 + 0.25, 1 - 0.75 * 0.5});
  // Before something solid nothing is seen through.
  f.items.push_back(item(square(), translation({0, 0, -1}) * scaling({50, 50, 1}), {1, 1, 1}));
  EXPECT_EQ(at(light_of(f), 50, 50)[3], 1);
}

// Plastic mirrors 0.045 of what comes straight at it where it is shiny, and so much less is seen through it.
TEST(RenderLinear, ShinyGlassIsLessClear) {
  Frame f = clear_frame();
  f.lights = {lamp({0, 0, 50}, 1)};
  f.camera.orthographic = true;
  f.items.push_back(item(square(), scaling({50, 50, 1}), {0.8, 0.4, 0.2}, Material::plastic));
  f.items[0].transparency = 0.9, f.items[0].shininess = 1;
  EXPECT_NEAR(at(light_of(f), 50, 50)[3], 0.1 + 0.9 * 0.045, 1e-3);
  f.items[0].shape = sphere(0.5);  // two walls, each so clear
  f.items[0].material = Material::matte;
  EXPECT_NEAR(at(light_of(f), 50, 50)[3], 1 - 0.9 * 0.9, 1e-3);
}

// The floor fades where one looks along it, by the square of how steep that is, and what it fades into is nothing.
TEST(RenderLinear, TheFloorGoesOverIntoNothing) {
  for (const bool contact : {false, true}) {
    Frame f;
    f.camera.world = look_at({0, 1, 0}, {0, 1, -1});
    f.camera.fov = pi / 2;
    f.surroundings.clear = true, f.surroundings.ground = Vec3{0.5, 0.5, 0.5}, f.surroundings.contact = contact;
    f.surroundings.ambient = Vec3{1, 1, 1}, f.lights = {lamp({0, 0, 50}, 1)};
    const LinearPicture p = light_of(f);
    for (int y = 0; y < 50; ++y) EXPECT_EQ(at(p, 50, y), (Four{0, 0, 0, 0})) << y;
    for (int y = 50; y < 100; ++y) {
      const double v = (y - 49.5) / 50, u = 0.01, steep = v / std::sqrt(1 + v * v + u * u);
      const double cover = steep * steep / (steep * steep + 1e-3);
      expect_near(at(p, 50, y), {0.5 * cover, 0.5 * cover, 0.5 * cover, cover});
    }
    f.surroundings.flat = false, f.surroundings.sky = true;
    EXPECT_EQ(at(light_of(f), 50, 10), (Four{0, 0, 0, 0})) << "there is no sky either";
  }
}

TEST(RenderLinear, ContactLeavesOpacityAlone) {
  Frame f = busy();
  f.items.push_back(item(sphere(1.5), translation({0, 1.4, 4}), {1, 1, 1}, Material::matte));
  f.surroundings.clear = true, f.surroundings.ambient = Vec3{0.8, 0.8, 0.8};
  for (const bool ground : {false, true}) {
    if (ground) f.surroundings.ground = Vec3{0.5, 0.4, 0.3};
    for (const int samples : {1, 4, 9}) {
      f.surroundings.contact = false;
      const LinearPicture without = light_of(f, linear_options(samples));
      f.surroundings.contact = true;
      const LinearPicture with = light_of(f, linear_options(samples));
      double darker = 0;
      for (std::size_t i = 0; i < with.rgba.size(); ++i) {
        if (i % 4 == 3)
          ASSERT_NEAR(with.rgba[i], without.rgba[i], samples == 4 ? 5e-3 : 1e-3)
              << samples << " at " << i / 4 % 100 << ' ' << i / 400;
        else
          darker = std::max(darker, static_cast<double>(without.rgba[i] - with.rgba[i]));
      }
      EXPECT_TRUE(!ground || darker > 0.05) << "there is none";
    }
  }
}

TEST(RenderLinear, FogLiesOverThingsNotOverNothing) {
  Frame f = clear_frame();  // 10 m away
  f.items.push_back(item(square(), scaling({4, 4, 1}), {1, 0, 0}));
  f.surroundings.fog = {{0, 0, 1}, 4, 12};
  const LinearPicture p = light_of(f);
  expect_near(at(p, 50, 50), {0.25, 0, 0.75, 1});
  EXPECT_EQ(at(p, 5, 5), (Four{0, 0, 0, 0}));
  f.items[0].transparency = 0.5;
  expect_near(at(light_of(f), 50, 50), {0.125, 0, 0.375, 0.5});
}

// Lambert's law by the law of light of lamps, (1 - (d/range)²)² of the intensity, of which 0.8 makes what is white just
// white: 5 at half the range, straight from above.
TEST(RenderLinear, LightStaysAsBrightAsItIs) {
  Frame f = frame();
  f.lights = {lamp({0, 0, 4}, 8)};
  f.lights[0].color = {5, 5, 2.5};
  f.surroundings.ambient = Vec3{0.2, 0, 0};
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 1, 1}, Material::matte));
  const auto lambert = [](double x, double y) {
    const double d2 = x * x + y * y + 16, window = 1 - d2 / 64;
    return 0.8 * 5 * 4 / std::sqrt(d2) * window * window;
  };
  const LinearPicture p = light_of(f, unclamped_options());
  for (const auto& [x, y] : {std::pair{50, 50}, {30, 50}, {70, 80}, {10, 10}}) {
    const double light = lambert((x - 49.5) / 10, (y - 49.5) / 10);
    expect_near(at(p, x, y), {light + 0.2, light, light / 2, 1});
  }
  EXPECT_GT(at(p, 50, 50)[0], 2);
  // What is shown rolls off: never above white, and darker than what is cut.
  for (const float shown : light_of(f).rgba) EXPECT_LE(shown, 1);
  EXPECT_GT(at(light_of(f), 50, 50)[0], 0.9F);
  EXPECT_LT(at(light_of(f), 50, 50)[0], 1);
}

TEST(RenderLinear, WhatIsNoNumberIsBlack) {
  Frame f = clear_frame();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(), most = std::numeric_limits<double>::max();
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 1, 1}, Material::plastic));
  f.items[0].shininess = 1;
  f.lights = {lamp({0, 0, 4}, 8)};
  for (const double bad : {nan, most, 1e30, 1e6}) {
    f.lights[0].color = {bad, 1, 1};
    Picture shown;
    to_shown(light_of(f, unclamped_options()), shown);
    EXPECT_EQ(pixel(shown, 50, 50).a, 255) << bad;
  }
}

}  // namespace
}  // namespace betwixt

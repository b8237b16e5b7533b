// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests layers and changes of the camera with numbers that are worked out by hand, in linear light.
#include "render/composer.h"

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

const RenderOptions small{100, 100, 4, "shaded"};

// A drawing, 10 m high: ten pixels a metre.
Frame drawing(Vec3 background) {
  Frame f = frame();
  f.surroundings.flat = true;
  f.background = background;
  return f;
}
Item card(double size, Vec3 at, Vec3 color, std::int32_t layer, std::uint32_t number) {
  Item i = item(square(), translation(at) * scaling({size, size, 1}), color);
  i.layer = layer, i.id = {number};
  return i;
}
double light(const Picture& p, int x, int y, int channel = 0) {
  const Pixel c = pixel(p, x, y);
  return decoded((channel == 0 ? c.r : channel == 1 ? c.g : c.b) / 255.0);
}
constexpr double byte = 0.008;  // of light: a byte where the curve is flattest

TEST(Composer, AGroupFadesAsAWhole) {
  Frame f = drawing({0, 0, 0});
  f.items = {card(4, {0, 0, 0}, {1, 0, 0}, 0, 1), card(4, {2, 0, 0.1}, {0, 1, 0}, 0, 2)};
  f.layers.resize(1), f.layers[0].opacity = 0.5;
  const Picture p = draw(f, small);
  EXPECT_NEAR(light(p, 40, 50, 0), 0.5, byte);
  EXPECT_NEAR(light(p, 65, 50, 1), 0.5, byte);  // where both are
  EXPECT_NEAR(light(p, 65, 50, 0), 0, byte);    // the red one does not show through
  EXPECT_EQ(pixel(p, 95, 50).a, 255);
  f.layers[0].opacity = 0;
  EXPECT_NEAR(light(draw(f, small), 40, 50, 0), 0, 1e-9);
}

TEST(Composer, BlendsAreThoseOfLight) {
  const std::pair<LayerBlend, double> wanted[] = {{LayerBlend::normal, 0.3},
                                                  {LayerBlend::screen, 0.58},
                                                  {LayerBlend::multiply, 0.12},
                                                  {LayerBlend::add, 0.7},
                                                  {LayerBlend::overlay, 0.24}};
  for (const auto& [blend, result] : wanted) {
    Frame f = drawing({0.4, 0.4, 0.4});
    f.items = {card(4, {0, 0, 0}, {0.3, 0.3, 0.3}, 0, 1)};
    f.layers.resize(1), f.layers[0].blend = blend;
    const Picture p = draw(f, small);
    EXPECT_NEAR(light(p, 50, 50), result, byte) << static_cast<int>(blend);
    EXPECT_NEAR(light(p, 5, 5), 0.4, byte);
    f.layers[0].opacity = 0.5;
    EXPECT_NEAR(light(draw(f, small), 50, 50), (result + 0.4) / 2, byte);
  }
}

TEST(Composer, MasksShowWhereTheyAre) {
  Frame f = drawing({0, 0, 0.5});
  f.items = {card(8, {0, 0, 0}, {1, 1, 0}, 0, 1), card(4, {-2, 0, 0}, {0, 0, 0}, 1, 2)};
  f.layers.resize(2), f.layers[0].masks = {1}, f.layers[1].is_mask = true;
  Picture p = draw(f, small);
  EXPECT_EQ(pixel(p, 30, 50), (Pixel{255, 255, 0, 255}));
  EXPECT_NEAR(light(p, 70, 50, 2), 0.5, byte);
  EXPECT_EQ(pixel(p, 70, 50).r, 0);
  f.layers[1].opacity = 0.25;
  p = draw(f, small);
  EXPECT_NEAR(light(p, 30, 50, 0), 0.25, byte);
}

TEST(Composer, MasksThatMaskEachOtherEnd) {
  Frame f = drawing({0, 0, 0.5});
  f.items = {card(8, {0, 0, 0}, {1, 1, 0}, 0, 1), card(4, {-2, 0, 0}, {0, 1, 0}, 1, 2),
             card(4, {2, 0, 0}, {0, 1, 0}, 2, 3)};
  f.layers.resize(3);
  f.layers[0].masks = {1}, f.layers[1].masks = {2}, f.layers[2].masks = {1};
  f.layers[1].is_mask = f.layers[2].is_mask = true;
  const Picture p = draw(f, small);
  EXPECT_NEAR(light(p, 20, 50, 2), 0.5, byte);  // the two masks do not meet: nothing is left
}

TEST(Composer, ThingsInFrontHideALayer) {
  Frame f = drawing({0, 0, 0});
  f.items = {card(4, {0, 0, 1}, {0, 0, 1}, -1, 1), card(8, {0, 0, 0}, {1, 0, 0}, 0, 2),
             card(10, {0, 0, -1}, {0, 1, 0}, -1, 3)};
  f.layers.resize(1), f.layers[0].opacity = 0.5;
  const Picture p = draw(f, small);
  EXPECT_EQ(pixel(p, 50, 50), (Pixel{0, 0, 255, 255}));
  EXPECT_NEAR(light(p, 15, 50, 0), 0.5, byte);
  EXPECT_NEAR(light(p, 15, 50, 1), 0.5, byte);
}

// Effects spread over neighbours. What is in front of the layer is not changed by them, and leaves no hole in them.
TEST(Composer, ThingsInFrontStayAsTheyAre) {
  for (const bool flat : {true, false})
    for (const int effect : {0, 1, 2}) {
      Frame f = drawing({0, 0, 0.5});
      f.surroundings.flat = flat;
      f.items = {card(4, {0, 0, 0}, {0, 1, 0}, 0, 1), card(1, {0, 0, 1}, {1, 0, 0}, -1, 2)};
      f.layers.resize(1);
      Frame without = f;
      without.items.pop_back();
      for (Frame* const each : {&f, &without}) {
        Layer& l = each->layers[0];
        if (effect == 0) l.blur = 0.5;
        if (effect == 1) l.glow = 2, l.glow_size = 0.5;
        if (effect == 2) l.shadow = {0.5, -0.5, 0.3};
      }
      const Picture p = draw(f, small), bare = draw(without, small);
      EXPECT_EQ(pixel(p, 50, 50), (Pixel{255, 0, 0, 255})) << flat << effect;
      for (const int x : {30, 40, 57, 70}) EXPECT_EQ(pixel(p, x, 50), pixel(bare, x, 50)) << flat << effect << ' ' << x;
      // A drawing has those in front, too, that have the same depth and were made later.
      f.items[1].world = translation({0, 0, 0});
      if (flat) {
        EXPECT_EQ(pixel(draw(f, small), 50, 50), (Pixel{255, 0, 0, 255})) << effect;
      }
    }
}

TEST(Composer, LayersWithinLayersMultiply) {
  Frame f = drawing({0, 0, 0});
  f.items = {card(4, {0, 0, 0}, {1, 0, 0}, 0, 1), card(2, {0, 0, 0.1}, {0, 1, 0}, 1, 2)};
  f.layers.resize(2), f.layers[1].within = 0;
  f.layers[0].opacity = 0.5, f.layers[1].opacity = 0.5;
  const Picture p = draw(f, small);
  EXPECT_NEAR(light(p, 50, 50, 1), 0.25, byte);
  EXPECT_NEAR(light(p, 50, 50, 0), 0.25, byte);
  EXPECT_NEAR(light(p, 35, 50, 0), 0.5, byte);
}

TEST(Composer, BlurGlowAndShadowHaveTheirPlaces) {
  Frame f = drawing({0.5, 0.5, 0.5});
  f.items = {card(2, {0, 0, 0}, {0, 0, 0}, 0, 1)};
  f.layers.resize(1), f.layers[0].blur = 0.5;
  EXPECT_GT(light(draw(f, small), 61, 50), 0.2);  // a pixel outside the edge, which is half dark
  EXPECT_LT(light(draw(f, small), 61, 50), 0.4);
  f.layers[0].blur = 0, f.layers[0].shadow = {3, -3, 0}, f.layers[0].shadow_opacity = 0.5;
  Picture p = draw(f, small);
  EXPECT_NEAR(light(p, 80, 80), 0.25, byte);
  EXPECT_NEAR(light(p, 20, 20), 0.5, byte);
  f.items[0].color = {0.5, 0, 0}, f.layers[0].shadow = {}, f.layers[0].glow = 1, f.layers[0].glow_size = 0.3;
  p = draw(f, small);
  EXPECT_GT(light(p, 61, 50, 0), 0.6);
  EXPECT_NEAR(light(p, 61, 50, 1), 0.5, byte);
}

TEST(Composer, SolidGroupsFadeWithTheirShadows) {
  Frame f;
  f.camera.world = look_at({0, 4, 14}, {0, 1, 0});
  f.surroundings.ground = Vec3{0.6, 0.6, 0.6};
  f.items = {item(sphere(), translation({0, 1, 0}), {0.8, 0.2, 0.1}, Material::plastic)};
  RenderOptions o{160, 90, 4, "shaded"};
  const Picture with = draw(f, o);
  f.items[0].layer = 0;
  f.layers.resize(1), f.layers[0].opacity = 0.9999;
  const Picture nearly = draw(f, o);
  int worst = 0;
  for (std::size_t i = 0; i < with.rgba.size(); ++i) worst = std::max(worst, std::abs(with.rgba[i] - nearly.rgba[i]));
  EXPECT_LE(worst, 3);
  f.layers[0].opacity = 0;
  const Picture gone = draw(f, o);
  f.items.clear(), f.layers.clear();
  const Pixel left = pixel(gone, 80, 45), wanted = pixel(draw(f, o), 80, 45);
  EXPECT_NEAR(left.r, wanted.r, 1);
  EXPECT_NEAR(left.g, wanted.g, 1);
}

TEST(Composer, CamerasDissolveAndWipeInLight) {
  Frame f = drawing({0, 0, 0});
  f.items = {card(200, {0, 0, 0}, {1, 0, 0}, -1, 1), card(200, {500, 0, 0}, {0, 1, 0}, -1, 2)};
  CameraChange change{f.camera, 0.25, ChangeKind::dissolve};
  f.camera.world = translation({500, 0, 10});
  f.change = change;
  Picture p = draw(f, small);
  EXPECT_NEAR(light(p, 50, 50, 0), 0.75, byte);
  EXPECT_NEAR(light(p, 50, 50, 1), 0.25, byte);
  const std::tuple<ChangeKind, int, int, int, int> wipes[] = {{ChangeKind::left, 95, 50, 50, 50},
                                                              {ChangeKind::right, 5, 50, 50, 50},
                                                              {ChangeKind::up, 50, 95, 50, 50},
                                                              {ChangeKind::down, 50, 5, 50, 50},
                                                              {ChangeKind::iris, 50, 50, 5, 50}};
  for (const auto& [kind, new_x, new_y, old_x, old_y] : wipes) {
    f.change->kind = kind;
    p = draw(f, small);
    EXPECT_EQ(pixel(p, new_x, new_y), (Pixel{0, 255, 0, 255})) << static_cast<int>(kind);
    EXPECT_EQ(pixel(p, old_x, old_y), (Pixel{255, 0, 0, 255})) << static_cast<int>(kind);
  }
}

TEST(Composer, ScriptsMakeLayersAndChanges) {
  const Loaded loaded = load_text(R"(
film flat
create a camera height=9 position=(0 0 100)
create b camera height=9 position=(40 0 100)
create all group
create inner group opacity=0.5
hang inner on all
create dot circle
hang dot on inner
create hole circle radius=3
set all.mask hole
at 24f look through b for 12f wipe=iris
)",
                                  "test.bx");
  ASSERT_TRUE(loaded.diagnostics.empty()) << to_string(loaded.diagnostics[0]);
  const Program program = Program::compile(loaded.document);
  const Rate rate = loaded.document.rate();
  Frame f = program.frame(rate.frame(30));
  ASSERT_EQ(f.layers.size(), 3U);
  ASSERT_TRUE(f.change);
  EXPECT_NEAR(f.change->share, 0.5, 1e-9);
  EXPECT_EQ(f.change->kind, ChangeKind::iris);
  EXPECT_EQ(translation_of(f.change->from.world).x, 0);
  EXPECT_EQ(translation_of(f.camera.world).x, 40);
  for (const Item& i : f.items) {
    const Layer& l = f.layers[static_cast<std::size_t>(i.layer)];
    if (loaded.document.name(i.id) == "hole") {
      EXPECT_TRUE(l.is_mask);
    } else {
      EXPECT_EQ(loaded.document.name(l.object), "inner");
      EXPECT_EQ(loaded.document.name(f.layers[static_cast<std::size_t>(l.within)].object), "all");
    }
  }
  EXPECT_FALSE(program.frame(rate.frame(36)).change);
  EXPECT_FALSE(program.frame(rate.frame(23)).change);
}

}  // namespace
}  // namespace betwixt

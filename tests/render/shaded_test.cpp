// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <thread>

#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

Frame busy() {
  Frame f;
  f.camera.world = translation({0, 3, 14}) * rotation(axis_angle({1, 0, 0}, -0.2));
  f.items.push_back(item(square(), rotation(axis_angle({1, 0, 0}, -pi / 2)) * scaling({20, 20, 1}), {0.6, 0.6, 0.6},
                         Material::plastic));
  for (int i = 0; i < 12; ++i) {
    f.items.push_back(item(sphere(0.7), translation({i - 6.0, 1.0 + i % 3, -1.0 * (i % 4)}), {0.1 * (i % 10), 0.5, 0.7},
                           Material::plastic));
    f.items.back().shininess = 0.5, f.items.back().transparency = i % 5 == 0 ? 0.5 : 0;
  }
  f.lights = {lamp({5, 9, 5}, 40), lamp({-5, 4, 5}, 20)};
  return f;
}

TEST(RenderSame, TheSameFrameTwiceIsTheSamePicture) {
  for (const Style& style : styles()) {
    const auto r = renderer({160, 90, 4, std::string(style.name)});
    Picture a, b, other;
    ASSERT_TRUE(r->render(busy(), a));
    ASSERT_TRUE(r->render(frame(), other));
    ASSERT_TRUE(r->render(busy(), b));
    EXPECT_EQ(a.rgba, b.rgba) << style.name;
    EXPECT_NE(a.rgba, other.rgba) << style.name;
  }
}

// A renderer's first picture is as its others, though it makes what it needs only then: programs, shadows, textures.
TEST(RenderSame, TheFirstPictureIsAsTheSecond) {
  const auto white = std::make_shared<const Picture>(Picture{2, 2, std::vector<std::uint8_t>(16, 255)});
  Frame f = busy();
  for (Item& i : f.items) i.texture = white, i.transparency = 0;
  Frame before = f;
  before.items[3].world = translation({1, 1, 1});
  for (const bool sky : {false, true}) {
    if (sky) f.surroundings.environment.kind = before.surroundings.environment.kind = Sky::studio;
    const Picture first = draw(f, {160, 90, 4, "shaded"});
    const auto r = renderer({160, 90, 4, "shaded"});
    Picture later;
    ASSERT_TRUE(r->render(before, later));
    ASSERT_TRUE(r->render(f, later));
    EXPECT_EQ(first.rgba, later.rgba) << sky;
  }
}

TEST(RenderSame, TwoThreadsDrawTheSamePictures) {
  const Picture expected = draw(busy(), {160, 90, 4, "shaded"});
  Picture got[2];
  std::vector<std::thread> threads;
  for (Picture& p : got)
    threads.emplace_back([&p] {
      for (int again = 0; again < 3; ++again) p = draw(busy(), {160, 90, 4, "shaded"});
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(got[0].rgba, expected.rgba);
  EXPECT_EQ(got[1].rgba, expected.rgba);
}

TEST(RenderSame, MeshesComeAndGo) {
  const auto r = renderer({32, 32, 1, "shaded"});
  Picture p;
  for (int i = 0; i < 40; ++i) {
    Frame f = frame();
    f.items.push_back(item(square(), scaling({9, 9, 1}), {1, 1, 1}));  // a new mesh each time
    ASSERT_TRUE(r->render(f, p));
    EXPECT_EQ(pixel(p, 16, 16).r, 255);
  }
}

TEST(RenderMany, AHundredThousandThings) {
  Frame f = frame();
  const auto ball = sphere(0.02), tile = square();
  for (int i = 0; i < 100000; ++i)
    f.items.push_back(item(i % 2 ? ball : tile,
                           translation({(i % 400) * 0.025 - 5, (i / 400) * 0.04 - 5, 0}) * scaling({.02, .02, .02}),
                           {1, 1, 1}));
  f.items.push_back(item(tile, translation({0, 0, 1}), {1, 1, 1}));
  EXPECT_EQ(pixel(draw(f, {100, 100, 1, "shaded"}), 50, 50).r, 255);
}

}  // namespace
}  // namespace betwixt

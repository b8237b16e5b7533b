// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

TEST(RenderColor, GlowAndBackgroundAreExact) {
  const auto r = renderer({16, 16, 4, "shaded"});
  for (int byte = 0; byte < 256; ++byte) {
    Frame f = frame();
    const double l = decoded(byte / 255.0);
    f.background = Vec3{l, decoded((255 - byte) / 255.0), 0};
    f.items.push_back(
        item(square(), translation({0, 5, 0}) * scaling({100, 10, 1}), {0, l, decoded((255 - byte) / 255.0)}));
    Picture p;
    ASSERT_TRUE(r->render(f, p));
    EXPECT_EQ(pixel(p, 8, 12), (Pixel{byte, 255 - byte, 0, 255}));
    EXPECT_EQ(pixel(p, 8, 3), (Pixel{0, byte, 255 - byte, 255}));
  }
}

TEST(RenderColor, MoreThanWhiteIsWhite) {
  Frame f = frame();
  f.items.push_back(item(square(), scaling({50, 50, 1}), {7, 1, 0}));
  EXPECT_EQ(pixel(draw(f), 50, 50), (Pixel{255, 255, 0, 255}));
}

TEST(RenderColor, HalfOfATransparentThingOverWhiteBlendsInLinearLight) {
  Frame f = frame();
  f.background = Vec3{1, 1, 1};
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 0, 0.25}));
  f.items[0].transparency = 0.5;
  const Pixel p = pixel(draw(f), 50, 50);
  EXPECT_EQ(p.r, 255);
  EXPECT_NEAR(p.g, encoded_byte(0.5), 1);
  EXPECT_NEAR(p.b, encoded_byte(0.5 + 0.125), 1);
}

TEST(RenderColor, TransparentThingsAreSortedByDistance) {
  Frame f = frame();
  f.items.push_back(item(square(), translation({0, 0, 1}) * scaling({50, 50, 1}), {0, 1, 0}));  // nearer, and first
  f.items.push_back(item(square(), scaling({50, 50, 1}), {1, 0, 0}));
  for (Item& i : f.items) i.transparency = 0.5;
  const Pixel p = pixel(draw(f), 50, 50);
  EXPECT_NEAR(p.g, encoded_byte(0.5), 1);
  EXPECT_NEAR(p.r, encoded_byte(0.25), 1);
}

TEST(RenderColor, TexturesMultiplyAndStandUpright) {
  auto picture = std::make_shared<Picture>();
  picture->width = 1, picture->height = 2;
  picture->rgba = {255, 0, 0, 255, 0, 0, 255, 255};  // red above blue
  Frame f = frame();
  f.items.push_back(item(square(), scaling({8, 8, 1}), {1, 1, 1}));
  f.items[0].texture = picture;
  const Picture p = draw(f);
  const Pixel upper = pixel(p, 50, 29), lower = pixel(p, 50, 70);
  EXPECT_GT(upper.r, 250);
  EXPECT_LT(upper.b, 40);
  EXPECT_LT(lower.r, 40);
  EXPECT_GT(lower.b, 250);
}

// The outline of a ball is a circle, not a polygon: no pixel that is wholly inside it shows what is behind.
TEST(RenderSurfaces, BallsAreRound) {
  for (const double radius : {16.0, 62.0, 140.0, 240.0}) {
    Frame f = frame();
    const int size = 512;
    f.items = {item(sphere(radius * 10 / size), {}, {1, 1, 1})};
    const Picture p = draw(f, {size, size, 4, "shaded"});
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        if (std::hypot(x + 0.5 - size / 2.0, y + 0.5 - size / 2.0) < radius - 0.95)
          ASSERT_EQ(pixel(p, x, y).r, 255) << radius << ' ' << x << ' ' << y;
  }
}

}  // namespace
}  // namespace betwixt

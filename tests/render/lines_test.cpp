// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares the pixels of transparent lines with closed forms.
#include "render/scenes.h"

namespace betwixt {
namespace {

using namespace scenes;

// A loop with sharp and gentle bends that crosses itself.
std::shared_ptr<const Shape> loop(double width) {
  auto shape = std::make_shared<Shape>();
  shape->kind = Kind::polyline;
  shape->width = width;
  shape->points = std::vector<Vec3>{{-4, -2, 0}, {3, 2, 0},    {3.5, 0, 0}, {3, -2, 0},
                                    {-4, 2, 0},  {-2.5, 3, 0}, {0, 3.3, 0}, {-3.8, 3.6, 0}};
  return shape;
}

Picture seen(const std::vector<std::shared_ptr<const Shape>>& lines, double transparency, int samples) {
  Frame f = frame();
  for (const auto& l : lines) {
    f.items.push_back(item(l, translation({0, 0, 0}), {1, 1, 1}));
    f.items.back().transparency = transparency;
  }
  return draw(f, {160, 160, samples, "shaded"});
}

int count(const Picture& p, int low, int high) {
  int n = 0;
  for (int y = 0; y < p.height; ++y)
    for (int x = 0; x < p.width; ++x) n += pixel(p, x, y).g >= low && pixel(p, x, y).g <= high;
  return n;
}

TEST(RenderLines, AreTransparentOnceWhereTheyCrossThemselves) {
  const int half = encoded_byte(0.5);
  for (const int samples : {1, 4, 9, 16}) {
    const Picture solid = seen({loop(0.7)}, 0, samples), clear = seen({loop(0.7)}, 0.5, samples);
    EXPECT_EQ(count(clear, half + 2, 255), 0) << "nothing is there twice";
    const int covered = count(solid, 254, 255);
    EXPECT_GT(covered, 2000);
    // With four samples, edges are as smooth as those of the pixels around say.
    EXPECT_NEAR(count(clear, half - 1, half + 1), covered, samples == 4 ? 0.01 * covered : 0)
        << samples << ": and all of it once";
  }
}

TEST(RenderLines, OfTwoThingsAreBothSeen) {
  auto one = std::make_shared<Shape>();
  one->kind = Kind::line, one->width = 1, one->size = {8, 0, 0};
  Frame f = frame();
  f.items.push_back(item(one, translation({-4, 0, 0}), {1, 1, 1}));
  f.items.push_back(item(one, translation({0, -4, 0}) * rotation(axis_angle({0, 0, 1}, pi / 2)), {1, 1, 1}));
  for (Item& i : f.items) i.transparency = 0.5;
  const Picture p = draw(f);
  EXPECT_NEAR(pixel(p, 50, 50).g, encoded_byte(0.75), 1);
  EXPECT_NEAR(pixel(p, 30, 50).g, encoded_byte(0.5), 1);
}

// A lit line that comes from far behind and ends before a pane: its middle is farther away, so the pane is drawn after
// it.
TEST(RenderLines, HideNothingThatIsBehindThem) {
  auto one = std::make_shared<Shape>();
  one->kind = Kind::line, one->width = 1, one->size = {6, 0, 20};
  const auto picture = [&](bool with_pane, bool with_line) {
    Frame f = frame(20);
    f.surroundings.ambient = Vec3{0.5, 0.5, 0.5}, f.lights = {lamp({0, 500, 0}, 1)};
    if (with_line) f.items.push_back(item(one, translation({-3, 0, -16}), {1, 0, 0}, Material::matte));
    if (with_pane) f.items.push_back(item(square(), scaling({10, 2, 1}), {0, 0, 1}, Material::matte));
    for (Item& i : f.items) i.transparency = 0.5;
    return draw(f);
  };
  const Pixel both = pixel(picture(true, true), 75, 50), pane = pixel(picture(true, false), 75, 50),
              line = pixel(picture(false, true), 75, 50);
  EXPECT_GT(pane.b, 100);
  EXPECT_GT(line.r, 100);
  EXPECT_GT(both.b, 80) << "the pane is seen through the line";
  EXPECT_GT(both.r, 80) << "and the line";
}

// More lines than there are marks for: black ones before a white one.
TEST(RenderLines, ManyAreEachTransparentOnce) {
  Frame f = frame();
  for (int i = 0; i < 600; ++i) {
    f.items.push_back(item(loop(0.7), translation({0, 0, 0}), i < 599 ? Vec3{} : Vec3{1, 1, 1}));
    f.items.back().transparency = 0.5;
  }
  const Picture p = draw(f, {160, 160, 1, "shaded"});
  const int half = encoded_byte(0.5);
  EXPECT_EQ(count(p, half + 2, 255), 0);
  EXPECT_GT(count(p, half - 1, half + 1), 2000);
}

TEST(RenderLines, HairlinesToo) {
  const int half = encoded_byte(0.5);
  for (const int samples : {1, 4, 9}) {
    const Picture solid = seen({loop(0)}, 0, samples), clear = seen({loop(0)}, 0.5, samples);
    EXPECT_EQ(count(clear, half + 2, 255), 0) << samples;
    EXPECT_GT(count(clear, 1, 255), 400);
    // As much as the edge that covers most, to a layer; the solid one has what two cover together, where they meet.
    for (int y = 0; y < 160; ++y)
      for (int x = 0; x < 160; ++x) {
        const double cover = decoded(pixel(solid, x, y).g / 255.0), light = decoded(pixel(clear, x, y).g / 255.0);
        EXPECT_LT(light, 0.5 * cover + (samples == 4 ? 0.07 : 0.02)) << x << ' ' << y;
        EXPECT_GT(light, 0.5 * (1 - std::sqrt(1 - cover)) - 0.14) << x << ' ' << y;
      }
  }
}

TEST(RenderLines, StrokesHaveTheirOwnColorAndNoSeams) {
  auto card = std::make_shared<Shape>();
  card->kind = Kind::rectangle, card->size = {4, 4, 1}, card->stroke = {0, 1, 0}, card->stroke_width = 1;
  Frame f = frame();
  f.items.push_back(item(card, translation({0, 0, 0}), {1, 0, 0}));
  const Picture solid = draw(f);
  EXPECT_EQ(pixel(solid, 50, 50), (Pixel{255, 0, 0, 255}));
  EXPECT_EQ(pixel(solid, 50, 27), (Pixel{0, 255, 0, 255})) << "half of it is outside";
  EXPECT_EQ(pixel(solid, 50, 33), (Pixel{0, 255, 0, 255})) << "and half inside";
  f.items[0].transparency = 0.5;
  const Picture clear = draw(f);
  const int half = encoded_byte(0.5);
  for (int x = 26; x < 74; ++x) {  // across: never more light than from one of both, and never less
    const Pixel p = pixel(clear, x, 50);
    EXPECT_NEAR(decoded(p.r / 255.0) + decoded(p.g / 255.0), 0.5, 0.02) << x;
  }
  EXPECT_NEAR(pixel(clear, 50, 27).g, half, 1);
}

}  // namespace
}  // namespace betwixt

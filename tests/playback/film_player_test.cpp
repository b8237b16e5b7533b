// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of a player are, byte by byte, those that a new renderer draws of a single frame.
#include "playback/film_player.h"

#include <gtest/gtest.h>

#include "betwixt/language.h"

namespace betwixt {
namespace {

const RenderOptions small{.width = 32, .height = 18, .samples = 1};
const RenderOptions large{.width = 64, .height = 36, .samples = 4};
const RenderOptions lines{.width = 32, .height = 18, .samples = 1, .style = "wireframe"};

Program film(const std::string& color) {
  return Program::compile(load_text("create eye camera position=(0 0 10)\ncreate ball sphere color=" + color +
                                        "\nball.position\n  1f (-3 0 0)\n  25f (3 0 0)\n",
                                    "film.bx")
                              .document);
}

Picture alone(const Program& program, Time t, const RenderOptions& options, const std::optional<Camera>& eye = {}) {
  Frame frame = program.frame(t);
  if (eye) frame.camera = *eye;
  Picture p;
  EXPECT_TRUE((*make_renderer(options))->render(frame, p));
  return p;
}

TEST(FilmPlayer, DrawsAnyProgramAtAnyTimeInAnySize) {
  const Program red = film("red"), blue = film("blue");
  Camera eye = red.frame({}).camera;
  eye.world.m[12] += 2;  // moved to the right
  FilmPlayer player;
  const struct {
    const Program& program;
    double frame;
    const RenderOptions& options;
    std::optional<Camera> eye;
  } rows[] = {{red, 1, small, {}},  {red, 13, small, {}},  {red, 7, large, {}},        {blue, 7, large, {}},
              {blue, 7, lines, {}}, {blue, 8, lines, eye}, {blue, 8, lines, {}},       {red, 25, small, eye},
              {red, 25, small, {}}, {red, 1, small, {}},   {film("red"), 2, small, {}}};
  for (const auto& row : rows) {
    const Time t = Rate{}.frame(row.frame);
    const Evaluation& evaluation = player.evaluate(row.program, t, row.eye);
    EXPECT_EQ(evaluation.time(), t);
    Picture p;
    ASSERT_TRUE(player.draw(row.options, p));
    EXPECT_EQ(p.rgba, alone(row.program, t, row.options, row.eye).rgba) << row.frame;
    player.rest();
    Picture again;
    ASSERT_TRUE(player.draw(row.options, again));
    EXPECT_EQ(again.rgba, p.rgba);
  }
  EXPECT_NE(alone(red, {}, small).rgba, alone(blue, {}, small).rgba);
  EXPECT_NE(alone(red, {}, small).rgba, alone(red, {}, small, eye).rgba);
}

TEST(FilmPlayer, ReportsWhyItCannotDraw) {
  FilmPlayer player;
  player.evaluate(film("red"), {});
  Picture p;
  const Status drawn = player.draw({.style = "oil"}, p);
  ASSERT_FALSE(drawn);
  EXPECT_EQ(drawn.error().message, "there is no style 'oil'");
  EXPECT_TRUE(player.draw(small, p));
  EXPECT_FALSE(player.show(small));  // only pages have a surface
}

TEST(RendererCache, KeepsTheRenderersUsedLast) {
  RendererCache cache(2);
  Renderer* const a = *cache.get(small);
  Renderer* const b = *cache.get(large);
  EXPECT_NE(a, b);
  EXPECT_EQ(*cache.get(small), a);
  EXPECT_EQ(*cache.get(large), b);
  EXPECT_EQ(*cache.get(small), a);
  (void)*cache.get(lines);  // replaces the large one
  EXPECT_EQ(*cache.get(small), a);
  RenderOptions linear = small;
  linear.linear = true;
  LinearPicture light;
  EXPECT_TRUE((*cache.get(linear))->render(Frame{}, light));
  EXPECT_FALSE((*cache.get(small))->render(Frame{}, light));
}

TEST(RendererCache, LeavesItsRenderersToTheNext) {
  RendererCache spares(2);
  Renderer *a = nullptr, *b = nullptr;
  {
    RendererCache one(1, &spares), other(1, &spares);
    a = *one.get(small), b = *other.get(small);
    EXPECT_NE(a, b);
  }
  RendererCache one(1, &spares), other(1, &spares);
  Renderer* const c = *one.get(small);
  Renderer* const d = *other.get(small);
  EXPECT_TRUE((c == a && d == b) || (c == b && d == a));
  one.clear();
  (void)*one.get(large);
  EXPECT_EQ(*other.get(small), d);
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures during playback must equal, byte by byte, the pictures of single frames.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "betwixt/language.h"
#include "render/scenes.h"
#include "support/plain_film.h"

namespace betwixt {
namespace {

Program compiled(const std::string& script) { return Program::compile(load_text(script, "film.bx").document); }

// Many looks, and what PlainFilm has none of: words, a mesh of lines, glass, suns, a sky, shapes on their way.
std::string film(std::uint64_t seed) {
  return PlainFilm(seed).script() +
         "create words text text=\"ab\" size=2 depth=0.2 position=(-3 4 0)\ncreate other-words text text=\"cd\" size=2 "
         "depth=0.2\nhide other-words\nat 10f words.geometry shape(words)\nat 40f words.geometry shape(other-words) "
         "linear\ncreate stars points points=((1 2 3) (-2 1 0) (0 5 1)) size=0.3\ncreate hair polyline points=((0 0) "
         "(9 "
         "9)) width=0\ncreate glass torus radius=2 tube=0.4 transparency=0.4 position=(0 2 3)\ncreate floor plane "
         "size=(30 30) rotation=(-90deg 0 0)\nfloor.position\n  50f (0 -3 0) hold\n  60f (0 -4 0)\n" +
         (seed % 3 == 0   ? "create day light shines=sun position=(4 9 5)\n"
          : seed % 3 == 1 ? "background #102030\nground on\nfog white from 5 to 90\n"
                          : "");
}

std::vector<Time> times(std::mt19937_64& random) {
  std::vector<Time> out;
  const Rate rate{24, 1};
  int frame = 1;
  for (int k = 0; k < 14; ++k) {
    const auto what = random() % 6;
    frame = what < 3 ? frame + 1 : what == 3 ? frame - 1 : what == 4 ? frame : static_cast<int>(random() % 80);
    out.push_back(rate.frame(frame));
  }
  return out;
}

// The picture of a frame by a renderer that has just drawn something else.
Picture alone(Renderer& r, const Frame& frame) {
  Picture p;
  EXPECT_TRUE(r.render(Frame{}, p));
  EXPECT_TRUE(r.render(frame, p));
  return p;
}

TEST(RenderPlayed, PicturesAreThoseOfTheFrames) {
  for (const Style& style : styles()) {
    const bool slow = style.name == "traced";
    const RenderOptions options{slow ? 16 : 96, slow ? 9 : 54, slow ? 1 : 4, std::string(style.name)};
    const auto playing = scenes::renderer(options), framed = scenes::renderer(options),
               single = scenes::renderer(options);
    for (std::uint64_t seed = 1; seed <= (style.name == "shaded" ? 6 : 2); ++seed) {
      std::mt19937_64 random(seed);
      const Program p = compiled(film(seed)), edited = compiled(film(seed) + "set floor.color red\n");
      Evaluation e(p);
      Picture played, of_frame;
      for (const Time t : times(random)) {
        if (random() % 5 == 0) e.to({static_cast<std::int64_t>(random() % 1000000000)});  // a time nobody sees
        if (random() % 6 == 0) e.use(random() % 2 ? p : edited);
        e.to(t);
        ASSERT_TRUE(playing->render(e, played));
        ASSERT_TRUE(framed->render(e.frame(), of_frame));
        const std::string where = fmt::format("{}, film {}, {} flicks", style.name, seed, t.flicks);
        EXPECT_EQ(played.rgba, of_frame.rgba) << where;
        EXPECT_EQ(played.rgba, alone(*single, e.frame()).rgba) << where;
      }
    }
  }
}

TEST(RenderPlayed, TwoEvaluationsAndFramesTakeTurns) {
  const Program a = compiled(film(4)), b = compiled(film(5));
  const auto r = scenes::renderer({64, 36, 4, "shaded"}), other = scenes::renderer({64, 36, 4, "shaded"});
  Evaluation first(a), second(b);
  Picture p;
  for (int k = 1; k < 12; ++k) {
    Evaluation& e = k % 3 == 0 ? second : first;
    e.to(Rate{24, 1}.frame(k));
    if (k % 4 == 0) {
      EXPECT_TRUE(r->render(scenes::frame(), p));
    }
    ASSERT_TRUE(r->render(e, p));
    EXPECT_EQ(p.rgba, alone(*other, e.frame()).rgba) << k;
  }
}

// Whoever asks again gets the picture again, also after his own is gone.
TEST(RenderPlayed, WhatStandsStillIsGivenAgain) {
  const Program p = compiled("create s sphere\ncreate l light position=(3 4 5)\ncreate eye camera position=(0 0 9)\n");
  const auto r = scenes::renderer({64, 36, 4, "shaded"});
  Evaluation e(p);
  e.to({});
  Picture a, b;
  ASSERT_TRUE(r->render(e, a));
  e.to({705600000});
  ASSERT_TRUE(r->render(e, b));
  EXPECT_EQ(a.rgba, b.rgba);
  EXPECT_GT(scenes::pixel(a, 32, 18).r, scenes::pixel(a, 2, 2).r + 40);
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests `place`, `arrange` and the like by the sizes of objects. The results are computed by hand.
#include <cmath>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

TEST(Arranging, RowsAndColumnsByWhatThingsMeasure) {
  // Widths 2, 4, 1 with gaps of 0.5: 8 in all, from -4 on.
  const std::string things = "create a box size=(2 2 2)\ncreate b sphere radius=2\ncreate c box size=(1 3 1)\n";
  const LoadedFilm row(things + "arrange {a,b,c} in row gap=50cm\n");
  expect_numbers(row, "a.position", "1f", {-3, 0, 0}, 1e-12);
  expect_numbers(row, "b.position", "1f", {0.5, 0, 0}, 1e-12);
  expect_numbers(row, "c.position", "1f", {3.5, 0, 0}, 1e-12);
  // Heights 2, 4, 3, downwards: 10 in all.
  const LoadedFilm column(things + "arrange {a,b,c} in column gap=0.5 centre=(1 2 3)\n");
  expect_numbers(column, "a.position", "1f", {1, 6, 3}, 1e-12);
  expect_numbers(column, "b.position", "1f", {1, 2.5, 3}, 1e-12);
  expect_numbers(column, "c.position", "1f", {1, -1.5, 3}, 1e-12);
}

TEST(Arranging, GridsAndCircles) {
  const LoadedFilm grid("create b{1..5} box size=(i 1 1)\narrange b* in grid columns=3 gap=1\n");
  expect_numbers(grid, "b1.position", "1f", {-6, 1, 0}, 1e-12);  // cells of 5 by 1, and gaps
  expect_numbers(grid, "b3.position", "1f", {6, 1, 0}, 1e-12);
  expect_numbers(grid, "b5.position", "1f", {0, -1, 0}, 1e-12);
  const LoadedFilm circle("create b{1..8} box size=(1 1 1)\narrange b* in circle radius=3 centre=(0 1 0)\n");
  for (int i = 0; i < 8; ++i)
    expect_numbers(circle, fmt::format("b{}.position", i + 1), "1f",
                   {3 * std::sin(i * pi / 4), 1 + 3 * std::cos(i * pi / 4), 0}, 1e-12);
  const LoadedFilm tight(
      "create b{1..6} sphere radius=0.5\narrange b* in circle gap=0\n");  // a hexagon of touching balls
  expect_numbers(tight, "b1.position", "1f", {0, 1, 0}, 1e-12);
}

TEST(Arranging, WhatHangsOnThemCountsAndWhatHoldsThemIsHeeded) {
  const LoadedFilm s(
      "create room group position=(10 0 0) rotation=euler(0 0 90deg) scale=(2 2 2)\ncreate room/a box\n"
      "create room/b group position=(5 5 5)\ncreate room/b/arm box size=(1 1 1) position=(3 0 0)\n"
      "arrange room/{a,b} in row gap=0\n");
  const auto at = [&](const char* name) {
    return translation_of(*std::get<Matrix>(s.read(std::string(name) + ".world", "1f")));
  };
  // Both are 2 wide in the world; the arm is what is seen of b.
  EXPECT_NEAR(at("room/a").x, -1, 1e-12);
  EXPECT_NEAR(at("room/b/arm").x, 1, 1e-12);
  EXPECT_NEAR(at("room/a").y, 0, 1e-12);
  EXPECT_NEAR(at("room/b/arm").y, 0, 1e-12);
}

TEST(Arranging, BehindATimeTheyAreEvents) {
  const LoadedFilm s("rate 24\ncreate b{1..2} box\nb*.position\n  1f (0 5 0) linear\nat 25f arrange b* in row gap=1\n");
  expect_numbers(s, "b1.position", "1f", {0, 5, 0}, 0), expect_numbers(s, "b1.position", "13f", {-0.5, 2.5, 0}, 1e-12);
  expect_numbers(s, "b2.position", "25f", {1, 0, 0}, 1e-12);
}

TEST(Arranging, NextToAnother) {
  const std::string two = "create a box size=(2 4 2) position=(1 1 1)\ncreate b sphere radius=0.5\ncreate c box\n";
  const auto b = [&](const std::string& how, std::vector<double> want) {
    const LoadedFilm s(two + "place b next-to a " + how + "\n");
    expect_numbers(s, "b.position", "1f", want, 1e-12);
  };
  b("", {2.7, 1, 1}), b("side=left gap=0", {-0.5, 1, 1}), b("side=top gap=1 align=left", {0.5, 4.5, 1});
  b("side=right align=top gap=0", {2.5, 2.5, 1}), b("side=front gap=0", {1, 1, 2.5}),
      b("side=back gap=0 align=bottom", {1, -0.5, -0.5});
  const LoadedFilm line(two + "place {b,c} next-to a gap=0\n");
  expect_numbers(line, "b.position", "1f", {2.5, 1, 1}, 1e-12),
      expect_numbers(line, "c.position", "1f", {3.5, 1, 1}, 1e-12);
}

TEST(Arranging, ErrorsByTheirPlace) {
  const std::string two = "create a box\ncreate b box\nlayer up add\n";
  const std::pair<const char*, const char*> table[] = {{"arrange", "syntax 4:8"},
                                                       {"arrange zz in row", "name 4:9 zz"},
                                                       {"arrange a", "syntax 4:10"},
                                                       {"arrange a in", "syntax 4:13"},
                                                       {"arrange a in rwo", "type 4:14 rwo"},
                                                       {"arrange a in row columns=2", "name 4:18 columns"},
                                                       {"arrange a in row gap", "syntax 4:21"},
                                                       {"arrange a in row gap=2deg", "type 4:22 2deg"},
                                                       {"arrange a in grid columns=0", "range 4:27 0"},
                                                       {"arrange a in circle radius=-1", "range 4:21 radius=-1"},
                                                       {"place a", "syntax 4:8"},
                                                       {"place a next-to zz", "name 4:17 zz"},
                                                       {"place a next-to a", "name 4:7 a"},
                                                       {"place a next-to up", "type 4:7 a"},
                                                       {"place a next-to b side=centre", "type 4:24 centre"},
                                                       {"place a next-to b side=left align=right", "syntax 4:7 a"},
                                                       {"place a next-to b size=2", "name 4:19 size"}};
  for (const auto& [line, words] : table) EXPECT_EQ(told(two + line + "\n"), words) << line;
  EXPECT_EQ(told(two + "arrange nothing* in row\n"), "");
}

// All of it is in the picture, and one edge at the margin: by projecting corners.
TEST(Arranging, FramesWhatIsNamed) {
  const auto widest = [](const LoadedFilm& s, const char* time, double aspect, std::initializer_list<Vec3> corners) {
    const Camera c = s.frame(time).camera;
    const Mat4 back = *inverse(c.world);
    double most = 0;
    for (const Vec3 p : corners) {
      const Vec3 at = transform_point(back, p);
      const double half = c.orthographic ? c.height / 2 * aspect : -at.z * std::tan(c.fov / 2);
      most = std::max({most, std::abs(at.x) / half, std::abs(at.y) / half * aspect});
    }
    return most;
  };
  const std::string things =
      "create a box size=(2 2 2) position=(7 1 0)\ncreate b box size=(4 2 2) position=(1 2 -3)\n";
  const std::initializer_list<Vec3> corners{{6, 0, 1},   {8, 2, 1},  {8, 0, -1}, {6, 2, -1},
                                            {-1, 1, -4}, {3, 3, -2}, {-1, 3, -2}};
  for (const char* eye :
       {"create eye camera position=(0 5 20) rotation=euler(-10deg 20deg 0)\n",
        "create eye camera position=(3 2 9) look-at=a fov=40deg\n", "create eye camera position=(3 2 9) height=2\n"}) {
    const LoadedFilm s(things + eye + "at 13f frame {a,b}\n");
    const double all = widest(s, "13f", 16.0 / 9, corners);
    EXPECT_LE(all, 1 / 1.1 + 1e-9) << eye;
    EXPECT_GE(all, 0.6) << eye;
  }
  // One box, straight on: its front face is as high as the picture without the margin.
  const LoadedFilm flat(
      "create a box size=(2 2 2)\ncreate eye camera position=(0 0 9) fov=90deg\nsize 1000x1000\nframe a margin=0\n");
  expect_numbers(flat, "eye.position", "1f", {0, 0, 2}, 1e-9);
  EXPECT_EQ(told("create a box\nframe a\n"), "name 2:7 a");
  EXPECT_EQ(told("create a box\ncreate e camera\nframe a margin=-1\n"), "range 3:9 margin=-1");
  EXPECT_EQ(told("create a box\ncreate e camera\nframe nobody\n"), "name 3:7 nobody");
}

}  // namespace
}  // namespace betwixt

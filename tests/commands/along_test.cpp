// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <random>

#include "betwixt/evaluation.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// A line of length 8, straight right and then up.
const std::string road = "create road curve points=((0 0) (6 0) (6 2)) smooth=off\ncreate a box\n";

Mat4 world(const LoadedFilm& s, std::string_view object, std::string_view time) {
  return *std::get<Matrix>(s.read(std::string(object) + ".world", time));
}

void expect_at(const std::string& film, std::initializer_list<std::pair<const char*, Vec3>> places) {
  const LoadedFilm s(film);
  for (const auto& [time, place] : places) expect_place(s, "a", time, place);
}

TEST(Along, ALineByItsLength) {
  expect_at(road + "a.position\n  1f..9f along road linear\n",
            {{"1f", {0, 0, 0}}, {"4f", {3, 0, 0}}, {"7f", {6, 0, 0}}, {"8f", {6, 1, 0}}, {"9f", {6, 2, 0}}});
  // It holds its end until the next row.
  expect_at(road + "a.position\n  1f..9f along road linear\n  20f (0 5 0)\n",
            {{"9f", {6, 2, 0}}, {"19f", {6, 2, 0}}, {"20f", {0, 5, 0}}});
  expect_at(road + "a.position\n  1f..9f along road from 1 to 0.5 linear\n",
            {{"1f", {6, 2, 0}}, {"3f", {6, 1, 0}}, {"9f", {4, 0, 0}}});
}

TEST(Along, TheTwerperSaysHowFar) {
  // sine-in of Penner: 1 - cos(u pi / 2)
  const double done = 1 - std::cos(0.5 * pi / 2);
  expect_at(road + "a.position\n  1f..9f along road sine-in\n", {{"5f", {8 * done, 0, 0}}});
  // Between places on one line the shares blend, in splines too: here they are in proportion to the time.
  expect_at(road + "a.position\n  1f along road 0 smooth\n  3f along road 0.25 smooth\n  9f along road 1\n",
            {{"2f", {1, 0, 0}}, {"6f", {5, 0, 0}}, {"8f", {6, 1, 0}}});
}

TEST(Along, ACurveThatMovesAndTurnsAndIsScaled) {
  const std::string film =
      road + "set road.position (1 1 0)\nset road.rotation euler(0 0 90deg)\nset road.scale (2 2 2)\n";
  expect_at(film + "a.position\n  1f..9f along road linear\n",
            {{"1f", {1, 1, 0}}, {"4f", {1, 7, 0}}, {"9f", {-3, 13, 0}}});
  // Scaled along x only, the lengths are those of what is seen: 12 and 2.
  expect_at(road + "set road.scale (2 1 1)\na.position\n  1f..8f along road linear\n",
            {{"4f", {6, 0, 0}}, {"7f", {12, 0, 0}}, {"8f", {12, 2, 0}}});
}

TEST(Along, WhatHangsOnSomethingIsOnTheLineAllTheSame) {
  const std::string parent =
      "create hand box position=(4 4 1) rotation=euler(0 0 90deg) scale=(2 2 2)\ncouple a to hand\n";
  const LoadedFilm s(road + parent + "a.position\n  1f..9f along road turned linear\n");
  expect_place(s, "a", "4f", {3, 0, 0});
  const Mat4 up = world(s, "a", "8f");
  EXPECT_NEAR(up(1, 0) / 2, 1, 1e-9);  // its x goes up, whatever the hand does
}

TEST(Along, TurnedFacesTheWay) {
  const LoadedFilm s(road + "a.position\n  1f..9f along road turned linear\n");
  const auto front = [&](const char* t) {
    const Mat4 m = world(s, "a", t);
    return Vec3{m(0, 0), m(1, 0), m(2, 0)};
  };
  EXPECT_LE(length(front("4f") - Vec3{1, 0, 0}), 1e-9);
  EXPECT_LE(length(front("8f") - Vec3{0, 1, 0}), 1e-9);
  // A camera looks where it goes, upright.
  const LoadedFilm c(
      "create road curve points=((0 0 0) (0 0 5) (5 0 5)) smooth=off\ncreate eye camera\n"
      "eye.position\n  1f..11f along road turned linear\n");
  const Mat4 m = world(c, "eye", "9f");
  EXPECT_LE(length(Vec3{m(0, 2), m(1, 2), m(2, 2)} - Vec3{-1, 0, 0}), 1e-9);
  EXPECT_LE(length(Vec3{m(0, 1), m(1, 1), m(2, 1)} - Vec3{0, 1, 0}), 1e-9);
}

TEST(Along, OneRowBehindTheOther) {
  const std::string two = road + "create other curve points=((0 9) (4 9))\na.position\n";
  expect_at(two + "  1f..9f along road linear\n  9f..13f along other linear\n",
            {{"8f", {6, 1, 0}}, {"9f", {0, 9, 0}}, {"11f", {2, 9, 0}}, {"13f", {4, 9, 0}}});
  expect_at(two + "  9f..13f along other linear\n  1f..9f along road linear\n",
            {{"8f", {6, 1, 0}}, {"9f", {0, 9, 0}}, {"11f", {2, 9, 0}}});
  // What was there comes to where it came to.
  expect_at(two + "  1f (0 0 4) linear\n  5f (0 0 8) linear\n  5f..9f along other linear\n",
            {{"3f", {0, 0, 6}}, {"5f", {0, 9, 0}}, {"7f", {2, 9, 0}}});
  // Said once more it is what was said last.
  expect_at(two + "  1f..9f along road linear\n  1f..9f along road from 0.5 to 1 linear\n",
            {{"1f", {4, 0, 0}}, {"9f", {6, 2, 0}}});
}

// What a row says is from where to where it goes: another one beside it takes it no further.
TEST(Along, NoRowGoesBeyondItsEnds) {
  expect_at(road + "a.position\n  1f..9f along road from 0 to 0\n  9f..17f along road\n",
            {{"1f", {0, 0, 0}}, {"5f", {0, 0, 0}}, {"9f", {0, 0, 0}}, {"17f", {6, 2, 0}}});
  std::mt19937 dice(3);
  const auto part = [&] { return std::uniform_int_distribution<>(0, 10)(dice) / 20.0; };  // on the straight half
  for (int film = 0; film < 20; ++film) {
    std::vector<double> ends{part()};
    std::string rows = road + "a.position\n";
    for (int i = 0; i < 4; ++i) {
      ends.push_back(part());
      rows += fmt::format("  {}f..{}f along road from {} to {}\n", 1 + 8 * i, 9 + 8 * i, ends[ends.size() - 2],
                          ends.back());
    }
    const LoadedFilm s(rows);
    for (int i = 0; i < 64; ++i) {
      const std::size_t row = static_cast<std::size_t>(i) / 16;
      const double x = place(s, "a", fmt::format("{}f", 1 + i / 2.0)).x / 8;
      EXPECT_GE(x, std::min(ends[row], ends[row + 1]) - 1e-9) << rows << i;
      EXPECT_LE(x, std::max(ends[row], ends[row + 1]) + 1e-9) << rows << i;
    }
  }
}

TEST(Along, IsWrittenAndReadBack) {
  const std::string film = road +
                           "a.position\n  1f..9f along road from 0.25 to 1 turned sine-in-out ease-in=2f\n"
                           "  12f (1 2 3)\nset a.pivot (0 1 0)\ncreate b box\nset b.position along road 0.5 turned\n";
  const LoadedFilm first(film);
  const LoadedFilm again(write(first.loaded.document));
  for (const char* t : {"1f", "3f", "6.5f", "9f", "12f"})
    for (const char* name : {"a", "b"})
      EXPECT_LE(length(translation_of(world(first, name, t)) - translation_of(world(again, name, t))), 1e-12) << t;
  EXPECT_EQ(write(first.loaded.document), write(again.loaded.document));
}

TEST(Along, MovesWithOperationsAndNames) {
  expect_at(road + "a.position\n  1f..9f along road linear\nmove a.position 1f..9f by 10f\n",
            {{"11f", {0, 0, 0}}, {"14f", {3, 0, 0}}, {"19f", {6, 2, 0}}});
  expect_at(road + "a.position\n  1f..9f along road linear\nrename road way\n", {{"4f", {3, 0, 0}}});
  const LoadedFilm gone(road + "a.position\n  1f..9f along road linear\nremove road\n");
  expect_place(gone, "a", "1f", {0, 0, 0});
  expect_place(gone, "a", "5f", {3, 1, 0});  // straight
  expect_place(gone, "a", "9f", {6, 2, 0});
}

TEST(Along, IsCopiedStretchedAndRepeated) {
  const std::string way = road + "a.position\n  1f..9f along road linear\n";
  expect_at(way + "stretch a.position 1f..9f by 2\n", {{"1f", {0, 0, 0}}, {"7f", {3, 0, 0}}, {"17f", {6, 2, 0}}});
  expect_at(way + "copy a.position 1f..9f to 21f\n", {{"9f", {6, 2, 0}}, {"24f", {3, 0, 0}}, {"29f", {6, 2, 0}}});
  expect_at(way + "extend a.position cycle\n",
            {{"4f", {3, 0, 0}}, {"9f", {0, 0, 0}}, {"12f", {3, 0, 0}}, {"84f", {3, 0, 0}}});
  expect_at(way + "extend a.position bounce\n", {{"14f", {3, 0, 0}}, {"20f", {3, 0, 0}}});
  expect_at(way + "bake a.position 1f..9f\nremove road\n", {{"4f", {3, 0, 0}}, {"8f", {6, 1, 0}}});
}

TEST(Along, OnALayerToo) {
  const std::string film = road + "layer over mix\non over at 1f..9f a.position along road linear\n";
  expect_at(film, {{"4f", {3, 0, 0}}, {"9f", {6, 2, 0}}});
  const LoadedFilm gone(film + "remove road\n");
  expect_place(gone, "a", "5f", {3, 1, 0});
  expect_place(gone, "a", "9f", {6, 2, 0});
}

TEST(Along, LuaAsksForPlaces) {
  expect_at(road + "set a.position = \"place('road', t * 3)\"\n", {{"1f", {0, 0, 0}}, {"3f", {2, 0, 0}}});
}

TEST(Along, ErrorsInWords) {
  const auto error = [](const std::string& film) { return told(road + film); };
  EXPECT_EQ(error("a.position\n  1f..9f along\n"), "syntax 4:15");
  EXPECT_EQ(error("a.position\n  1f..9f along raod\n"), "name 4:16 raod");
  EXPECT_EQ(error("a.position\n  1f..9f along a\n"), "type 4:16 a");
  EXPECT_EQ(error("road.position\n  1f..9f along road\n"), "name 4:16 road");
  EXPECT_EQ(error("a.position.x\n  1f..9f along road\n"), "type 4:10 along");
  EXPECT_EQ(error("a.scale\n  1f..9f along road\n"), "type 4:10 along");
  EXPECT_EQ(error("a.position\n  1f..9f along road from 0\n"), "syntax 4:27");
  EXPECT_EQ(error("a.position\n  1f..9f along road from 1m to 2\n"), "type 4:26 1m");
  EXPECT_EQ(error("a.position\n  1f..1f along road\n"), "range 4:10 along");
  EXPECT_EQ(error("a.position\n  1f along road\n"), "syntax 4:16");
  EXPECT_EQ(error("a.position\n  1f..9f along road wobbly\n"), "name 4:21 wobbly");
  EXPECT_EQ(error("a.position.velocity\n  1f along road 0\n"), "type 4:6 along");
  EXPECT_EQ(error("set a.position along road 1e9\n"), "range 3:27 1e9");
}

TEST(LookAt, TurnsAnythingWithItsFront) {
  const LoadedFilm s(
      "create ball sphere position=(0 0 5)\ncreate a box look-at=ball scale=(1 2 3)\n"
      "create b box look-at=ball front=z position=(1 0 0)\ncouple b to a\n");
  const Mat4 a = world(s, "a", "1f"), b = world(s, "b", "1f");
  EXPECT_LE(length(Vec3{a(0, 0), a(1, 0), a(2, 0)} - Vec3{0, 0, 1}), 1e-9);  // x, scaled by 1, towards the ball
  EXPECT_NEAR(a(1, 1), 2, 1e-9);                                             // y stays up, and is twice as long
  // Where b is its z axis points to the ball.
  const Vec3 to_ball = normalize(Vec3{0, 0, 5} - translation_of(b));
  EXPECT_LE(length(normalize(Vec3{b(0, 2), b(1, 2), b(2, 2)}) - to_ball), 1e-9);
}

TEST(LookAt, InAFlatFilmThingsTurnAboutTheViewer) {
  const LoadedFilm s("film flat\ncreate ball circle position=(-3 -3 0)\ncreate a arrow look-at=ball\n");
  const Mat4 a = world(s, "a", "1f");
  EXPECT_LE(length(Vec3{a(0, 0), a(1, 0), a(2, 0)} - Vec3{-std::sqrt(0.5), -std::sqrt(0.5), 0}), 1e-9);
  EXPECT_NEAR(a(2, 2), 1, 1e-9);
}

TEST(LookAt, OffsetAndRoll) {
  const LoadedFilm s(
      "create ball sphere position=(0 0 -5)\ncreate eye camera look-at=ball look-offset=(5 0 0)\n"
      "create tilted camera look-at=ball roll=90deg\ncreate alone camera roll=30deg\n");
  const Mat4 eye = world(s, "eye", "1f"), tilted = world(s, "tilted", "1f"), alone = world(s, "alone", "1f");
  EXPECT_LE(length(Vec3{eye(0, 2), eye(1, 2), eye(2, 2)} - Vec3{-std::sqrt(0.5), 0, std::sqrt(0.5)}), 1e-9);
  EXPECT_LE(length(Vec3{tilted(0, 0), tilted(1, 0), tilted(2, 0)} - Vec3{0, 1, 0}), 1e-9);
  EXPECT_NEAR(alone(1, 0), 0.5, 1e-12);
}

TEST(LookAt, IsAFunctionOfTheTimeAlone) {
  const LoadedFilm s(
      "create ball sphere position=(0 0 5)\nball.position\n  1f (0 0 5) linear\n  25f (5 3 -5)\n"
      "create a box look-at=ball scale=(1 2 3) rotation=euler(10deg 20deg 30deg)\ncreate b box position=(1 0 0)\n"
      "couple b to a\n");
  const Program p = s.program;
  Evaluation going(p);
  for (int f = 0; f < 60; ++f) {
    const Time t{(f * 17 % 25) * (flicks_per_second / 24)};
    going.to(t);
    const Frame whole = p.frame(t);
    for (std::size_t i = 0; i < whole.items.size(); ++i) EXPECT_EQ(whole.items[i].world.m, going.worlds()[i].m) << f;
  }
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests values from Lua code: points, words and names; and what the code can read.
#include <cmath>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

Points points(const LoadedFilm& s, std::string_view target, std::string_view time) {
  return std::get<Points>(s.read(target, time));
}

std::string problem(const std::string& script, const char* time = "1f") {
  const LoadedFilm s(script);
  const Frame f = s.frame(time);
  return f.problems.empty() ? "" : f.problems[0];
}

// shows: G15
TEST(Computed, PointsMakeALine) {
  const LoadedFilm s(
      "rate 24\ncreate w polyline\nset w.points = \"local p = {} for i = 1, 5 do p[i] = vec(i, sin(i + t)) end "
      "return p\"\ncreate m sphere\nset m.position = \"value('w.points')[2]\"\n");
  for (const char* time : {"1f", "25f", "7f"}) {
    const double t = parse_time(time, s.loaded.document)->seconds();
    const Points p = points(s, "w.points", time);
    ASSERT_EQ(p->size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
      const double x = static_cast<double>(i) + 1;
      EXPECT_NEAR((*p)[i].x, x, 0);
      EXPECT_NEAR((*p)[i].y, std::sin(x + t), 1e-15);
    }
    expect_numbers(s, "m.position", time, {2, std::sin(2 + t), 0}, 1e-15);
    // What is drawn is that.
    const Frame f = s.frame(time);
    ASSERT_EQ(f.items.size(), 2u);
    EXPECT_EQ(f.items[0].shape->points, p);
    EXPECT_TRUE(f.problems.empty());
  }
}

// A component without events or code is the value that was set. Reading it is no circle.
TEST(Computed, CodeOfAComponentReadsAnotherThatWasSet) {
  const LoadedFilm s(
      "create b sphere position=(1 2 4)\nset b.position.x 3\nset b.position.y = \"value('.position.x') + "
      "value('.position.z', t - 1)\"\n");
  const Frame f = s.frame("5f");
  EXPECT_TRUE(f.problems.empty()) << f.problems[0];
  expect_numbers(s, "b.position", "5f", {3, 7, 4});
}

// shows: R-T11
TEST(Computed, MatricesAreNoNumbers) {
  const std::string two = "create a box\ncreate b box\ncreate c box\n";
  const auto why = [&](const std::string& code) {
    const std::string said = problem(two + "set c.position = \"" + code + "\"\n");
    return said.substr(said.find("no value: ") + 10);
  };
  const std::string hint = "; its .x, .y and .z are numbers, as in value('a.world.x')";
  EXPECT_EQ(why("value('a.world') - value('b.world')"), "a matrix cannot be subtracted from a matrix" + hint);
  EXPECT_EQ(why("2 * value('b.world')"), "a number and a matrix cannot be multiplied" + hint);
  EXPECT_EQ(why("-value('b.world')"), "a matrix cannot be negated, but its .x, .y and .z can");
}

// Where a thing is follows from its position; how it is turned, and what it looks at, does not count for that.
TEST(Computed, WhereAThingIsIsNotHowItIsTurned) {
  const LoadedFilm s(
      "rate 24\ncreate ball sphere position=(0 0 -9)\ncreate eye camera position=(0 2 0) look-at=ball\n"
      "set eye.position.x = \"t\"\ncreate hat box position=(0 0 -1)\ncouple hat to eye\n"
      "set eye.fov = \"value('eye.world.y') / 2\"\nset eye.roll = \"value('eye.world.x')\"\n"
      "set eye.position.z = \"value('eye.world.x') * 3\"\nset ball.radius = \"value('eye.world.x') + 1\"\n"
      "create wheel cylinder\nset wheel.position.x = \"4 * t\"\nset wheel.rotation.z = \"-value('.world.x')\"\n"
      "create heavy box\nset heavy.scale = \"value('hat.world') and vec(1, 1 + t, 1)\"\n"
      "create text text text=\"a\"\nset text.text = \"value('hat.world.y') > 0 and 'up' or 'down'\"\n"
      "create b box look-at=ball\nset b.position.y = \"value('hat.world.y') * 0 + value('eye.world.z')\"\n");
  EXPECT_TRUE(s.frame("13f").problems.empty()) << s.frame("13f").problems[0];
  expect_numbers(s, {{"eye.position", "13f", {0.5, 2, 1.5}},
                     {"eye.fov", "13f", {1}},
                     {"eye.roll", "13f", {0.5}},
                     {"ball.radius", "13f", {1.5}},
                     {"wheel.rotation", "13f", {0, 0, -2}},
                     {"heavy.scale", "13f", {1, 1.5, 1}},
                     {"b.position", "13f", {0, 1.5, 0}}});
  EXPECT_EQ(s.text("text.text", "13f"), "up");
  // The hat is one before the eye, on the way to the ball.
  const Vec3 eye{0.5, 2, 1.5};
  expect_place(s, "hat", "13f", eye + normalize(Vec3{0, 0, -9} - eye));
}

// These are circles.
TEST(Computed, HowAThingIsTurnedMovesWhatIsOffItsPivot) {
  const char* const said = "a.rotation depends on itself: it uses its last value without code there";
  const std::string turns = "set a.rotation.z = \"value('a.world.x')\"\n";
  EXPECT_EQ(problem("create a box\n" + turns), "");
  EXPECT_EQ(problem("create a box pivot=(1 0 0)\n" + turns), said);
  EXPECT_EQ(problem("create a box\nset a.pivot = \"vec(0, 0, 0 * t)\"\n" + turns), said);
  EXPECT_EQ(problem("create a box\nset a.pivot = \"vec(0, 0, 0)\"\n" + turns), "");  // constant
  EXPECT_EQ(
      problem(
          "create a box\ncreate b box position=(1 0 0)\ncouple b to a\nset a.rotation.z = \"value('b.world.x')\"\n"),
      said);
  EXPECT_EQ(problem("create a box transform=translate(1 0 0)\n" + turns), said);
}

TEST(Computed, PointsOfOneTrackAndOthers) {
  // From an event on; before it what was set. A line of no points is one that is not seen.
  const LoadedFilm s(
      "rate 24\ncreate g polygon points=((0 0) (1 0) (0 1))\ng.points\n  1f ((0 0) (2 0) (0 2)) hold\n"
      "  10f = \"{vec(t, 0), vec(1, 0), vec(0, 1)}\"\n  25f ((0 0) (4 0) (0 4))\n"
      "create empty polyline\nset empty.points = \"{}\"\n");
  EXPECT_EQ((*points(s, "g.points", "9f"))[1].x, 2);
  EXPECT_EQ((*points(s, "g.points", "13f"))[0].x, 0.5);
  EXPECT_EQ((*points(s, "g.points", "25f"))[1].x, 4);
  EXPECT_EQ(points(s, "empty.points", "3f"), Points());
  EXPECT_TRUE(s.frame("13f").problems.empty());
}

TEST(Computed, ThingsGoAlongAComputedLine) {
  // A straight one that rises: half its length is half of its height.
  const LoadedFilm s(
      "rate 24\ncreate road curve smooth=off\nset road.points = \"{vec(0, 0), vec(0, 2 + 2 * t)}\"\ncreate b sphere\n"
      "b.position\n  1f..25f along road linear\n");
  expect_place(s, "b", "13f", {0, 1.5, 0});
  expect_place(s, "b", "25f", {0, 4, 0});
}

TEST(Computed, WordsAreThoseThatThereAre) {
  const LoadedFilm s(
      "rate 24\ncreate b sphere\nset b.material = \"t < 0.5 and 'matte' or 'glow'\"\ncreate l light\n"
      "set l.shines = \"frame > 5 and 'sun' or 'point'\"\nset l.shadow = \"'soft'\"\ncreate x text text=\"ab\"\n"
      "set x.align = \"t < 0.5 and 'left' or 'right'\"\n");
  const Frame first = s.frame("1f"), later = s.frame("24f");
  EXPECT_EQ(first.items[0].material, Material::matte);
  EXPECT_EQ(later.items[0].material, Material::glow);
  EXPECT_FALSE(first.lights[0].sun);
  EXPECT_TRUE(later.lights[0].sun);
  EXPECT_EQ(first.lights[0].casting, Casting::soft);
  EXPECT_EQ(first.items[1].shape->letters.align, Align::left);
  EXPECT_EQ(later.items[1].shape->letters.align, Align::right);
  EXPECT_TRUE(first.problems.empty());
  EXPECT_TRUE(
      problem("create b sphere\nset b.material = \"'gld'\"\n")
          .starts_with("b.material: the procedure \"'gld'\" gives no value: 'gld' is not one of plastic, matte, "
                       "metal, glow, gold, silver"));
  EXPECT_EQ(problem("create b sphere\nset b.material = \"vec(1, 2, 3)\"\n"),
            "b.material: the procedure \"vec(1, 2, 3)\" gives no value: it must return a text, not a vector");
}

TEST(Computed, ComponentsAndPlacesInTheWorld) {
  const LoadedFilm s(
      "rate 24\ncreate hub group position=(1 2 3)\ncreate hub/p box position=(0 1 0)\n"
      "set hub.rotation.z = \"t * tau / 4\"\ncreate c sphere\nset c.position.x = \"value('hub/p.world.x')\"\n"
      "set c.position.y = \"value('hub/p.world').y\"\nset c.color.g = \"0.25\"\n");
  expect_numbers(s, {{"hub.rotation", "25f", {0, 0, pi / 2}}, {"c.color.g", "1f", {0.25}}});
  expect_place(s, "c", "1f", {1, 3, 0});
  expect_place(s, "c", "25f", {0, 2, 0});  // a quarter turn anticlockwise
}

// Components that code computes for the whole film: the others stay what is set.
TEST(Computed, ASetComponent) {
  const LoadedFilm s(
      "rate 24\ncreate b box position=(1 2 3)\nset b.position.y = \"10 + t\"\nset b.color red\n"
      "set b.color.{g,b} = \"t\"\ncreate c{1..2} box\nset c*.position.x = \"t\"\nset c*.position.x = \"2 * t\"\n");
  expect_numbers(s, {{"b.position", "25f", {1, 11, 3}}, {"c2.position", "25f", {2, 0, 0}}});
  expect_numbers(s, "b.color", "13f", {1, 0.5, 0.5});
  EXPECT_EQ(read(write(s.loaded.document)).document, s.loaded.document);
  // Behind a track's first event it is as with all that is set.
  const Loaded late = read("create b box\nb.position.x\n  1f 3\nset b.position.x = \"t\"\n");
  ASSERT_EQ(late.diagnostics.size(), 1u);
  EXPECT_EQ(told(late.diagnostics[0]), "warning syntax 4:5 b.position.x");
  EXPECT_EQ(told("create b box\nset b.position = \"vec(1, 2)\"\nset b.position.x = \"t\"\n"), "type 3:5 b.position.x");
}

TEST(Computed, PartsOfWhatCanBeAsked) {
  EXPECT_EQ(problem("create b box\nset b.position.x = \"value('b.world.w')\"\n"),
            "b.position.x: the procedure \"value('b.world.w')\" gives no value: value('b.world.w'): there is no such "
            "part; a matrix is a table of 16 numbers, with x y z");
  const std::string seen = problem("create b box\nset b.color.r = \"value('b.in-view.x')\"\n");
  EXPECT_TRUE(seen.starts_with("b.color.r: ")) << seen;
  EXPECT_NE(seen.find(": value('b.in-view.x'): "), std::string::npos) << seen;
  EXPECT_EQ(
      problem("create b box\nset b.position.x = \"\"\"\n  local a = 1\n\n  return a.b.c\n\"\"\"\n"),
      "b.position.x: the procedure \"local a = 1 …\" gives no value: line 4: attempt to index a number value (local "
      "'a')");
}

TEST(Computed, FramesAreCountedAsScriptsCount) {
  const LoadedFilm s("rate 30\ncreate x text\nset x.text = \"frame .. '/' .. rate\"\n");
  EXPECT_EQ(s.text("x.text", "12f"), "12/30");
  EXPECT_EQ(s.text("x.text", "1s"), "31/30");
  const LoadedFilm f(
      "rate 30\ncreate a box\nprocedure counted filter lua \"input() + frame\"\nfilter a.position.x counted\n"
      "set a.color = \"hsv(0.5, 1, 1)\"\ncreate b box color=hsv(0.5 1 1)\n");
  expect_numbers(f, {{"a.position.x", "16f", {16}}, {"a.color", "1f", f.numbers("b.color", "1f")}});
}

TEST(Computed, WhatIsReadOnceIsNot) {
  for (const auto& [line, words] : std::initializer_list<std::pair<const char*, const char*>>{
           {"create m text\nset m.tex = \"'x'\"", "type 2:13 \"'x'\""},
           {"layer sway add\nset sway.mode = \"'mix'\"", "type 2:17 \"'mix'\""},
           {"create m trace\nset m.within = \"'m'\"", "type 2:16 \"'m'\""},
           {"create m box\nset m.motion = \"'m'\"", "type 2:5 m.motion"},
           {"create m polyline\nset m.points = 3", "syntax 2:16 3"}}) {
    const auto all = all_told(read(line));
    ASSERT_EQ(all.size(), 1u) << line;
    EXPECT_EQ(all[0], words) << line;
  }
  EXPECT_NE(problem("create m polyline\nset m.points = \"vec(1, 2, 3)\"\n").find("list of points"), std::string::npos);
}

// What a procedure makes of points is written and read back; bake makes plain events of it.
TEST(Computed, PointsAreWrittenAndBaked) {
  const char* film =
      "rate 24\ncreate w polyline\nset w.points = \"{vec(0, 0), vec(1 + t, 0)}\"\nset w.material = \"'glow'\"\n";
  const Document d = read(film).document;
  EXPECT_EQ(read(write(d)).document, d);
  const LoadedFilm baked(std::string(film) + "bake w.points 1f..25f every 12f\n");
  EXPECT_EQ((*points(baked, "w.points", "13f"))[1].x, 1.5);
  EXPECT_EQ((*points(baked, "w.points", "19f"))[1].x, 1.75);
}

}  // namespace
}  // namespace betwixt

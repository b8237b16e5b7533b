// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares transforms, motions, lists, traces and files that code computes with films that write them.
#include <cmath>

#include "betwixt/picture.h"
#include "scene/document.h"
#include "support/folder.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

void expect_same_places(const LoadedFilm& a, const LoadedFilm& b, std::string_view object) {
  for (const char* time : {"1f", "7f", "13.5f", "24f", "25f", "33f", "60f"}) {
    const Mat4 is = *std::get<Matrix>(a.read(std::string(object) + ".world", time));
    const Mat4 wanted = *std::get<Matrix>(b.read(std::string(object) + ".world", time));
    const Frame frame = a.frame(time);
    EXPECT_TRUE(frame.problems.empty()) << frame.problems[0];
    const auto item = std::find_if(frame.items.begin(), frame.items.end(),
                                   [&](const Item& i) { return i.id == a.loaded.document.find(object); });
    ASSERT_NE(item, frame.items.end());
    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_NEAR(is.m[i], wanted.m[i], 1e-12) << time << " " << i;
      EXPECT_NEAR(item->world.m[i], wanted.m[i], 1e-12) << time << " " << i;
    }
  }
}

// shows: G54 G15
TEST(ComputedLists, OfEnvironments) {
  const std::string film =
      "rate 24\nanimate wind every 1t by translate(0.1 0 0)\nanimate rise every 1t by translate(0 0.1 0)\n"
      "create a box\ncreate b sphere position=(0 0 2)\ncouple b to a\n";
  for (const std::string f : {"environments", "drive"}) {
    const LoadedFilm code(film + "set a." + f + " = \"t < 1 and 'wind' or {'wind', 'rise'}\"\n");
    const LoadedFilm rows(film + "a." + f + "\n  1f (wind)\n  25f (wind rise)\n");
    expect_same_places(code, rows, "a");
    expect_same_places(code, rows, "b");
  }
}

// A list may read where other objects are.
TEST(ComputedLists, OfEnvironmentsReadOtherPlaces) {
  const LoadedFilm s(
      "rate 24\nanimate wind every 1t by translate(0.1 0 0)\ncreate gate box\n"
      "create eye camera position=(0 0 9) look-at=gate\ngate.position\n  1f (0 0 0) linear\n  49f (0 4 0)\ncreate a "
      "box\n"
      "set a.environments = \"value('eye.world') and value('gate.world.y') > 1 and 'wind' or 'none'\"\n");
  EXPECT_TRUE(s.frame("25f").problems.empty());
  expect_place(s, "a", "10f", {0, 0, 0});
  EXPECT_GT(s.numbers("gate.position", "25f")[1], 1);
  EXPECT_GT(place(s, "a", "25f").x, 1);
}

TEST(ComputedLists, TransformsAreMatricesOfCode) {
  const std::string film = "rate 24\ncreate a box position=(1 2 3)\n";
  const LoadedFilm code(film +
                        "set a.transform = \"matrix(vec(1, 0, 2), euler(0, 0, pi / 6), vec(2, 1, 1)) * matrix(nil, "
                        "nil, 0.5)\"\n");
  const LoadedFilm rows(film + "set a.transform translate(1 0 2) rotate(30deg, z) scale(2 1 1) scale(0.5)\n");
  expect_same_places(code, rows, "a");
  const LoadedFilm both(
      "create a box position=(1 2 3) rotation=euler(20deg 30deg 40deg) scale=(1 2 3)\ncreate b sphere\n"
      "set b.position = \"inverse(value('a.world')) * (value('a.world') * vec(4, 5, 6))\"\n"
      "create c box\nset c.rotation = \"inverse(axis(0, 0, 1, 0.5)) * axis(0, 0, 1, 0.75)\"\n");
  expect_numbers(both, "b.position", "1f", {4, 5, 6}, 1e-12);
  expect_numbers(both, "c.rotation", "1f", {std::cos(0.125), 0, 0, std::sin(0.125)}, 1e-12);
}

// shows: G54
TEST(ComputedLists, AMotionIsComputedWhenItBegins) {
  const std::string film =
      "rate 24\ncreate goal sphere\ngoal.position\n  1f (0 1 0) linear\n  49f (4 1 0)\ncreate a box\n"
      "at 1f..25f a.motion T(1 0) R(90deg)\n";
  const LoadedFilm code(film +
                        "at 25f..49f a.motion = \"local p = value('goal.position') return string.format('T(%.17g "
                        "%.17g) S(2 2 2)', p.x, p.y)\"\n");
  const LoadedFilm rows(film + "at 25f..49f a.motion T(2 1) S(2 2 2)\n");
  expect_same_places(code, rows, "a");
  EXPECT_EQ(code.program.motions(code.loaded.document.find("a")), rows.program.motions(rows.loaded.document.find("a")));
  const LoadedFilm again(write(code.loaded.document));
  expect_same_places(again, rows, "a");
}

TEST(ComputedLists, ATraceFollowsTheObjectThatCodeNames) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\na.position\n  1f (0 0 0) linear\n  49f (4 0 0)\ncreate b sphere position=(2 5 0)\n"
      "create line trace of=a\nset line.of = \"t < 1 and 'a' or 'b'\"\n");
  const Frame f = s.frame("49f");
  EXPECT_TRUE(f.problems.empty());
  const auto item = std::find_if(f.items.begin(), f.items.end(),
                                 [&](const Item& i) { return i.id == s.loaded.document.find("line"); });
  ASSERT_NE(item, f.items.end());
  const std::vector<Vec3>& points = *item->shape->points;
  ASSERT_GT(points.size(), 2u);
  EXPECT_EQ(points.front(), Vec3{});
  EXPECT_EQ(points.back(), (Vec3{2, 5, 0}));
  EXPECT_TRUE(std::any_of(points.begin(), points.end(), [](Vec3 p) { return p.x > 1.9 && p.y == 0; }));
}

// While code names no object, the line stays where it was, whatever was asked before.
TEST(ComputedLists, ATraceWaitsWhileCodeNamesNoObject) {
  const std::string film =
      "rate 24\ncreate a sphere\na.position\n  1f (0 0 0) linear\n  97f (8 0 0)\ncreate line trace of=a last=0.5s\n"
      "set line.of = \"(t < 1 or t > 2) and 'a' or 'none'\"\n";
  const auto line = [](const LoadedFilm& s, const char* time) {
    for (const Item& i : s.frame(time).items)
      if (i.id == s.loaded.document.find("line")) return *i.shape->points;
    return std::vector<Vec3>();
  };
  const LoadedFilm fresh(film), used(film);
  (void)line(used, "97f");
  for (const char* time : {"37f", "40f", "48f", "61f"}) EXPECT_EQ(line(fresh, time), line(used, time)) << time;
  for (const Vec3 p : line(fresh, "40f")) EXPECT_NEAR(p.x, 2, 0.1);
}

// The pictures that code names in quotes are read with the script: single names, and all numbers of a pattern.
TEST(ComputedLists, OfPicturesAndFonts) {
  const Folder folder;
  for (const char* name : {"a.png", "walk01.png", "walk02.png"})
    ASSERT_TRUE(write_png(folder / name, Picture{1, 1, {1, 2, 3, 255}}));
  const auto load = [&](const std::string& text) { return load_file(folder.put("film.bx", text)); };
  const Loaded loaded = load(
      "rate 24\ncreate r rectangle\nset r.texture = \"t < 1 and 'a.png' or string.format('walk%02d.png', 1 + floor(t) "
      "% "
      "2)\"\ncreate w text text=\"hi\"\nset w.font = \"t < 1 and 'DejaVu Sans' or 'DejaVu Serif'\"\n");
  ASSERT_FALSE(has_errors(loaded.diagnostics)) << said(loaded.diagnostics);
  EXPECT_EQ(loaded.document.scene().pictures->size(), 3u);
  const Program program = Program::compile(loaded.document);
  const auto texture = [&](double seconds) {
    const Frame f = program.frame(from_seconds(seconds));
    EXPECT_TRUE(f.problems.empty()) << f.problems[0];
    return f.items[0].texture;
  };
  const auto& pictures = *loaded.document.scene().pictures;
  EXPECT_EQ(texture(0.5), pictures.at("a.png"));
  EXPECT_EQ(texture(1.5), pictures.at("walk02.png"));
  EXPECT_EQ(texture(2.5), pictures.at("walk01.png"));
  const Loaded unread = load("create r rectangle\nset r.texture = \"'b' .. '.png'\"\n");
  const Frame f = Program::compile(unread.document).frame({});
  ASSERT_FALSE(f.problems.empty());
  EXPECT_NE(f.problems[0].find("the film has not read the picture 'b.png': write its name in quotes"),
            std::string::npos);
}

TEST(ComputedLists, OfObstacles) {
  const LoadedFilm s(
      "rate 24\ncreate wall box size=(1 4 4) position=(4 0 0)\ncreate ball sphere radius=0.5\nball.position\n  1f (0 0 "
      "0) linear\n  49f (8 0 0)\nset ball.obstacles = \"t < 1.5 and 'wall' or {}\"\n");
  expect_numbers(s, "ball.position", "1.4s", {3, 0, 0}, 1e-7);
  expect_numbers(s, "ball.position", "1.6s", {6.4, 0, 0}, 1e-9);
}

TEST(ComputedLists, MistakesAreNamed) {
  const auto problem = [](const std::string& script) {
    const Frame f = LoadedFilm(script).frame("5f");
    return f.problems.empty() ? "" : f.problems[0];
  };
  EXPECT_NE(
      problem("create a box\nset a.transform = \"vec(1, 2, 3)\"\n").find("it must return a transform, not a vector"),
      std::string::npos);
  EXPECT_NE(problem("create a box\nset a.transform = \"matrix({1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,2})\"\n")
                .find("the last row of its matrix is not 0 0 0 1"),
            std::string::npos);
  EXPECT_NE(problem("create a box\nat 1f..9f a.motion = \"'X(1)'\"\n").find("\"X(1)\" is not a motion: "),
            std::string::npos);
  EXPECT_NE(problem("create a box\nset a.environments = \"3\"\n").find("it must return a list of names, not a number"),
            std::string::npos);
  EXPECT_NE(problem("create a sphere\nset a.radius = \"matrix()\"\n").find("it must return a number, not a matrix"),
            std::string::npos);
  const auto error = [](const std::string& script) { return said(read(script).diagnostics); };
  EXPECT_NE(error("create t text\nset t.tex = \"'x'\"\n").find("tex cannot be computed"), std::string::npos);
  EXPECT_NE(error("create a box\nbake a.motion 1f..9f\n").find("test.bx:2:"), std::string::npos);
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests names that the author defines, and patterns in them.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// shows: G64 G65 G66 G67
TEST(Names, PatternsAndAliases) {
  const LoadedFilm s(
      "create wheel{1..3} sphere\ncreate car group\ncreate car/wheel1 sphere\nalias wheels = wheel* spare\n"
      "set wheel*.color red\ncreate wheel4 sphere\nset wheels.radius 5\nset wheel[12].shininess 0.5\n"
      "set car/*.transparency 0.5\nset wheel?.position.{x,y} 3\ncreate spare sphere\nset wheels.pivot (1 1 1)\n");
  EXPECT_FALSE(has_errors(s.loaded.diagnostics));
  expect_numbers(s, {{"wheel3.color", "1f", {1, 0, 0}},
                     {"wheel4.color", "1f", {1, 1, 1}},      // made after
                     {"car/wheel1.color", "1f", {1, 1, 1}},  // * does not cross /
                     {"wheel4.radius", "1f", {5}},           // read at each use
                     {"spare.radius", "1f", {1}},
                     {"spare.pivot", "1f", {1, 1, 1}},
                     {"wheel2.shininess", "1f", {0.5}},
                     {"wheel3.shininess", "1f", {0}},
                     {"car/wheel1.transparency", "1f", {0.5}},
                     {"wheel1.position", "1f", {3, 3, 0}}});
  const auto nothing = read("set nobody*.color red\nnobody*.color\n  1f red\n  what ever\nat 3f nobody?.color blue\n");
  EXPECT_FALSE(has_errors(nothing.diagnostics)) << said(nothing.diagnostics);
  ASSERT_FALSE(nothing.diagnostics.empty());
  EXPECT_EQ(told(nothing.diagnostics[0]), "notice name 1:5 nobody*");
}

TEST(Names, AliasesThatGoRoundOrMultiplyEnd) {
  std::string text = "create ball sphere\nalias a = b ball\nalias b = a\nset a.radius 2\n";
  for (int i = 0; i < 60; ++i) text += fmt::format("alias t{} = t{} t{}\n", i, i + 1, i + 1);
  text += "alias t60 = ball\nset t0.radius 3\n";
  expect_numbers(LoadedFilm(text), "ball.radius", "1f", {3});
  std::string deep = "create ball sphere\n";
  for (int i = 0; i < 100'000; ++i) deep += fmt::format("alias t{} = t{}\n", i, i + 1);
  deep += "alias t100000 = ball\nset t0.radius 3\n";
  expect_numbers(LoadedFilm(deep), "ball.radius", "1f", {3});
}

// shows: G14
TEST(Names, Define) {
  const LoadedFilm s(
      "define heat number 20\ndefine wind vector\ndefine warmth color red\ndefine angle2 angle 90deg\n"
      "define lit boolean on\ndefine label text \"x\"\ndefine turn orientation\n"
      "create b sphere heat=30\ncreate c sphere\nb.wind\n 1f (0 0 0) linear\n 3f (2 4 6)\n"
      "at 2f b.wind.y 9\nset c.lit off\n");
  EXPECT_EQ(s.text("c.label", "1f"), "x");
  expect_numbers(s, {{"b.heat", "1f", {30}},
                     {"c.heat", "1f", {20}},
                     {"b.wind", "2f", {1, 9, 3}},
                     {"c.warmth", "1f", {1, 0, 0}},
                     {"b.lit", "1f", {1}},
                     {"c.lit", "1f", {0}}});
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests contacts of named objects, for hosts and for procedures.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// The ball's right side is at 1 + 4t, the wall's left one at 4.5: from 0.875 s, frame 22, on.
constexpr const char* film =
    "rate 24\ncreate ball sphere\ncreate wall box position=(5 0 0)\ncreate other box position=(5.5 0.5 0)\n"
    "create eye camera position=(0 0 10) height=9\ndefine n number\n"
    "ball.position\n  1f (0 0 0) linear\n  49f (8 0 0)\n";

// shows: C154
TEST(Contacts, AreAskedForByNameAndNotSet) {
  const LoadedFilm s(film);
  const auto names = [&](const char* target, const char* when) { return std::get<Names>(s.read(target, when)); };
  using List = std::vector<std::string>;
  EXPECT_EQ(names("wall.touching", "21f"), Names(List{"other"}));
  EXPECT_EQ(names("wall.touching", "22f"), Names(List{"ball", "other"}));
  EXPECT_EQ(names("ball.touching", "21f"), Names());
  // 16 m wide: its left side leaves at x = 8, when its middle is at 9, which it never reaches.
  EXPECT_EQ(s.read("ball.in-view", "49f"), Value(true));
  const auto bad =
      all_told(read(std::string(film) + "set ball.touching (wall)\nset ball.in-view on\nset eye.touching 1\n"));
  ASSERT_EQ(bad.size(), 3U);
  EXPECT_EQ(bad[0], "type 10:10 touching");
  EXPECT_EQ(bad[1], "type 11:10 in-view");
}

// shows: C151 C154
TEST(Contacts, ProceduresAsk) {
  const LoadedFilm s(
      std::string(film) +
      "set ball.color = \"touching('ball', 'wall') and rgb(1, 0, 0) or rgb(0, 1, 0)\"\n"
      "at 1f wall.n = \"#touching('wall')\"\nat 1f other.n = \"#touching('wall', t + 1)\"\n"
      "at 1f ball.n = \"value('.in-view') and 1 or 0\"\n"
      "at 1f eye.n = \"touching('wall', 'ball', 0) and 1 or touching('other', 'wall', 0) and 2 or 3\"\n");
  expect_numbers(s, {{"ball.color", "21f", {0, 1, 0}},
                     {"ball.color", "22f", {1, 0, 0}},
                     {"wall.n", "21f", {1}},
                     {"wall.n", "22f", {2}},
                     {"other.n", "1f", {2}},  // a second later
                     {"ball.n", "1f", {1}},
                     {"eye.n", "40f", {2}}});
  EXPECT_TRUE(s.frame("22f").problems.empty());
  const LoadedFilm wrong(std::string(film) + "at 1f ball.n = \"#touching('eye')\"\n");
  ASSERT_EQ(wrong.frame("1f").problems.size(), 1U);
  EXPECT_NE(wrong.frame("1f").problems[0].find("there is no function 'touching'"), std::string::npos);
}

TEST(Contacts, AProcedureThatMovesWhatItAsksAboutIsACircle) {
  // It steps back to y = 3 where it touches. Inside the circle it is where it is set, so it always touches.
  const LoadedFilm s(
      "rate 24\ncreate a sphere\ncreate b sphere position=(1 0 0)\ndefine n number\n"
      "at 1f a.position = \"touching('a', 'b') and vec(0, 3, 0) or vec(0, 0, 0)\"\nat 1f b.n = \"#touching('b')\"\n");
  const Frame f = s.frame("2f");
  EXPECT_EQ(translation_of(f.items[0].world), (Vec3{0, 3, 0}));
  ASSERT_EQ(f.problems.size(), 1U);
  EXPECT_TRUE(f.problems[0].starts_with("a.position ")) << f.problems[0];
  // From outside it is where the procedure has put it.
  expect_numbers(s, "b.n", "2f", {0});
}

TEST(Contacts, WithoutACameraAllThatIsDrawnIsInView) {
  // The film's own camera looks at all there is, procedures too: asking it would not end.
  const LoadedFilm s(
      "rate 24\ncreate a sphere\nset a.position = \"vec(value('a.in-view') and 5 or 0, 0, 0)\"\n"
      "create b sphere display=off\n");
  EXPECT_EQ(translation_of(s.frame("2f").items[0].world), (Vec3{5, 0, 0}));
  EXPECT_EQ(s.read("a.in-view", "1f"), Value(true));
  EXPECT_EQ(s.read("b.in-view", "1f"), Value(false));
}

}  // namespace
}  // namespace betwixt

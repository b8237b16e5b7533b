// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares tweens, the author's twerpers that return values, with closed forms.
#include <cmath>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr const char* arc =
    "procedure arc tween lua \"from + (to - from) * u + vec(0, 4 * u * (1 - u), 0)\"\ncreate ball sphere\n";

// shows: G50 G51 S3
TEST(Tweens, ReturnTheValueItself) {
  const LoadedFilm s(std::string("rate 24\n") + arc +
                     "ball.position\n  1f (-2 0 0) arc\n  25f (2 1 0) linear\n  49f (2 5 0)\n");
  for (const double u : {0.0, 0.125, 0.5, 0.75}) {
    const std::string time = std::to_string(1 + 24 * u) + "f";
    expect_numbers(s, "ball.position", time, {-2 + 4 * u, u + 4 * u * (1 - u), 0}, 1e-12);
  }
  expect_numbers(s, {{"ball.position", "25f", {2, 1, 0}}, {"ball.position", "37f", {2, 3, 0}}});
  const Frame f = s.frame("13f");
  EXPECT_TRUE(f.problems.empty());
  EXPECT_NEAR(translation_of(f.items[0].world).y, 1.5, 1e-12);
}

// shows: G50
TEST(Tweens, WorkForEveryTypeThatCodeCanCompute) {
  const LoadedFilm s(
      "rate 24\nprocedure typed tween lua \"to:sub(1, floor(u * #to))\"\n"
      "procedure late tween lua \"u < 0.75 and from or to\"\ncreate a text text=\"\"\ncreate b box\ncreate c sphere\n"
      "create w polyline\n"
      "a.text\n  1f \"\" typed\n  25f \"twelve chars\"\n"
      "b.shadow\n  1f on late\n  25f off\nb.material\n  1f matte late\n  25f metal\n"
      "b.geometry\n  1f none late\n  25f shape(c)\nb.rotation\n  1f euler(0 0 0) late\n  25f euler(0 0 1turn)\n"
      "b.look-at\n  1f c late\n  25f (1 2 3)\nw.points\n  1f ((0 0) (1 1)) late\n  25f ((2 2) (3 3) (4 4))\n"
      "b.color\n  1f rgb(1 0 0) late\n  25f rgb(0 1 0)\n");
  EXPECT_EQ(s.text("a.text", "13f"), "twelve");
  EXPECT_EQ(s.text("a.text", "24f"), "twelve char");
  EXPECT_EQ(s.text("b.material", "18f"), "matte");
  EXPECT_EQ(s.text("b.material", "19f"), "metal");
  EXPECT_EQ(s.read("b.shadow", "18f"), Value(true));
  EXPECT_EQ(s.read("b.shadow", "19f"), Value(false));
  EXPECT_EQ(s.read("b.geometry", "18f"), Value(ObjectId{}));
  EXPECT_EQ(s.read("b.geometry", "19f"), Value(s.loaded.document.find("c")));
  EXPECT_EQ(s.read("b.look-at", "18f"), Value(s.loaded.document.find("c")));
  EXPECT_EQ(s.read("b.look-at", "19f"), Value(Vec3{1, 2, 3}));
  EXPECT_EQ(s.read("b.color", "19f"), Value(Color{0, 1, 0}));
  EXPECT_EQ(s.read("b.rotation", "19f"), Value(Angles{{0, 0, 2 * pi}}));
  EXPECT_EQ(std::get<Points>(s.read("w.points", "18f"))->size(), 2u);
  EXPECT_EQ(std::get<Points>(s.read("w.points", "19f"))->size(), 3u);
  EXPECT_TRUE(s.frame("13f").problems.empty());
}

// The events around it: those before and behind, cuts, the time between, and the eases.
TEST(Tweens, SeeTheEventsAroundThem) {
  const LoadedFilm s(
      "rate 24\ndefine n number\nprocedure sum tween lua \"(before or -100) + 10 * from + 100 * to + 1000 * (after or "
      "-1) + duration\"\nprocedure eased tween lua \"u\"\ncreate a sphere\n"
      "a.n\n  1f 1 sum\n  25f 2 sum\n  73f 3 cut 5 sum\n  97f 4\n"
      "create b sphere\nb.n\n  1f 0 eased ease-out=0.5s\n  25f 1\n");
  expect_numbers(s, {{"a.n", "13f", {-100 + 10 + 200 + 3000 + 1}},
                     {"a.n", "49f", {1 + 20 + 300 + 4000 + 2}},
                     {"a.n", "85f", {2 + 50 + 400 - 1000 + 1}},
                     {"a.n", "200f", {4}}});
  // An ease over the first half is the parabola that has the slope of the rest at its end.
  const double slope = 1 / 0.75;
  expect_numbers(s, {{"b.n", "13f", {slope * 0.25}}, {"b.n", "7f", {slope * 0.0625}}, {"b.n", "19f", {slope * 0.5}}});
}

// Where no tween is in force, the track is what it is without one: its splines and what extends it too.
TEST(Tweens, LeaveTheOtherSegmentsAlone) {
  const std::string rows = "  1f 1 smooth\n  13f 3 smooth\n  25f -2 W\n  49f 4 linear\n  73f 5 smooth\n  97f 1\n";
  const auto film = [&](std::string_view twerper) {
    std::string text =
        "rate 24\ndefine n number\nprocedure way tween lua \"from + (to - from) * u\"\n"
        "create a sphere\na.n\n" +
        rows + "extend a.n linear after\n";
    return LoadedFilm(text.replace(text.find('W'), 1, twerper));
  };
  const LoadedFilm plain = film("linear"), mine = film("way");
  for (double f = -10; f < 130; f += 3.7) {
    const std::string time = std::to_string(f) + "f";
    EXPECT_NEAR(std::get<double>(mine.read("a.n", time)), std::get<double>(plain.read("a.n", time)), 1e-12) << time;
  }
  EXPECT_EQ(plain.read("a.n", "120f"), mine.read("a.n", "120f"));
}

TEST(Tweens, RepeatWithTheirTrack) {
  const LoadedFilm s(std::string("rate 24\n") + arc +
                     "ball.position\n  1f (0 0 0) arc\n  25f (2 0 0)\nextend ball.position bounce after\n"
                     "create c text text=\"\"\nprocedure typed tween lua \"to:sub(1, floor(u * #to))\"\n"
                     "c.text\n  1f \"\" typed\n  25f \"abcd\"\nextend c.text cycle after\n");
  expect_numbers(s, {{"ball.position", "31f", {1.5, 0.75, 0}}, {"ball.position", "61f", {1, 1, 0}}});
  EXPECT_EQ(s.text("c.text", "37f"), "ab");
}

// A row with `keep` changes the twerper only.
TEST(Tweens, StartAndEndAtRowsThatKeepTheValue) {
  const LoadedFilm s(std::string("rate 24\n") + arc +
                     "ball.position\n  1f (0 0 0) linear\n  25f keep arc\n  49f (4 0 0)\n");
  expect_numbers(s, {{"ball.position", "13f", {1, 0, 0}}, {"ball.position", "37f", {3, 1, 0}}});
}

// A component's tween gets numbers. A global twerper of the track counts before that of each event.
TEST(Tweens, OfComponentsAndWholeTracks) {
  const LoadedFilm s(
      "rate 24\nprocedure half tween lua \"(from + to) / 2\"\ncreate a sphere\na.position.y\n  1f 1 half\n  25f 4\n"
      "create b sphere\nb.radius\n  1f 1 linear\n  25f 4\ntwerper b.radius half\n");
  expect_numbers(s, {{"a.position", "2f", {0, 2.5, 0}}, {"b.radius", "24f", {2.5}}});
}

TEST(Tweens, CanReadOtherValues) {
  const LoadedFilm s(
      "rate 24\nprocedure over tween lua \"local p = mix(from, to, u) return vec(p.x, max(p.y, "
      "value('hill.position.y')),"
      " 0)\"\ncreate hill box\nhill.position\n  1f (0 1 0) linear\n  25f (0 3 0)\ncreate a sphere\n"
      "a.position\n  1f (0 0 0) over\n  25f (8 0 0)\n");
  expect_numbers(s, "a.position", "13f", {4, 2, 0});
}

TEST(Tweens, AreWrittenAndReadAgain) {
  const LoadedFilm s(std::string("rate 24\n") + arc + "ball.position\n  1f (0 0 0) arc ease-out=2f\n  25f (2 0 0)\n");
  const LoadedFilm again(write(s.loaded.document));
  EXPECT_EQ(again.read("ball.position", "9f"), s.read("ball.position", "9f"));
}

// A tween that fails reports its line; a track of numbers is then linear, others hold.
TEST(Tweens, ThatFailAreReportedAndLeaveALinearSegment) {
  const auto said = [](const std::string& code) {
    const LoadedFilm s("rate 24\nprocedure bad tween lua \"" + code +
                       "\"\ncreate a sphere\na.radius\n  1f 1 bad\n  25f 3\n");
    expect_numbers(s, "a.radius", "13f", {2});
    const Frame f = s.frame("13f");
    return f.problems.empty() ? "" : f.problems[0];
  };
  EXPECT_NE(said("'x'").find("a text"), std::string::npos) << said("'x'");
  EXPECT_NE(said("1 / 0").find("not finite"), std::string::npos);
  EXPECT_NE(said("nosuch + 1").find("(global 'nosuch')"), std::string::npos);
  EXPECT_NE(said("while true do end").find("it took more than"), std::string::npos);
}

TEST(Tweens, ThatReadThemselvesAreACircle) {
  const LoadedFilm s(
      "rate 24\nprocedure me tween lua \"value('a.radius') + 1\"\ncreate a sphere\na.radius\n  1f 1 me\n  25f 3\n");
  ASSERT_FALSE(s.frame("13f").problems.empty());
  EXPECT_NE(s.frame("13f").problems[0].find("depends on itself"), std::string::npos);
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Live input: what controls say turns what their dials name, now and for all times, or recorded as events.
#include "editor/controls.h"

#include <limits>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr std::string_view film =
    "rate 24\nrange 1f 48f\ncreate ball sphere\ncreate eye camera\ncreate word text text=\"a\"\n"
    "ball.position\n  1f (0 0 0) linear\n  25f (4 8 0) linear\n";

Result<Document> say(const Document& d, std::string_view address, std::vector<double> numbers, Time now = {}) {
  return turn(d, address, numbers, nullptr, now);
}
Document said_or_fail(const Document& d, std::string_view address, std::vector<double> numbers, Time now = {}) {
  Result<Document> r = say(d, address, std::move(numbers), now);
  if (r) return *r;
  ADD_FAILURE() << r.error().message;
  return d;
}
Document film_with(const std::string& more) { return LoadedFilm(std::string(film) + more).loaded.document; }
std::vector<double> numbers_at(const Document& d, std::string_view target, std::string_view time) {
  return numbers(Program::compile(d).read(find_targets(target, d)->front(), *parse_time(time, d)));
}
std::string message(const Result<Document>& r) { return r ? "" : r.error().message; }
using Numbers = std::vector<double>;

// shows: G57
TEST(Dials, TurnNumbersVectorsColorsTextsAndSwitches) {
  const Document d = film_with(
      "dial /r to ball.radius\ndial /p to ball.position\ndial /c to ball.color\ndial /w to word.text\n"
      "dial /on to ball.display\ndial /t to ball.rotation\n");
  EXPECT_EQ(numbers_at(said_or_fail(d, "/r", {2.5}), "ball.radius", "7f"), Numbers{2.5});
  // The track gives way; the document that was is as it was.
  const Document moved = said_or_fail(d, "/p", {1, 2, 3});
  EXPECT_EQ(numbers_at(moved, "ball.position", "1f"), (Numbers{1, 2, 3}));
  EXPECT_EQ(numbers_at(moved, "ball.position", "25f"), (Numbers{1, 2, 3}));
  EXPECT_EQ(numbers_at(d, "ball.position", "25f"), (Numbers{4, 8, 0}));
  EXPECT_EQ(numbers_at(said_or_fail(d, "/c", {0.25, 0.5, 1}), "ball.color", "1f"), (Numbers{0.25, 0.5, 1}));
  EXPECT_EQ(numbers_at(said_or_fail(d, "/on", {0}), "ball.display", "1f"), Numbers{0});
  EXPECT_EQ(numbers_at(said_or_fail(d, "/on", {1}), "ball.display", "1f"), Numbers{1});
  EXPECT_NEAR(numbers_at(said_or_fail(d, "/t", {0, 90, 0}), "ball.rotation", "1f")[1], pi / 2, 1e-15);
  const std::string text = "ein \"Wört\"\nzwei";
  const Result<Document> worded = turn(d, "/w", {}, &text, {});
  ASSERT_TRUE(worded) << worded.error().message;
  const auto read = Program::compile(*worded).read(find_targets("word.text", *worded)->front(), {});
  EXPECT_EQ(**std::get_if<Text>(&read), text);
}

// shows: G57
TEST(Dials, MapTheirOwnRangeAndStayWithinIt) {
  const Document d = film_with(
      "dial /f to ball.radius from 0 10 to 0.5 2.5\ndial /p to ball.position from -1 1 to (0 0 0) (2 4 8)\n"
      "dial /down to ball.transparency from 1 0 to 0 1\n");
  for (const auto& [in, out] :
       std::vector<std::pair<double, double>>{{0, 0.5}, {5, 1.5}, {10, 2.5}, {-3, 0.5}, {1e9, 2.5}})
    EXPECT_DOUBLE_EQ(numbers_at(said_or_fail(d, "/f", {in}), "ball.radius", "3f")[0], out) << in;
  EXPECT_EQ(numbers_at(said_or_fail(d, "/p", {0}), "ball.position", "3f"), (Numbers{1, 2, 4}));
  EXPECT_DOUBLE_EQ(numbers_at(said_or_fail(d, "/down", {0.25}), "ball.transparency", "3f")[0], 0.75);
}

// shows: G57
TEST(Dials, AComponentLeavesTheOthersTheirTracks) {
  const Document d = said_or_fail(film_with("dial /y to ball.position.y\n"), "/y", {7});
  EXPECT_EQ(numbers_at(d, "ball.position", "1f"), (Numbers{0, 7, 0}));
  EXPECT_EQ(numbers_at(d, "ball.position", "25f"), (Numbers{4, 7, 0}));
}

// shows: G57
TEST(Dials, VelocitiesAndFiltersGiveWayToo) {
  const Document d =
      film_with("ball.position.velocity\n  30f (9 9 9)\nfilter ball.position delay by=2f\ndial /p to ball.position\n");
  EXPECT_EQ(numbers_at(said_or_fail(d, "/p", {1, 1, 1}), "ball.position", "40f"), (Numbers{1, 1, 1}));
}

// shows: G57
TEST(Dials, AreReassigned) {
  const Document d = film_with("dial /f to ball.radius\ndial /f to ball.transparency\n");
  const Document turned = said_or_fail(d, "/f", {0.5});
  EXPECT_EQ(numbers_at(turned, "ball.radius", "1f"), numbers_at(d, "ball.radius", "1f"));
  EXPECT_EQ(numbers_at(turned, "ball.transparency", "1f"), Numbers{0.5});
  EXPECT_EQ(message(say(film_with("dial /f to ball.radius\ndial /f to none\n"), "/f", {1})),
            "no dial has the address /f");
}

// shows: G57
TEST(Dials, RecordWhatWasSentAsEvents) {
  Document d = film_with("dial /r to ball.radius\ndial /y to ball.position.y from 0 1 to 0 10\nrecord on\n");
  const auto at = [&](std::string_view time) { return *parse_time(time, d); };
  for (const auto& [time, value] :
       std::vector<std::pair<std::string, double>>{{"3f", 0.5}, {"9f", 2}, {"9f", 3}, {"0.777s", 1.25}})
    d = said_or_fail(d, "/r", {value}, at(time));
  d = said_or_fail(d, "/y", {0.5}, at("13f"));
  // Events at the times of the messages, the last of one time; between them straight lines; x goes on as it did.
  const LoadedFilm again(write(d));
  EXPECT_EQ(again.loaded.document, d);
  expect_numbers(again, "ball.radius", "3f", {0.5});
  expect_numbers(again, "ball.radius", "6f", {1.75});
  expect_numbers(again, "ball.radius", "9f", {3});
  expect_numbers(again, "ball.radius", "0.777s", {1.25});
  expect_numbers(again, "ball.radius", "48f", {1.25});
  expect_numbers(again, "ball.position", "13f", {2, 5, 0});
  expect_numbers(again, "ball.position", "7f", {1, 2.5, 0});
  const std::string said = write(d);
  EXPECT_NE(said.find("ball.radius\n  3f 0.5 linear\n  9f 3 linear\n  0.777s 1.25 linear\n"), std::string::npos)
      << said;
}

// shows: G57
TEST(Dials, WhatIsBeyondThePossibleBecomesTheNearest) {
  const Document d = film_with("dial /r to ball.radius\nrecord on\n");
  const Document low = said_or_fail(d, "/r", {-5}, *parse_time("3f", d));
  EXPECT_TRUE(LoadedFilm(write(low)).loaded.document == low);
  EXPECT_GE(numbers_at(low, "ball.radius", "3f")[0], 0);
}

// shows: G57
TEST(Dials, RefuseInWords) {
  const Document d = film_with(
      "dial /fader/1 to ball.radius\ndial /p to ball.position\ndial /w to word.text\ndial /m to eye.look-at.x\n");
  const Result<Document> near = say(d, "/fader/2", {1});
  EXPECT_EQ(message(near), "no dial has the address /fader/2");
  EXPECT_EQ(near.error().hint, "did you mean '/fader/1'?");
  EXPECT_EQ(message(say(d, "/fader/1", {1, 2})), "/fader/1: radius wants one number, not two numbers");
  EXPECT_EQ(message(say(d, "/p", {1, 2})), "/p: position wants three numbers, not two numbers");
  EXPECT_EQ(message(say(d, "/p", {})), "/p: position wants three numbers, not no number");
  EXPECT_EQ(message(say(d, "/p", {1, std::nan(""), 2})), "/p: this is no number");
  EXPECT_EQ(message(say(d, "/fader/1", {std::numeric_limits<double>::infinity()})), "/fader/1: this is no number");
  EXPECT_EQ(message(say(d, "/w", {1})), "/w: text takes a text");
  const std::string text = "x", broken = "a\xff", bell = "a\ab";
  EXPECT_EQ(message(turn(d, "/p", {}, &text, {})), "/p: position wants three numbers, not a text");
  for (const std::string* t : {&broken, &bell})
    EXPECT_EQ(message(turn(d, "/w", {}, t, {})), "/w: this is not a text: it is not UTF-8, or has control characters");
  EXPECT_EQ(message(say(film_with("set ball.rotation axis(0 1 0 30deg)\ndial /x to ball.rotation.x\n"), "/x", {1})),
            "/x: rotation is given as a whole here; it has no separate components");
}

}  // namespace
}  // namespace betwixt

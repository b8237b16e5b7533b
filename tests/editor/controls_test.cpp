// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests live input: a control changes the values to which its dials lead, for all times or recorded as events.
#include "editor/controls.h"

#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "support/loaded_film.h"
#include "support/told.h"

namespace betwixt {
namespace {

constexpr std::string_view film =
    "rate 24\nrange 1f 48f\ncreate ball sphere\ncreate eye camera\ncreate word text text=\"a\"\n"
    "ball.position\n  1f (0 0 0) linear\n  25f (4 8 0) linear\n";

Result<Document> say(const Document& d, std::string_view address, std::vector<double> numbers) {
  return turn(d, address, numbers, nullptr);
}
Document said_or_fail(const Document& d, std::string_view address, std::vector<double> numbers) {
  Result<Document> r = say(d, address, std::move(numbers));
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
  const Result<Document> worded = turn(d, "/w", {}, &text);
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
  const Result<Document> none = say(film_with("dial /f to ball.radius\ndial /f to none\n"), "/f", {1});
  EXPECT_EQ(told(none), "name");
  EXPECT_TRUE(mentions(none, "/f"));
}

// What was said at times, given in words.
struct Said {
  std::string address;
  double number;
  std::string at;
};
Take performed(const Document& d, const std::vector<Said>& all, const std::string& until) {
  Take take(d);
  for (const Said& one : all) {
    const Status done = take.turn(one.address, std::array{one.number}, nullptr, *parse_time(one.at, d));
    EXPECT_TRUE(done) << done.error().message;
  }
  take.end(*parse_time(until, d));
  return take;
}

// shows: G57
TEST(Dials, RecordWhatWasSentAsEvents) {
  const Document d = film_with("dial /r to ball.radius\ndial /y to ball.position.y from 0 1 to 0 10\n");
  const Take take = performed(
      d, {{"/r", 0.5, "3f"}, {"/r", 2, "5f"}, {"/r", 3, "5f"}, {"/r", 1.25, "0.2s"}, {"/y", 0.5, "13f"}}, "49f");
  // Events at the times of the messages, the last of one time; between them straight lines; x goes on as it did.
  const LoadedFilm again(write(take.document()));
  EXPECT_EQ(again.loaded.document, take.document());
  expect_numbers(again, "ball.radius", "2.99f", {1});
  expect_numbers(again, "ball.radius", "3f", {0.5});
  expect_numbers(again, "ball.radius", "4f", {1.75});
  expect_numbers(again, "ball.radius", "5f", {3});
  expect_numbers(again, "ball.radius", "0.2s", {1.25});
  expect_numbers(again, "ball.radius", "48f", {1.25});
  expect_numbers(again, "ball.position", "13f", {2, 5, 0});
  expect_numbers(again, "ball.position", "7f", {1, 2, 0});
  const std::string said = write(take.document());
  EXPECT_NE(said.find("ball.radius\n  3f 1 cut 0.5 linear\n  5f 3 linear\n  0.2s 1.25 linear\n"), std::string::npos)
      << said;
}

// shows: G57
TEST(Dials, ATakeReplacesWhatItCoversAsItWasSeen) {
  const std::string script = std::string(film) +
                             "# by hand\nball.radius\n  1f 1 linear\n  9f 3 linear  # wide\n  17f 1 linear\n"
                             "  33f 5 linear\n  41f 1 linear\ndial /r to ball.radius\n";
  const Document d = LoadedFilm(script).loaded.document;
  // A second of rest between two messages; held to 37f.
  const Take take = performed(d, {{"/r", 7, "5f"}, {"/r", 8, "6f"}, {"/r", 4, "30f"}}, "37f");
  const auto at = [&](std::string_view t) { return numbers_at(take.document(), "ball.radius", t)[0]; };
  const std::vector<std::pair<const char*, double>> seen{
      {"1f", 1},  {"3f", 1.5}, {"4.9999f", 2},  {"5f", 7},  {"5.5f", 7.5}, {"6f", 8},  {"17f", 8}, {"29f", 8},
      {"30f", 4}, {"33f", 4},  {"36.9999f", 4}, {"37f", 3}, {"39f", 2},    {"41f", 1}, {"48f", 1}};
  for (const auto& [t, value] : seen) EXPECT_NEAR(at(t), value, 1e-4) << t;
  // The author's text is what it was; behind it stands what makes it that film.
  const std::string text = take.text(script);
  EXPECT_EQ(text.substr(0, script.size()), script);
  EXPECT_EQ(text.substr(script.size()),
            "\n# Recorded\nclear ball.radius 5f..37f\nball.radius\n  5f 2 cut 7 linear\n  6f 8 linear\n  29f 8 linear\n"
            "  30f 4 linear\n  37f 4 cut 3 linear\n");
  EXPECT_EQ(LoadedFilm(text).loaded.document, take.document());
}

// shows: G57
TEST(Dials, BehindATakeWhatHadNoTrackIsAsItWas) {
  const Document d = film_with("set ball.radius 4\ndial /r to ball.radius\ndial /on to ball.display\n");
  const Take take = performed(d, {{"/r", 7, "5f"}, {"/on", 0, "5f"}}, "20f");
  for (const auto& [t, radius, shown] : std::vector<std::tuple<const char*, double, double>>{
           {"1f", 4, 1}, {"4.999f", 4, 1}, {"5f", 7, 0}, {"19.999f", 7, 0}, {"20f", 4, 1}, {"48f", 4, 1}}) {
    EXPECT_NEAR(numbers_at(take.document(), "ball.radius", t)[0], radius, 1e-9) << t;
    EXPECT_EQ(numbers_at(take.document(), "ball.display", t)[0], shown) << t;
  }
}

// shows: G57
TEST(Dials, ASecondTakeOverTheFirst) {
  const Document d = film_with("dial /y to ball.position.y\ndial /x to ball.position.x\n");
  Take take(d);
  const auto say_at = [&](const char* address, double v, const char* t) {
    ASSERT_TRUE(take.turn(address, std::array{v}, nullptr, *parse_time(t, d)));
  };
  say_at("/y", 1, "3f"), say_at("/y", 2, "5f"), take.end(*parse_time("7f", d));
  say_at("/y", 9, "5f"), say_at("/x", 6, "6f"), take.end(*parse_time("6f", d));
  const auto y = [&](std::string_view t) { return numbers_at(take.document(), "ball.position", t)[1]; };
  EXPECT_EQ(y("3f"), 1);
  EXPECT_NEAR(y("4.9999f"), 2, 1e-3);
  EXPECT_EQ(y("5f"), 9);
  EXPECT_EQ(y("6f"), 2);  // as in the first take
  EXPECT_NEAR(y("7f"), 2, 1e-12);
  EXPECT_NEAR(y("13f"), 4, 1e-12);  // as the author has it
  EXPECT_EQ(numbers_at(take.document(), "ball.position", "6f")[0], 6);
  EXPECT_NEAR(numbers_at(take.document(), "ball.position", "7f")[0], 1, 1e-12);
  EXPECT_EQ(LoadedFilm(take.text(std::string(film) + "dial /y to ball.position.y\ndial /x to ball.position.x\n"))
                .loaded.document,
            take.document());
}

// shows: G57
TEST(Dials, WhatIsRecordedHasTheShortestNumbersThatAreRight) {
  const Document d = film_with(
      "dial /r to ball.radius\ndial /m to ball.position.x from 0 1 to -5 5\ndial /t to ball.rotation.z from 0 1 to "
      "0deg 360deg\n");
  Take take(d);
  const double tenth = 0.1f, third = 1.0f / 3;
  const auto half = [](double f) { return (std::nextafter(static_cast<float>(f), 9.0f) - f) / 2; };
  const auto say_at = [&](const char* address, double v, double within, const char* t) {
    ASSERT_TRUE(take.turn(address, std::array{v}, nullptr, *parse_time(t, d), std::array{within}));
  };
  say_at("/r", tenth, half(tenth), "3f");
  say_at("/r", third, half(third), "4f");
  say_at("/m", 64 / 127.0, 0.5 / 127, "3f");
  say_at("/m", 1, 0.5 / 127, "4f");
  say_at("/t", third, half(third), "3f");
  const std::string said = write(take.document());
  EXPECT_NE(said.find(" cut 0.1 linear\n  4f 0.33333334 linear\n"), std::string::npos) << said;
  EXPECT_NE(said.find(" cut 0.04 linear\n  4f 5 linear\n"), std::string::npos) << said;
  EXPECT_NE(said.find(" cut 120deg linear\n"), std::string::npos) << said;
}

// shows: G57
TEST(Dials, WhatIsBeyondThePossibleBecomesTheNearest) {
  const Document d = film_with("dial /r to ball.radius\n");
  const Take low = performed(d, {{"/r", -5, "3f"}}, "3f");
  EXPECT_TRUE(LoadedFilm(write(low.document())).loaded.document == low.document());
  EXPECT_EQ(numbers_at(low.document(), "ball.radius", "3f")[0], 0);
}

// shows: G57
TEST(Dials, RefuseInWords) {
  const Document d = film_with(
      "dial /fader/1 to ball.radius\ndial /p to ball.position\ndial /w to word.text\ndial /m to eye.look-at.x\n");
  const Result<Document> near = say(d, "/fader/2", {1});
  EXPECT_EQ(message(near), "no dial has the address /fader/2");
  EXPECT_EQ(near.error().hint, "did you mean '/fader/1'?");
  EXPECT_EQ(message(say(d, "/fader/1", {1, 2})), "/fader/1: radius needs one number, not two numbers");
  for (const auto& [numbers, what] : {std::pair<Numbers, const char*>{{1, 2}, "two numbers"}, {{}, "no number"}}) {
    const Result<Document> few = say(d, "/p", numbers);
    EXPECT_EQ(told(few), "type");
    EXPECT_TRUE(mentions(few, "/p: ") && mentions(few, "three numbers") && mentions(few, what));
  }
  EXPECT_EQ(message(say(d, "/p", {1, std::nan(""), 2})), "/p: this is not a finite number");
  const Result<Document> endless = say(d, "/fader/1", {std::numeric_limits<double>::infinity()});
  EXPECT_EQ(told(endless), "range");
  EXPECT_TRUE(mentions(endless, "/fader/1: "));
  EXPECT_EQ(message(say(d, "/w", {1})), "/w: text needs a text");
  const std::string text = "x", broken = "a\xff", bell = "a\ab";
  EXPECT_EQ(told(turn(d, "/p", {}, &text)), "type");
  EXPECT_TRUE(mentions(turn(d, "/p", {}, &text), "three numbers, not a text"));
  for (const std::string* t : {&broken, &bell})
    EXPECT_EQ(message(turn(d, "/w", {}, t)), "/w: this is not a text: it is not UTF-8 or has control characters");
  EXPECT_EQ(message(say(film_with("set ball.rotation axis(0 1 0 30deg)\ndial /x to ball.rotation.x\n"), "/x", {1})),
            "/x: the whole of rotation is set here, so its components cannot be controlled");
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests code that is constant, which the compiler replaces by its value, and the inputs of filters, which are kept.
#include <fmt/format.h>

#include <random>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

// Code that the compiler cannot know to be constant: `none` reads the time.
std::string timed(const std::string& code) { return "local none = 0 * t return " + code; }

std::string film_of(const std::string& set, const std::string& rows) {
  return "film flat\nrate 24\ncreate a{1..3} circle\n" + set + "a*.position\n" + rows;
}

// The same film with constant code, with code that reads the time for nothing, and with numbers.
TEST(ConstantCode, IsWorthTheSameAsANumber) {
  std::mt19937 random(5);
  const auto any = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const char* const twerpers[] = {"linear", "smooth", "hold", "ease-in-out", "bezier(0.3 0 0.2 1)", "bspline"};
  for (int film = 0; film < 60; ++film) {
    const std::string radius = fmt::format("{} / 4", 1 + any(8));
    std::string rows[3];
    int frame = 1;
    for (int row = 0, count = 1 + any(5); row < count; ++row, frame += 1 + any(20)) {
      const int x = any(9), y = any(9);
      const std::string how = row + 1 < count ? twerpers[any(6)] : "";
      const bool code = any(3) > 0;
      const std::string vector = fmt::format("vec({}, {}, 0)", x, y);
      rows[0] += code ? fmt::format("  {}f = \"{}\" {}\n", frame, vector, how)
                      : fmt::format("  {}f ({} {} 0) {}\n", frame, x, y, how);
      rows[1] += code ? fmt::format("  {}f = \"{}\" {}\n", frame, timed(vector), how)
                      : fmt::format("  {}f ({} {} 0) {}\n", frame, x, y, how);
      rows[2] += fmt::format("  {}f ({} {} 0) {}\n", frame, x, y, how);
    }
    const LoadedFilm constant(film_of("set a*.radius = \"" + radius + "\"\n", rows[0]));
    const LoadedFilm live(film_of("set a*.radius = \"" + timed(radius) + "\"\n", rows[1]));
    const LoadedFilm plain(film_of("set a*.radius (" + radius + ")\n", rows[2]));
    for (int f = -2; f < 90; f += 3) {
      const std::string time = fmt::format("{}f", f);
      EXPECT_EQ(constant.numbers("a2.position", time), plain.numbers("a2.position", time)) << rows[0] << time;
      EXPECT_EQ(constant.numbers("a2.radius", time), plain.numbers("a2.radius", time));
      expect_numbers(live, "a2.position", time, plain.numbers("a2.position", time), 1e-9);
    }
  }
}

bool sleeps(const std::string& script) {
  const LoadedFilm s("film flat\ncreate a circle\nprocedure of_time lua \"t\"\nprocedure two lua \"2\"\n" + script);
  return !s.program.next_change(Time{}).has_value();
}

// Nothing is evaluated for a film that cannot change. Whatever depends on the time or on the film stays code.
TEST(ConstantCode, NeedsNoClock) {
  for (const char* code : {"2 + 3", "local r = 0 for i = 1, 9 do r = r + i end return r", "two()", "#self", "two() * i",
                           "function() return 2 end and 2", "({3, 4})[i]"})
    EXPECT_TRUE(sleeps("set a.radius = \"" + std::string(code) + "\"\n")) << code;
  for (const char* code :
       {"t", "1 + 0 * t", "frame", "rate", "of_time()", "value('a.transparency')", "function(t) return t end",
        "true and t or 2", "nothing", "local x = nil return x.y", "'text'", "1 / 0", "input(1)"})
    EXPECT_FALSE(sleeps("set a.radius = \"" + std::string(code) + "\"\n")) << code;
  EXPECT_TRUE(sleeps("set a.color = \"hsv(i / n, 1, 1)\"\n"));
  // Such rows hold, as code does; numbers would blend.
  EXPECT_FALSE(sleeps("a.radius\n  1f = \"1\"\n  24f = \"2\"\n"));
}

// Values beyond the range are brought into it, as for all code.
TEST(ConstantCode, KeepsToTheRange) {
  const LoadedFilm s("create a sphere\nset a.transparency = \"7\"\nset a.radius = \"-2\"\n");
  const LoadedFilm live("create a sphere\nset a.transparency = \"7 + 0 * t\"\nset a.radius = \"-2 + 0 * t\"\n");
  for (const char* what : {"a.transparency", "a.radius"})
    EXPECT_EQ(s.numbers(what, "1f"), live.numbers(what, "1f")) << what;
}

// What stays code says its error in every frame.
TEST(ConstantCode, ErrorsAreSaidInEveryFrame) {
  const LoadedFilm s("create a sphere\nset a.radius = \"vec(1, 2, 3)\"\n");
  for (const char* time : {"1f", "2f", "9f"}) EXPECT_EQ(s.frame(time).problems.size(), 1u) << time;
}

const char* const smoothed =
    "film flat\nrate 24\ncreate a{1..4} circle\na1.position\n  1f (0 0 0) linear\n  48f (4 1 0)\n"
    "procedure rank lua \"local r = 1 for k = 1, 4 do r = r + (value('a' .. k .. '.radius') > value('.radius') and 1 "
    "or 0) "
    "end return r\"\nset a*.radius = \"1 + sin(t * i)\"\nset a{2..4}.position = \"vec(rank(), t, 0)\"\n"
    "filter a2.position smooth width=8f\nfilter a3.position spring frequency=3\nfilter a4.position smooth width=5f\n"
    "filter a4.position noise amount=0.1\nfilter a4.position spring\n";

// Frames are the same in any order, whatever frames were asked for before.
TEST(FilterInputs, DoNotChangeAnyFrame) {
  const LoadedFilm kept(smoothed);
  std::vector<int> frames;
  for (int f = 1; f <= 60; ++f) frames.push_back(f);
  std::shuffle(frames.begin(), frames.end(), std::mt19937(3));
  for (const int f : frames) {
    const std::string time = fmt::format("{}f", f);
    const Program fresh = Program::compile(kept.loaded.document);
    const Time t = *parse_time(time, kept.loaded.document);
    const auto wanted = fresh.frame(t), is = kept.frame(time);
    ASSERT_EQ(wanted.items.size(), is.items.size());
    for (std::size_t i = 0; i < is.items.size(); ++i) EXPECT_EQ(wanted.items[i].world, is.items[i].world) << time;
    EXPECT_EQ(wanted.problems, is.problems);
  }
}

// An error of an input is said in each frame whose filter looks at it.
TEST(FilterInputs, ErrorsAreSaidInEveryFrame) {
  const LoadedFilm s(
      "film flat\nrate 24\ncreate a circle\nset a.position = \"t < 1 and vec(1, 2, 0) or nothing.x\"\n"
      "filter a.position smooth width=6f\n");
  for (int round = 0; round < 2; ++round)
    for (int f = 24; f < 40; ++f) EXPECT_EQ(s.frame(fmt::format("{}f", f)).problems.size(), 1u) << f;
  EXPECT_TRUE(s.frame("6f").problems.empty());
}

// Reading its own past through a filter ends where it always did.
TEST(FilterInputs, ACircleThroughAFilterIsCutTheSameInAnyOrder) {
  const char* const text =
      "film flat\nrate 24\ncreate a circle\ncreate b circle\nset a.position = \"value('b.position', t - 0.1) + vec(t, "
      "0, 0)\"\n"
      "set b.position = \"value('a.position') * 0.5\"\nfilter b.position smooth width=4f\n";
  const LoadedFilm kept(text);
  for (const char* time : {"9f", "3f", "10f", "9f", "4f"}) {
    const LoadedFilm fresh(text);
    EXPECT_EQ(kept.numbers("a.position", time), fresh.numbers("a.position", time)) << time;
    EXPECT_EQ(kept.frame(time).problems, fresh.frame(time).problems) << time;
  }
}

}  // namespace
}  // namespace betwixt

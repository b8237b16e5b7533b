// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the fast path for plain rows: every row must mean the same as the command `at`, which never takes that path,
// and fail where it fails.
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <random>

#include "commands/tracks.h"
#include "scene/document.h"

namespace betwixt {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view rows_film = "rate 24\ncreate {a,b,c} sphere\nlet two = 2\n";

const Words times{"1f",      "7f",       "12f",  "12.5f",        "0f",    "-3f", "0.25s",    "500ms",
                  "00:01.5", "(2+3)*1f", "i*3f", "1f+24f/(2+i)", "i1*2f", "30t", "1000000f", "3",
                  "4q",      "1f..8f",   "x",    "999999999f"};
const Words vectors{
    "(1 2 3)",   "(1,2,3)",     "( 1  -2.5 3 )", "(1 2)",       "(1 2 3 4)",   "(1+1 2 3)",   "(1 -2 3)",
    "(1 - 2 3)", "(.5 -.5 +1)", "(1e3 2E-2 3)",  "(1m 20cm 3)", "(two 1 2)",   "(i 0 0)",     "(1 2 3",
    "1 2 3",     "(1\n   2 3)", "(1 2 3)(1)",    "(1..2 3 4)",  "(1e999 0 0)", "(0 0 0)",     "(1.25 0.1 7.)",
    "5",         "(1 2 x)",     "(-0 0 0)",      "(1% 2 3)",    "(1 2 3)*2",   "(00012 1 1)", "()",
    "(2,,3 4)"};
const Words numbers{"1",   "-2.5",  "0.125",   "1e-3",  ".5",     "+2",     "1+1", "2 * 3", "two",   "(1)",
                    "50%", "3m",    "20cm",    "(1 2)", "on",     "1..2",   "7.",  "1e999", "5 - 2", "i",
                    "1 2", "30deg", "0.5turn", "90",    "-30deg", "1e2deg", "0",   "\"x\""};
const Words turns{"euler(0 90deg 0)",
                  "(1deg -2.5deg 3deg)",
                  "euler(0, -30deg, 0)",
                  "euler(1 2deg 3deg)",
                  "axis(0 1 0, 90deg)",
                  "quat(1 0 0 0)",
                  "euler (0 90deg 0)",
                  "(0 0 -0)",
                  "(0 90 0)",
                  "euler(0 1rad 0)",
                  "(0.5turn 0 0)",
                  "euler(0 90deg)",
                  "90deg",
                  "euler(0 90deg 0 0)",
                  "euler(1e2deg 0 0)",
                  "euler(90degs 0 0)",
                  "eulers(0 0 0)",
                  "(0deg 90deg 45.5deg)"};
const Words ends{"",
                 "",
                 "",
                 " linear",
                 " ease-in-out",
                 " hold",
                 " bezier(0.2 0 0.8 1)",
                 " # said",
                 " #no",
                 "  ",
                 ",",
                 " cut (2 3 4)",
                 " cut 4",
                 " ease-in=3f",
                 " ease-in=i*1f",
                 " bezier(i/4 0 0.8 1)",
                 " steps(i)",
                 " linear # said",
                 " linear linear",
                 " nothing",
                 " linear(0 0.3 1)",
                 " )",
                 " -2",
                 " * 2",
                 " keep",
                 "\r"};
const Words targets{"a.position",   "b.scale",          "a.position.y",        "b.radius",
                    "a.rotation.z", "{a,b,c}.position", "b.position.velocity", "c.color.r",
                    "a.scale.x",    "*.radius",         "{a,b,c}.radius",      "{a,b}.rotation.z",
                    "*.scale",      "a.rotation",       "b.rotation",          "a.rotation"};

std::vector<std::pair<ErrorCode, int>> failures(const Loaded& loaded) {
  std::vector<std::pair<ErrorCode, int>> all;
  for (const Diagnostic& d : loaded.diagnostics)
    if (d.severity == Severity::error) all.emplace_back(d.what.code, d.what.place.line);
  return all;
}

TEST(PlainRows, MeanWhatTheCommandAtMeans) {
  std::mt19937 dice(20261127);
  const auto one_of = [&](const Words& words) { return words[dice() % words.size()]; };
  std::size_t good = 0, bad = 0;
  for (int round = 0; round < 3000; ++round) {
    const std::string_view target = one_of(targets);
    const bool wide = target.ends_with("position") || target.ends_with("scale") || target.ends_with("velocity");
    std::string rows(rows_film), commands(rows_film);
    rows += fmt::format("{}\n", target), commands += fmt::format("{}\n", target);
    for (int n = 0; n < 4; ++n) {
      // Most rows are plain, so that others stand between them.
      const bool plain = dice() % 3 > 0;
      const std::string_view when = plain ? times[dice() % 4] : one_of(times);
      const Words& fitting = target.ends_with("rotation") ? turns : wide ? vectors : numbers;
      const Words& values = dice() % 12 > 0 ? fitting : wide ? numbers : vectors;
      const std::string_view value = plain ? values[dice() % 3] : one_of(values), end = plain ? "" : one_of(ends);
      rows += fmt::format("  {} {}{}\n", when, value, end);
      commands += fmt::format("at {} {} {}{}\n", when, target, value, end);
    }
    SCOPED_TRACE(rows);
    const Loaded a = load_text(rows, "film.bx"), b = load_text(commands, "film.bx");
    ASSERT_EQ(write(a.document), write(b.document));
    ASSERT_EQ(failures(a), failures(b));
    (failures(a).empty() ? good : bad) += 1;
  }
  EXPECT_GT(good, 300u);
  EXPECT_GT(bad, 500u);
}

TEST(PlainRows, NumbersAreTheNearest) {
  std::mt19937 dice(7);
  std::vector<std::string> texts{
      "0",  "-0.0", "1",    "0.1",  "123456789012345",  "1234567890123456", "12345678901234567",
      "5.", "00.5", "1e22", "1.e3", "9007199254740993", "0.000000000000001"};
  while (texts.size() < 20'000) {
    std::string text = dice() % 2 ? "-" : "";
    for (std::size_t i = 1 + dice() % 9; i > 0; --i) text += static_cast<char>('0' + dice() % 10);
    if (dice() % 4) text += '.';
    if (text.back() == '.')
      for (std::size_t i = dice() % 12; i > 0; --i) text += static_cast<char>('0' + dice() % 10);
    if (dice() % 8 == 0) text += fmt::format("e{}", static_cast<int>(dice() % 40) - 20);
    texts.push_back(std::move(text));
  }
  std::string script = "create a sphere\na.position.x\n";
  for (std::size_t i = 0; i < texts.size(); ++i) script += fmt::format("  {}f {}\n", i + 1, texts[i]);
  const LoadedFilm s(script);
  const Document& d = s.loaded.document;
  std::vector<double> made;
  for (const Track* track : tracks_of(d.scene(), find_targets("a.position.x", d)->front()))
    track->events.each([&](const Event& e) { made.push_back(std::get<double>(e.value)); });
  ASSERT_EQ(made.size(), texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(made[i]),
              std::bit_cast<std::uint64_t>(std::strtod(texts[i].c_str(), nullptr)))
        << texts[i];
}

TEST(PlainRows, TwoRowsWithOneTimeAreWarnedOf) {
  for (const char* rows : {"  1f 1\n  2f 2\n  2f 3\n", "  1f 1\n  2f 2\n  1f 3\n", "  3f 1\n  2f 2\n  3f 3 linear\n"}) {
    const LoadedFilm s(std::string("create a sphere\na.radius\n") + rows);
    ASSERT_EQ(s.loaded.diagnostics.size(), 1u);
    EXPECT_EQ(s.loaded.diagnostics[0].severity, Severity::warning);
    EXPECT_EQ(s.loaded.diagnostics[0].what.place.line, 5);
  }
}

TEST(PlainRows, RowsAboveCountForLaterTimes) {
  const LoadedFilm s("rate 24\ncreate a sphere\na.position.x\n  10f 1\n  +5f 2\n  20f 3\n  +1f 4\n");
  expect_numbers(s, "a.position.x", "15f", {2}, 0);
  expect_numbers(s, "a.position.x", "21f", {4}, 0);
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the texts that merges make, and their conflicts.
#include <gtest/gtest.h>

#include "betwixt/compare.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr const char* base_text =
    "# a film\nrate 24\ncreate ball sphere color=red  # the hero\ncreate lamp light\n\n"
    "ball.position\n  1f  (0 0 0)\n  12f (1 0 0) linear  # hits\n  24f (2 0 0)\n";

// Returns the base with each `old` replaced by the `now` after it.
std::string changed(std::initializer_list<std::pair<std::string_view, std::string_view>> all) {
  std::string text = base_text;
  for (const auto& [old, now] : all)
    for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + now.size()))
      text.replace(at, old.size(), now);
  return text;
}
MergedFilm merged(const std::string& mine, const std::string& theirs) {
  return merge_films(base_text, mine, theirs, "test.bx");
}
void expect_clean(const std::string& mine, const std::string& theirs, const std::string& wanted) {
  const MergedFilm m = merged(mine, theirs);
  EXPECT_TRUE(m.clean());
  EXPECT_FALSE(m.by_lines) << m.why;
  EXPECT_EQ(m.text, wanted);
}
void expect_conflict(const std::string& mine, const std::string& theirs, const std::string& wanted) {
  const MergedFilm m = merged(mine, theirs);
  ASSERT_EQ(m.conflicts.size(), 1u) << m.text;
  EXPECT_EQ(m.text, wanted);
  EXPECT_EQ(read(m.text).document, read(mine).document);
  std::size_t at = 0;
  for (int line = 1; line < m.conflicts[0].place; ++line) at = m.text.find('\n', at) + 1;
  EXPECT_EQ(m.text.find("# conflict: theirs: ", at), m.text.find('#', at));
}

TEST(MergedTexts, NeighbouringRows) {
  expect_clean(changed({{"(1 0 0)", "(1 1 0)"}}), changed({{"(2 0 0)", "(2 2 0)"}, {"1f  (0", "2f  (0"}}),
               changed({{"(1 0 0)", "(1 1 0)"}, {"(2 0 0)", "(2 2 0)"}, {"1f  (0", "2f  (0"}}));
}

// Lines of theirs next to lines of mine: no command repeats what a line says.
TEST(MergedTexts, NeighbouringLines) {
  const std::string
      base = "film flat\ncreate ball circle\nat 13f note \"start\"\nat 20f fade-out ball\n",
      mine = "film flat\ncreate ball circle\ncreate x circle\nat 13f note \"start\"\nat 20f fade-out ball\n",
      theirs = "film flat\ncreate ball circle\nat 13f note \"end\"\nat 20f fade-out ball for 12f\n",
      both = "film flat\ncreate ball circle\ncreate x circle\nat 13f note \"end\"\nat 20f fade-out ball for 12f\n";
  for (const bool swapped : {false, true}) {
    const MergedFilm m = merge_films(base, swapped ? theirs : mine, swapped ? mine : theirs, "test.bx");
    EXPECT_TRUE(m.clean());
    EXPECT_EQ(m.text, both);
  }
}

TEST(MergedTexts, PartsOfOneLine) {
  expect_clean(changed({{"color=red", "color=gold"}}), changed({{"sphere", "sphere radius=2"}}),
               changed({{"color=red", "color=gold"}}) + "set ball.radius 2\n");
}

TEST(MergedTexts, BothAddRows) {
  expect_clean(changed({{"(2 0 0)\n", "(2 0 0)\n  30f (3 0 0)  # mine\n"}}),
               changed({{"(2 0 0)\n", "(2 0 0)\n  40f (4 0 0)\nat 3f note \"x\"\n"}}),
               changed({{"(2 0 0)\n", "(2 0 0)\n  30f (3 0 0)  # mine\n  40f (4 0 0)\nat 3f note \"x\"\n"}}));
}

TEST(MergedTexts, RowsFollowARename) {
  expect_clean(changed({{"ball", "star"}}), changed({{"(1 0 0)", "(1 1 0)"}}) + "at 30f ball.color blue\n",
               changed({{"ball", "star"}, {"(1 0 0)", "(1 1 0)"}}) + "at 30f star.color blue\n");
  expect_clean(changed({{"(1 0 0)", "(1 1 0)"}}) + "at 30f ball.color blue\n", changed({{"ball", "star"}}),
               changed({{"ball", "star"}, {"(1 0 0)", "(1 1 0)"}}) + "at 30f star.color blue\n");
}

TEST(MergedTexts, TheSameChangeTwice) {
  const std::string both = changed({{"(1 0 0)", "(1 1 0)"}});
  expect_clean(both, changed({{"(1 0 0)", "(1 1 0)"}, {"rate 24", "rate  24"}}),
               changed({{"(1 0 0)", "(1 1 0)"}, {"rate 24", "rate  24"}}));
}

TEST(MergedTexts, AnEventOfBoth) {
  expect_conflict(
      changed({{"(1 0 0)", "(1 1 0)"}}), changed({{"(1 0 0)", "(1 2 0)"}}),
      changed({{"(1 0 0) linear  # hits\n", "(1 1 0) linear  # hits\n  # conflict: theirs: 12f (1 2 0) linear\n"}}));
  expect_conflict(changed({{"12f (1", "13f (1"}}), changed({{"12f (1", "14f (1"}}),
                  changed({{"12f (1 0 0) linear  # hits\n",
                            "13f (1 0 0) linear  # hits\n  # conflict: theirs: 14f (1 0 0) linear\n"}}));
}

TEST(MergedTexts, RemovedHereChangedThere) {
  expect_conflict(
      changed({{"  12f (1 0 0) linear  # hits\n", ""}}), changed({{"(1 0 0)", "(1 2 0)"}}),
      changed({{"(0 0 0)\n  12f (1 0 0) linear  # hits\n", "(0 0 0)\n  # conflict: theirs: 12f (1 2 0) linear\n"}}));
  expect_conflict(changed({{"create lamp light\n", "create lamp light range=9\n"}}),
                  changed({{"create lamp light\n", ""}}),
                  changed({{"create lamp light\n", "create lamp light range=9\n# conflict: theirs: remove lamp\n"}}));
}

TEST(MergedTexts, ASettingOfBoth) {
  const std::string range = "rate 24\nrange 1f ";
  expect_conflict(changed({{"rate 24", range + "60f"}}), changed({{"rate 24", range + "72f"}}),
                  changed({{"rate 24", range + "60f\n# conflict: theirs: range 1f 72f"}}));
}

TEST(MergedTexts, EventsKeepTheirFramesAtAnotherRate) {
  expect_clean(changed({{"(1 0 0)", "(1 1 0)"}}), changed({{"rate 24", "rate 30"}}),
               changed({{"(1 0 0)", "(1 1 0)"}, {"rate 24", "rate 30"}}));
  expect_conflict(changed({{"rate 24", "rate 25"}, {"(2 0 0)", "(2 1 0)"}}), changed({{"rate 24", "rate 30"}}),
                  changed({{"rate 24", "rate 25"}, {"(2 0 0)", "(2 1 0)"}}) + "# conflict: theirs: rate 30\n");
}

TEST(MergedTexts, WhatFollowsFromBothIsSaid) {
  const std::string base = std::string(base_text) + "copy ball.position 1f..24f to 48f\n";
  std::string mine = base, theirs = base;
  mine.replace(mine.find("(1 0 0)"), 7, "(1 1 0)");
  theirs.replace(theirs.find("to 48f"), 6, "to 60f");
  const MergedFilm m = merge_films(base, mine, theirs, "test.bx");
  EXPECT_TRUE(m.clean());
  ASSERT_EQ(m.notices.size(), 1u);
  EXPECT_EQ(m.notices[0], "ball.position has values that follow from both changes together");
  mine.replace(mine.find("to 48f"), 6, "to 60f");
  EXPECT_EQ(m.text, mine);
}

TEST(MergedTexts, WithErrorsAreMergedByLines) {
  const MergedFilm m = merged(changed({{"sphere", "spere"}}), changed({{"color=red", "color=gold"}}));
  EXPECT_TRUE(m.by_lines);
  EXPECT_EQ(m.why.substr(0, 27), "mine has an error: line 3: ");
  EXPECT_FALSE(m.clean());
  EXPECT_NE(m.text.find("<<<<<<< mine\ncreate ball spere"), std::string::npos);
}

}  // namespace
}  // namespace betwixt

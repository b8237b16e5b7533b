// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/line_words.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

using Words = std::vector<std::string>;

TEST(LineWords, StandBetweenBlanks) {
  EXPECT_EQ(line_words("eval  ball.position,\tat 2s\r"), (Words{"eval", "ball.position", "at", "2s"}));
  EXPECT_EQ(line_words(""), Words{});
  EXPECT_EQ(line_words(" , \t"), Words{});
}

TEST(LineWords, MayStandInQuotes) {
  EXPECT_EQ(line_words("save \"a film.bx\" now"), (Words{"save", "a film.bx", "now"}));
  EXPECT_EQ(line_words("save \"\""), (Words{"save", ""}));
  EXPECT_EQ(line_words("save \"a film"), (Words{"save", "a film"}));
  EXPECT_EQ(line_words("in\"side\" it"), (Words{"in\"side\"", "it"}));
}

TEST(LineWords, EndWithAComment) {
  EXPECT_EQ(line_words("undo # twice"), (Words{"undo"}));
  EXPECT_EQ(line_words("set a.color #ff0000"), (Words{"set", "a.color", "#ff0000"}));
  EXPECT_EQ(line_words("#"), Words{});
}

TEST(LineWords, EndWithTheLine) {
  EXPECT_EQ(line_words("note (\nend"), (Words{"note", "("}));
  EXPECT_EQ(line_words("note \"a\nb\" c"), (Words{"note", "a"}));
}

TEST(LineWords, TheFirstIsWhateverStandsThere) {
  EXPECT_EQ(first_word("  start list"), "start");
  EXPECT_EQ(first_word("\"end\" x"), "\"end\"");
  EXPECT_EQ(first_word("end\nbundle"), "end");
  EXPECT_EQ(first_word(" \t"), "");
}

}  // namespace
}  // namespace betwixt

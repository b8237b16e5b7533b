// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "syntax/tokens.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

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
  EXPECT_EQ(line_words("text=\"a b\" it"), (Words{"text=\"a b\"", "it"}));
  EXPECT_EQ(line_words("say \"a \\\" b\" it"), (Words{"say", "a \\\" b", "it"}));
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

// The kinds of a text's tokens as letters: s space, c comment, t text, ( ), = sign, w word, n line feed.
std::string kinds(std::string_view text, LineState state = {}) {
  std::string out;
  for (const Token& t : tokens_of(text, state)) out += "snct()=w"[static_cast<std::size_t>(t.kind)];
  return out;
}

TEST(Tokens, AreWhatTheLanguageSaysTheyAre) {
  EXPECT_EQ(kinds("create ball sphere color=gold"), "wswswsw=w");
  EXPECT_EQ(kinds("set a.color #ffcc00 # warm"), "wswswsc");
  EXPECT_EQ(kinds("  1f  (0 1,0)\tlinear"), "sws(wswsw)sw");
  EXPECT_EQ(kinds("{a, b}{1..3}.position"), "w");
  EXPECT_EQ(kinds("note \"a # b\"# x"), "wstc");
  EXPECT_EQ(kinds("R(1turn @ sun)"), "w(ws=sw)");
  EXPECT_EQ(kinds("#"), "c");
  EXPECT_EQ(kinds("#x"), "w");
  EXPECT_EQ(kinds("a\n# b\n c"), "wncnsw");
  EXPECT_EQ(kinds("\"never closed"), "t");
  EXPECT_EQ(kinds("inside\"\"\" out", {0, true}), "tsw");
}

TEST(Tokens, KnowTheirMissingQuotes) {
  const auto closed = [](std::string_view text) {
    LineState state;
    return tokens_of(text, state).back().closed;
  };
  EXPECT_TRUE(closed("\"a\""));
  EXPECT_FALSE(closed("\"a"));
  EXPECT_FALSE(closed("\"a\\\""));
  EXPECT_FALSE(closed("\"\"\"a\""));
  EXPECT_TRUE(closed("\"\"\"a\n\"\"\""));
}

TEST(Tokens, BeforeAPlace) {
  const std::string_view line = "set a.x = \"code\"";
  EXPECT_EQ(token_before(line, 10)->kind, TokenKind::sign);
  EXPECT_EQ(token_before(line, 8)->at, 4u);
  EXPECT_FALSE(token_before("  a", 2));
}

// Brackets and blocks, counted character by character.
TEST(LogicalLines, EndWhereNothingIsOpen) {
  const auto length = [](std::string_view text) {
    return static_cast<std::size_t>(logical_line(text).end - text.data());
  };
  EXPECT_EQ(length("a (b\nc) d\ne"), 9u);
  EXPECT_EQ(length("a # (\nb"), 5u);
  EXPECT_EQ(length("a \"(\" b\nc"), 7u);
  EXPECT_EQ(length("a \"\"\"x\ny\"\"\" b\nc"), 13u);
  EXPECT_EQ(length("a (# )\n) b\nc"), 10u);
  EXPECT_TRUE(logical_line("a (b\nc").open);
  EXPECT_EQ(logical_line("a (b\nc").depth, 1);
  EXPECT_EQ(length("a (b\nc"), 4u);
  EXPECT_TRUE(logical_line("a \"\"\"b\nc").open);
  EXPECT_FALSE(logical_line("a \"b\nc").open);
}

TEST(Pieces, AreHeldTogetherByBrackets) {
  const auto pieces = [](std::string_view line) {
    Words all;
    for (std::string_view one = take_piece(line); !one.empty(); one = take_piece(line)) all.emplace_back(one);
    return all;
  };
  EXPECT_EQ(pieces("at (1f + 2f) ball.x  beat[i + 1] # c"), (Words{"at", "(1f + 2f)", "ball.x", "beat[i + 1]"}));
  EXPECT_EQ(pieces("key=\"a b\" (1\n 2) c\nd"), (Words{"key=\"a b\"", "(1\n 2)", "c"}));
}

TEST(Pieces, ABracketEndsWhereItIsClosed) {
  const std::string text = "((1 \")\" # )\n) 2) (3";
  const char* const end = text.data() + text.size();
  EXPECT_EQ(bracket_end(text.data(), end) - text.data(), 16);
  const char* const open = text.data() + text.rfind('(');
  EXPECT_EQ(bracket_end(open, end), open);
}

TEST(Pieces, APathIsOneWordInQuotes) {
  for (const char* path : {"film.bx", "a film.bx", "a,b.bx", "#1.bx", "x(1).bx"})
    EXPECT_EQ(line_words("open " + as_one_word(path)), (Words{"open", path})) << path;
  EXPECT_EQ(as_one_word("film.bx"), "film.bx");
}

TEST(Pieces, WhatPrecedesAScript) {
  EXPECT_EQ(without_mark("\xEF\xBB\xBFrate 24"), "rate 24");
  EXPECT_EQ(program_line("#!/bin/x\nrate 24"), 8u);
  EXPECT_EQ(program_line("#!"), 2u);
  EXPECT_EQ(program_line("# !"), 0u);
}

TEST(Comments, AreTakenOff) {
  EXPECT_EQ(without_comment("set a.color #ff0000  # red"), "set a.color #ff0000");
  EXPECT_EQ(without_comment("note \"a # b\" # c"), "note \"a # b\"");
  EXPECT_EQ(without_comment("x (1 # one\n 2)  # two"), "x (1 # one\n 2)");
  EXPECT_TRUE(empty_line(" \t, # x"));
  EXPECT_TRUE(empty_line("\nx"));
  EXPECT_FALSE(empty_line("#x"));
}

}  // namespace
}  // namespace betwixt

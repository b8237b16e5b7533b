// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "syntax/script_text.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace betwixt {
namespace {

// A text of parts that a script is made of, in any order.
std::string text_of(const std::vector<std::uint8_t>& choice) {
  static constexpr std::string_view parts[] = {"(",   ")",  "\"", "\"\"\"", "# ",   " ", "\n",
                                               "a.b", "\n", "=",  "\\",     "\r\n", "#!"};
  std::string text;
  for (const auto c : choice) text += parts[c % std::size(parts)];
  return text;
}

void expect_same(const ScriptText& edited, const ScriptText& anew) {
  RC_ASSERT(edited.count() == anew.count());
  for (std::size_t i = 0; i < anew.count(); ++i) {
    RC_ASSERT(edited.start(i) == anew.start(i));
    RC_ASSERT(edited.line(i) == anew.line(i));
    RC_ASSERT(edited.state_above(i) == anew.state_above(i));
    RC_ASSERT(edited.tokens(i) == anew.tokens(i));
  }
}

TEST(ScriptTexts, AreTheSameHoweverTheyWereWritten) {
  EXPECT_TRUE(rc::check("edited and lexed anew",
                        [](const std::vector<std::uint8_t>& begin,
                           const std::vector<std::tuple<unsigned, unsigned, std::vector<std::uint8_t>>>& edits) {
                          ScriptText edited(text_of(begin));
                          for (const auto& [at, size, choice] : edits) {
                            const std::size_t from = at % (edited.text().size() + 1);
                            edited.replace({from, size % (edited.text().size() - from + 1)}, text_of(choice));
                            expect_same(edited, ScriptText(edited.text()));
                          }
                        }));
}

TEST(ScriptTexts, AreTheirTokens) {
  const auto holds = [](const std::string& text) {
    const ScriptText script(text);
    std::size_t at = 0;
    for (std::size_t i = 0; i < script.count(); ++i)
      for (const Token& t : script.tokens(i)) {
        RC_ASSERT(script.start(i) + t.at == at);
        RC_ASSERT(t.size > 0u);
        at += t.size;
      }
    RC_ASSERT(at == text.size());
  };
  EXPECT_TRUE(
      rc::check("of parts of scripts", [&](const std::vector<std::uint8_t>& choice) { holds(text_of(choice)); }));
  EXPECT_TRUE(rc::check("of any bytes", [&](const std::string& text) { holds(text); }));
}

// The logical lines are those of the reader, which takes one after the other.
TEST(ScriptTexts, HaveTheLogicalLinesOfTheReader) {
  EXPECT_TRUE(rc::check("the same logical lines", [](const std::vector<std::uint8_t>& choice) {
    const ScriptText script("\n" + text_of(choice));
    const char* const end = script.text().data() + script.text().size();
    std::size_t line = 0;
    for (const char* at = script.text().data(); at < end; line = script.behind(line)) {
      RC_ASSERT(script.text().data() + script.start(line) == at);
      RC_ASSERT(script.first_of(line) == line);
      at = logical_line({at, end}).next(end);
    }
  }));
}

TEST(ScriptTexts, KnowTheirLogicalLines) {
  const ScriptText text("a (\nb\n) c\nd \"\"\"\ne\n\"\"\"\n# x\n\n");
  EXPECT_EQ(text.count(), 9u);
  EXPECT_EQ(text.first_of(2), 0u);
  EXPECT_EQ(text.behind(1), 3u);
  EXPECT_EQ(text.first_of(5), 3u);
  EXPECT_EQ(text.behind(3), 6u);
  EXPECT_TRUE(text.only_comment(6));
  EXPECT_TRUE(text.empty(7));
  EXPECT_FALSE(text.empty(4));
  EXPECT_FALSE(text.only_comment(7));
  EXPECT_EQ(text.line_of(text.start(4)), 4u);
  EXPECT_EQ(text.tokens(4).size(), 1u);
}

TEST(ScriptTexts, ABracketThatIsNeverClosedSpoilsOneLine) {
  ScriptText text("a (1\nb\n  c\nd (2\n3)\n");
  for (std::size_t i : {0, 1, 2, 3}) EXPECT_EQ(text.first_of(i), i);
  EXPECT_EQ(text.first_of(4), 3u);
  text.replace({text.start(2), 0}, ")");  // closes the first one
  EXPECT_EQ(text.first_of(2), 0u);
  text.replace({text.start(0), 0}, "# ");
  EXPECT_EQ(text.first_of(1), 1u);
  EXPECT_EQ(ScriptText("a (\"x\n)\n").first_of(1), 1u) << "a text that its line does not close";
}

TEST(ScriptTexts, ABracketThatIsBeingWrittenGoesOnInIndentedLines) {
  const ScriptText text("x\na (\n\n  b\nc");
  EXPECT_EQ(text.first_before(text.text().find('b') + 1), 1u);
  EXPECT_EQ(text.first_before(text.text().size()), 4u);
  EXPECT_EQ(text.first_before(1), 0u);
}

TEST(ScriptTexts, TheProgramOfAScriptIsAComment) {
  const ScriptText text("\xEF\xBB\xBF#!/bin/betwixt (\"\ncreate b box");
  EXPECT_EQ(text.tokens(0).front().kind, TokenKind::comment);
  EXPECT_FALSE(text.state_above(1).goes_on());
  EXPECT_EQ(ScriptText("a\n#!x (\n)").first_of(2), 1u) << "only in the first line";
}

TEST(ScriptTexts, OfTwoTokensThatMeetTheSecondIsThere) {
  const ScriptText text("a(b)");
  EXPECT_EQ(text.token_at(0, 1)->kind, TokenKind::open);
  EXPECT_EQ(text.token_at(0, 4)->kind, TokenKind::close);
  EXPECT_FALSE(text.token_at(0, 5));
}

TEST(Lines, StartAfterLineFeeds) {
  EXPECT_EQ(line_starts("a\n\nb"), (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(line_starts("a\n"), std::vector<std::size_t>{0});
  EXPECT_EQ(line_starts(""), std::vector<std::size_t>{});
  EXPECT_EQ(line_at("a\nbc\nd", 2), "bc\n");
  EXPECT_EQ(line_at("a\nbc\nd", 5), "d");
}

}  // namespace
}  // namespace betwixt

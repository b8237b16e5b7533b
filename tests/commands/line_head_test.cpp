// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests what tools can tell about a line without running it.
#include "commands/line_head.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

using Names = std::vector<std::string>;

TEST(LineHeads, AreTheFirstPiecesAfterTimeAndLayer) {
  const LineHead head = line_head("at (1f + 2f) on sway ball.position (1 2 3)  # so");
  EXPECT_EQ(head.time, "(1f + 2f)");
  EXPECT_EQ(head.layer, "sway");
  EXPECT_EQ(head.word, "ball.position");
  EXPECT_EQ(head.verb, nullptr);
  EXPECT_EQ(head.name, "(1 2 3)");
  EXPECT_TRUE(head.alone());
  EXPECT_EQ(line_head("hide ball").verb, find_verb("hide"));
  EXPECT_TRUE(line_head("  1f 2").row);
  for (const char* nothing : {"", "  ", "# hide", "at", "at 1f"})
    EXPECT_TRUE(line_head(nothing).word.empty() || std::string_view(nothing).starts_with("at"));
}

TEST(LineHeads, AKindIsWhereTheRowHasOne) {
  EXPECT_EQ(kind_word(line_head("create ball sphere radius=2")), "sphere");
  EXPECT_EQ(kind_word(line_head("layer ball sphere")), "");
  EXPECT_EQ(kind_word(line_head("create ball")), "");
}

TEST(LineHeads, OpenSheetsAndLists) {
  EXPECT_EQ(opens(line_head("on sway ball.position # x")), Opens::sheet);
  EXPECT_EQ(opens(line_head("at 2f edit house")), Opens::list);
  for (const char* other : {"make", "make a b", "at 1f ball.position", "1.5", "\"a.b\"", "hide a.b", "a.b 1"})
    EXPECT_EQ(opens(line_head(other)), Opens::nothing) << other;
}

TEST(LineHeads, ARowHasAnOpener) {
  const ScriptText text("ball.position\n  1f (1 2\n    3)\n# x\n  2f 1\nhide ball\n  3f 1\n");
  for (const std::size_t line : {1, 2, 4}) EXPECT_EQ(opener_of(text, line), 0u) << line;
  for (const std::size_t line : {0, 5, 6}) EXPECT_EQ(opener_of(text, line), text.count()) << line;
}

// Each verb that makes names says so in its row; `let` was missing once.
TEST(LineHeads, NamesAreMadeByTheVerbsWhoseRowsSaySo) {
  EXPECT_EQ(names_made("create b{1..3} sphere"), (Names{"b1", "b2", "b3"}));
  EXPECT_EQ(names_made("let x=1"), Names{"x"});
  EXPECT_EQ(names_made("let again x = 1"), Names{"x"});
  EXPECT_EQ(names_made("at 2f make house"), Names{"house"});
  EXPECT_EQ(names_made("split title into letters"), Names{"title/"});
  EXPECT_EQ(names_made("  create b box"), Names{"b"});  // in a block
  for (const char* none : {"hide ball", "create", "# create b box", "set a.color #ffcc00"})
    EXPECT_EQ(names_made(none), Names{}) << none;
  for (const std::string_view verb : making_verbs()) {
    const auto made = making(std::string(verb) + " it");
    ASSERT_TRUE(made) << verb;
    EXPECT_EQ(made->word, "it") << verb;
  }
  EXPECT_EQ(making("let x = 1")->kind, NameKind::let);
  EXPECT_EQ(making("define f number")->kind, NameKind::function);
  EXPECT_EQ(making("procedure p lua \"1\"")->kind, NameKind::procedure);
}

TEST(VerbRows, HaveWordsForEachPlace) {
  EXPECT_EQ(words_at("a b; c; d…", 0), "a b");
  EXPECT_EQ(words_at("a b; c; d…", 1), " c");
  EXPECT_EQ(words_at("a b; c; d…", 7), " d");
  EXPECT_EQ(words_at("a; b", 2), "");
  EXPECT_TRUE(has_word("a b; cd; e…", "cd"));
  EXPECT_TRUE(has_word("a b; cd; e…", "e"));
  EXPECT_FALSE(has_word("a b; cd; e…", "c"));
  EXPECT_FALSE(has_word("a b; cd; e…", "d"));
}

}  // namespace
}  // namespace betwixt

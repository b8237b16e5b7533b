// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests lines that are indented below another one: at a shell, in the author's text, and for a text editor.
#include "commands/line_head.h"
#include "editor/author.h"
#include "editor/film_texts.h"
#include "editor/text_features.h"

namespace betwixt {
namespace blocks_test {

const std::string film =
    "create ball sphere\nsection one at 2s speed=2\n  ball.position\n    1f (0 0 0)\n    # then\n    25f (4 0 0)\n"
    "  at 13f ball.color red\n\nsection two\n  create box1 box\n  at 1f ball.radius 2\nhide box1\n";

TEST(Blocks, ALineKnowsItsOpenerAndItsBlock) {
  const ScriptText text(film);
  const std::size_t none = text.count();
  const std::size_t openers[] = {none, none, none, 2, 2, 2, none, none, none, none, none, none};
  const std::size_t blocks[] = {none, none, 1, 1, 1, 1, 1, none, none, 8, 8, none};
  for (std::size_t i = 0; i < 12; ++i) {
    if (i == 4) continue;  // a comment
    EXPECT_EQ(opener_of(text, i), openers[i]) << i;
    EXPECT_EQ(block_of(text, i), blocks[i]) << i;
  }
  Indentation follow;
  for (std::size_t i = 0; i < 12; ++i) {
    if (text.empty(i)) continue;
    EXPECT_EQ(follow.row(text.line(i)), openers[i] < none) << i;
    EXPECT_EQ(follow.depth(), blocks[i] < none ? 1u : 0u) << i;
  }
}

TEST(Blocks, FoldAndAreSymbols) {
  const ScriptText text(film);
  std::string all;
  for (const Fold& f : folds(text)) all += std::to_string(f.first) + "-" + std::to_string(f.last) + " ";
  EXPECT_EQ(all, "1-6 2-5 8-10 ");
  all.clear();
  for (const TextSymbol& s : symbols(text)) all += std::string(s.name) + " ";
  EXPECT_EQ(all, "ball one ball.position two box1 ");
}

TEST(Blocks, GoOnLineByLine) {
  Session s;
  std::string text = film;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const auto answer = s.enter(text.substr(at, end - at));
    EXPECT_TRUE(answer.done || end == at || text.substr(at, end - at) == "    # then")
        << text.substr(at, end - at) << answer.said;
    at = end + 1;
  }
  EXPECT_EQ(s.document(), load_text(text, "").document);
  EXPECT_EQ(load_text(s.text(), "").document, s.document()) << s.text();
  ASSERT_TRUE(s.enter("undo").done && s.enter("undo").done && s.enter("  at 25f ball.radius 3").done);
  EXPECT_EQ(s.document().sections()[1].end, from_seconds(3.5)) << s.text();  // 2 s + 0.5 s, and 1 s
  // The rows of a sheet in a block need no blanks at a prompt.
  ASSERT_TRUE(s.enter("  ball.position.y").done && s.enter("49f 1").done);
  EXPECT_EQ(s.document().sections()[1].end, from_seconds(4.5)) << s.text();
  // After an error in the opener, its lines are refused.
  EXPECT_FALSE(s.enter("section three after nothing").done);
  EXPECT_FALSE(s.enter("  at 1f ball.radius 4").done);
}

// Opens the text, says lines as the studio does, and returns the new text.
std::string placed(const std::string& text, const std::vector<std::string>& lines) {
  const Folder folder;
  folder.put("film.bx", text);
  Session s;
  s.edit_in_place();
  EXPECT_TRUE(s.open(folder / "film.bx").done);
  const Session::Answer a = s.enter_together(lines);
  EXPECT_TRUE(a.done) << a.said;
  EXPECT_EQ(load_text(s.text(), "").document, s.document()) << s.text();
  return s.text();
}

std::string with(std::string text, const std::string& was, const std::string& is) {
  return text.replace(text.find(was), was.size(), is);
}

TEST(Blocks, RowsAreEditedInTheirOwnTimes) {
  // The section has a length, so that no later line moves.
  const std::string text = with(film, "speed=2", "for 4s speed=2");
  EXPECT_EQ(placed(text, {"at 2s ball.position (7 0 0)"}), with(text, "1f (0 0 0)", "1f (7 0 0)"));
  // 25f of the section is 2 s + 1 s / 2; a frame later in the film are two of the section.
  EXPECT_EQ(placed(text, {"move ball.position 2.4s..3s by 1f"}), with(text, "25f (4 0 0)", "27f (4 0 0)"));
  EXPECT_EQ(placed(text, {"at 3s ball.position (5 0 0)"}),
            with(text, "25f (4 0 0)\n", "25f (4 0 0)\n    49f (5 0 0)\n"));
  EXPECT_EQ(placed(text, {"clear ball.color 2s..2.5s"}), with(text, "  at 13f ball.color red\n", ""));
  EXPECT_EQ(placed(text, {"at 54f ball.color gold"}),
            with(text, "  at 13f ball.color red\n", "  ball.color\n    11f gold\n    13f red\n"));
}

TEST(Blocks, AreTidiedAsAWhole) {
  const std::string untidy = with(film, "25f (4 0 0)", "25.0f   (4 0 0)");
  const ScriptText text(untidy);
  const Span row{text.start(5), 3};
  EXPECT_EQ(tidied_in(text, row), with(with(film, "1f (0", "1f   (0"), "25f (4", "25f  (4"));
}

}  // namespace blocks_test
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests how an editor deals with words of a recording that are times: colours, completion, dragging, renaming.
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "betwixt/language.h"
#include "betwixt/session.h"
#include "editor/completion.h"
#include "editor/film_texts.h"
#include "editor/line_pieces.h"
#include "editor/text_features.h"
#include "support/folder.h"
#include "support/waves.h"

namespace betwixt {
namespace {

const std::string voice = "create voice sound file=\"talk.wav\" words=\"talk.words\"\ncreate b sphere\n";

class EditedWords : public testing::Test {
 protected:
  EditedWords() {
    folder.put("talk.words",
               "0.5 0.8 We\n0.9 1.2 begin\n1.2 1.3 with\n1.3 1.4 a\n1.5 2.0 square.\n2.1 2.2 we\n2.25 2.75 end\n");
    write_wave(folder / "talk.wav", std::vector<float>(2 * 3 * 48'000));
  }
  Document film(const std::string& text) const {
    folder.put("film.bx", text);
    return load_file(folder / "film.bx").document;
  }
  // What is offered at the end of a line, which is a row of b.radius if it is indented.
  std::string offered(const std::string& line) const {
    return fmt::format("{}", fmt::join(completions(line, film(voice), {.sheet_open = true, .sheet = "b.radius"}), " "));
  }
  // What the rows below b.radius become by these lines.
  std::string dragged(const std::string& rows, const std::vector<std::string>& lines) const {
    const std::string file = fmt::format("{}.bx", ++dragged_);
    folder.put(file, voice + "b.radius\n" + rows);
    Session s;
    s.edit_in_place();
    EXPECT_TRUE(s.open(folder / file).done);
    for (const std::string& line : lines) {
      const Session::Answer a = s.enter(line);
      EXPECT_TRUE(a.done) << line << ": " << a.said;
    }
    folder.put(file, s.text());
    EXPECT_TRUE(load_file(folder / file).document == s.document()) << s.text();
    return s.text().substr(s.text().find("b.radius\n") + 9);
  }
  const Folder folder;
  mutable int dragged_ = 0;
};

TEST_F(EditedWords, AreCompleted) {
  EXPECT_EQ(offered("  voice:\"we b"), "voice:\"we begin\"");
  EXPECT_EQ(offered("  voice:\"we "), "voice:\"we begin\" voice:\"we end\"");
  EXPECT_EQ(offered("  voice:\"sq"), "voice:\"square\"");
  EXPECT_EQ(offered("at voice:\"with a"), "voice:\"with a\"");
  EXPECT_EQ(offered("  vo"), "voice.end voice.start voice:\"");
  EXPECT_EQ(offered("  voice.e"), "voice.end voice.environments");
  EXPECT_EQ(offered("  b:\"x"), "");
  EXPECT_EQ(begun_word("  1f..voice:\"we b"), 6u);
}

TEST_F(EditedWords, AreCompletedBetweenQuotesThatAreThere) {
  const std::string text = voice + "at voice:\"we b\" b.radius 2\n";
  const Completions found = completions_at(ScriptText(text), text.find("\" b.radius"), film(text), folder.path());
  EXPECT_EQ(found.words, std::vector<std::string>{"voice:\"we begin"});
  EXPECT_EQ(found.from, text.find("voice:\"we"));
}

TEST_F(EditedWords, HaveTheColorsOfTimes) {
  const auto pieces = [&](std::string_view line) {
    std::string out;
    LineState state;
    for (const LinePiece& p : line_pieces(line, state, film(voice)))
      out += fmt::format("{}{}:{}", out.empty() ? "" : " ", static_cast<int>(p.meaning), line.substr(p.at, p.length));
    return out;
  };
  const auto is = [](Meaning m) { return std::to_string(static_cast<int>(m)); };
  EXPECT_EQ(pieces("  voice:\"we begin\"#2+12f 3 linear"),
            is(Meaning::name) + ":voice " + is(Meaning::time) + ":\"we begin\" " + is(Meaning::time) + ":#2+12f " +
                is(Meaning::number) + ":3 " + is(Meaning::twerper) + ":linear");
  EXPECT_EQ(pieces("at voice:\"we\" note \"x\""), is(Meaning::verb) + ":at " + is(Meaning::name) + ":voice " +
                                                      is(Meaning::time) + ":\"we\" " + is(Meaning::verb) + ":note " +
                                                      is(Meaning::text) + ":\"x\"");
  const Document d = film(voice);
  const auto t = time_at("  voice:\"square\"+12f 3", 12, d);
  ASSERT_TRUE(t);
  EXPECT_NEAR(t->seconds(), 1.5, 1e-9);
}

TEST_F(EditedWords, StayInRowsThatAreDragged) {
  const std::string rows = "  voice:\"we\"  1\n  voice:\"square\"  2\n";
  EXPECT_EQ(dragged(rows, {"at voice:\"square\" b.radius 3"}), "  voice:\"we\"  1\n  voice:\"square\"  3\n");
  EXPECT_EQ(dragged(rows, {"move b.radius 1s..2s by 12f"}), "  voice:\"we\"  1\n  voice:\"square\"+12f  2\n");
  EXPECT_EQ(dragged(rows, {"move b.radius 1s..2s by -6f"}), "  voice:\"we\"  1\n  voice:\"square\"-6f  2\n");
  EXPECT_EQ(dragged("  voice:\"square\"+12f  2\n", {"move b.radius 1s..3s by -12f"}), "  voice:\"square\"  2\n");
  EXPECT_EQ(dragged(rows, {"move b.radius 1s..2s by 0.01s"}), "  voice:\"we\"  1\n  1.51s  2\n");
}

TEST_F(EditedWords, AreRowsAtThePrompt) {
  Session s;
  folder.put("film.bx", voice);
  ASSERT_TRUE(s.open(folder / "film.bx").done);
  EXPECT_TRUE(s.enter("b.radius").done);
  const Session::Answer a = s.enter("voice:\"square\" 2");
  EXPECT_TRUE(a.done) << a.said;
}

}  // namespace
}  // namespace betwixt

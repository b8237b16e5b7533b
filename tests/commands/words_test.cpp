// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words of a recording as times: which times they are, where they can stand, and what is wrong with others.
#include "betwixt/track.h"
#include "scene/document.h"
#include "support/folder.h"
#include "support/loaded_film.h"
#include "support/waves.h"

namespace betwixt {
namespace {

constexpr const char* talk_words =
    "0.5 0.8 We\n0.9 1.2 begin\n1.2 1.3 with\n1.3 1.4 a\n1.5 2.0 square.\n2.1 2.2 The\n2.25 2.75 square\n";
constexpr const char* two = "create voice sound file=\"talk.wav\" words=\"talk.words\"\ncreate b sphere\n";

class Words : public testing::Test {
 protected:
  Words() {
    folder.put("talk.words", talk_words);
    write_wave(folder / "talk.wav", std::vector<float>(2 * 3 * 48'000));
  }
  Loaded load(const std::string& script) const {
    folder.put("film.bx", script);
    return load_file(folder / "film.bx");
  }
  // The times of the events of b.radius, in seconds.
  std::vector<double> times(const std::string& script) const {
    const Loaded l = load(script);
    EXPECT_FALSE(has_errors(l.diagnostics)) << said(l.diagnostics);
    std::vector<double> all;
    const auto targets = find_targets("b.radius", l.document);
    if (targets)
      for (const EventView& e : events(l.document, targets->front())) all.push_back(e.time.seconds());
    return all;
  }
  // The time of one row.
  double time(const std::string& word, const std::string& voice = two) const {
    const auto all = times(voice + "b.radius\n  " + word + "  2\n");
    return all.size() == 1 ? all[0] : -1;
  }
  std::string wrong(const std::string& word) const {
    std::string all;
    for (const Diagnostic& d : load(two + ("b.radius\n  " + word + "  2\n")).diagnostics)
      all += fmt::format("{}: {} ({})", d.what.place.column, d.what.message, d.what.hint);
    return all;
  }
  const Folder folder;
};

TEST_F(Words, AreTimes) {
  EXPECT_NEAR(time("voice:\"square\""), 1.5, 1e-9);
  EXPECT_NEAR(time("voice:\"We begin\""), 0.5, 1e-9);
  EXPECT_NEAR(time("voice:\"begin\""), 0.9, 1e-9);
  EXPECT_NEAR(time("voice:\"square\"#2"), 2.25, 1e-9);
  EXPECT_NEAR(time("voice:\"the SQUARE!\""), 2.1, 1e-9);
  EXPECT_NEAR(time("voice:\"withasquare\""), 1.2, 1e-9);
  EXPECT_NEAR(time("voice:\"a square\".end"), 2.0, 1e-9);
  EXPECT_NEAR(time("voice:\"square\"#2.end"), 2.75, 1e-9);
  EXPECT_NEAR(time("voice.start"), 0, 1e-9);
  EXPECT_NEAR(time("voice.end"), 3, 1e-9);
}

TEST_F(Words, TakeLengthsBehindThem) {
  EXPECT_NEAR(time("voice:\"square\"+12f"), 1.5 + 12 / 24.0, 1e-9);
  EXPECT_NEAR(time("voice:\"square\"-0.5s"), 1.0, 1e-9);
  EXPECT_NEAR(time("voice.end-24f"), 2.0, 1e-9);
  EXPECT_NEAR(time("(voice:\"square\"+voice:\"square\"#2)/2"), 1.875, 1e-9);
}

TEST_F(Words, FollowTheSoundsPlace) {
  const auto voice = [](const std::string& more) {
    return "create voice sound file=\"talk.wav\" words=\"talk.words\" " + more + "\ncreate b sphere\n";
  };
  EXPECT_NEAR(time("voice:\"square\"", voice("at=1s from=0.25s")), 2.25, 1e-9);
  EXPECT_NEAR(time("voice:\"square\"", voice("at=25f")), 2.5, 1e-9);
  EXPECT_NEAR(time("voice:\"square\"", voice("from=2s")), 0.25, 1e-9);  // the first is cut off
  EXPECT_NEAR(time("voice.start", voice("at=1s from=0.25s")), 1, 1e-9);
  EXPECT_NEAR(time("voice.end", voice("at=1s from=0.25s")), 3.75, 1e-9);
  EXPECT_NEAR(time("voice.end", voice("until=2s")), 2, 1e-9);
}

TEST_F(Words, StandWhereverTimesStand) {
  EXPECT_EQ(times(std::string(two) + "at voice:\"begin\" b.radius 2\n"), std::vector<double>{0.9});
  const Loaded l = load(std::string(two) + "range 1f voice.end\nat voice:\"square\"+1f note \"here\"\n");
  EXPECT_FALSE(has_errors(l.diagnostics)) << said(l.diagnostics);
  EXPECT_NEAR(l.document.range().second.seconds(), 3, 1e-9);
  EXPECT_NEAR(l.document.scene().notes->begin()->first.seconds(), 1.5 + 1 / 24.0, 1e-9);
  const std::string segment =
      "b.radius\n  voice:\"we\" 1 linear\n  voice:\"square\" 2\ncopy b.radius voice:\"we\"..voice:\"square\" to "
      "voice.end\n";
  const auto all = times(two + segment);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_NEAR(all[2], 3, 1e-9);
  EXPECT_NEAR(all[3], 4, 1e-9);
  EXPECT_NEAR(time("t", std::string(two) + "let t = voice:\"square\"+1s\n"), 2.5, 1e-9);
  EXPECT_EQ(times(std::string(two) + "b.radius\n  voice:\"square\" 1\n  +12f 2\n"), (std::vector<double>{1.5, 2}));
}

TEST_F(Words, OfPathsAndDifferences) {
  const std::string named = "create a-b sound file=\"talk.wav\" words=\"talk.words\"\ncreate b sphere\nlet beat = 4s\n";
  EXPECT_NEAR(time("a-b:\"square\"", named), 1.5, 1e-9);
  EXPECT_NEAR(time("a-b.end", named), 3, 1e-9);
  EXPECT_NEAR(time("a-b.end-beat/2", named), 1, 1e-9);
}

TEST_F(Words, ThatAreNotThereAreErrors) {
  EXPECT_EQ(wrong("voice:\"the sqare\""),
            "9: \"the sqare\" is not spoken in 'voice' (did you mean \"The square\"? It begins at 2.10s)");
  EXPECT_EQ(wrong("voice:\"entirely other\""), "9: \"entirely other\" is not spoken in 'voice' ()");
  EXPECT_EQ(wrong("voice:\"square\"#3"), "9: \"square\" is spoken 2 times in 'voice' (they begin at 1.50s, 2.25s)");
  EXPECT_EQ(wrong("voice:\"quare\"").substr(0, 38), "9: \"quare\" is not spoken in 'voice' (d");
  EXPECT_EQ(wrong("voce:\"square\""), "3: there is no object 'voce' (did you mean 'voice'?)");
  EXPECT_EQ(wrong("b:\"square\""), "3: 'b' is no sound, so it has no words and no end ()");
  EXPECT_EQ(wrong("b.end"), "3: 'b' is no sound, so it has no words and no end ()");
  EXPECT_EQ(wrong("voice:\"square\"#0"), "17: a number from 1 is missing after '#' (as in voice:\"square\"#2)");
  EXPECT_EQ(wrong("voice:\"...\""), "9: words are missing between the quotes ()");
  EXPECT_EQ(wrong("voice:\"square"),
            "9: this text is not closed on the same line (end it with \", or begin and end it "
            "with \"\"\" if it has several lines)");
}

TEST_F(Words, NeedAFile) {
  const auto first = [&](const std::string& script) {
    const auto all = errors(load(script));
    return all.empty() ? std::string() : all[0];
  };
  EXPECT_EQ(first("create voice sound file=\"talk.wav\"\nat voice:\"a\" note \"x\"\n"), "2:10: 'voice' has no words");
  EXPECT_EQ(first("create voice sound file=\"talk.wav\" words=\"none.words\"\n").substr(0, 5), "1:42:");
  folder.put("bad.words", "1 2 b\n0 1 a\n");
  EXPECT_NE(
      first("create voice sound file=\"talk.wav\" words=\"bad.words\"\n").find("bad.words:2:1: the words are out"),
      std::string::npos);
  EXPECT_NE(first("create voice sound file=\"talk.wav\" words=\"../t.words\"\n").find("outside"), std::string::npos);
}

TEST_F(Words, StayThroughTidy) {
  const std::string text = std::string(two) + "at voice:\"the  square\"+12f b.radius 2\nb.radius\n" +
                           "  voice:\"we begin\"  1  linear\n  voice:\"square\"#2.end-0.5s   2\n  voice.end 3\n";
  const std::string tidied = tidy(text);
  EXPECT_EQ(tidied, std::string(two) + "at voice:\"the  square\"+12f b.radius 2\nb.radius\n" +
                        "  voice:\"we begin\"           1  linear\n  voice:\"square\"#2.end-0.5s  2\n" +
                        "  voice.end                  3\n");
  EXPECT_EQ(tidy(tidied), tidied);
}

}  // namespace
}  // namespace betwixt

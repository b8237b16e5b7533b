// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words of a recording as times: which times they are, where they can stand, and what is wrong with others.
#include "betwixt/track.h"
#include "language/captions.h"
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

std::vector<std::string> told_captions(const std::vector<Caption>& all) {
  std::vector<std::string> out;
  for (const Caption& c : all) out.push_back(fmt::format("{:.4g} {:.4g} {}", c.start, c.end, c.text));
  return out;
}
std::vector<SpokenWord> spoken(const std::string& text, double each = 0.25) {
  std::vector<SpokenWord> all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const double start = each * static_cast<double>(all.size());
    all.push_back({start, start + each, text.substr(at, end - at)});
    at = end + 1;
  }
  return all;
}

TEST(Captions, EndAtSentencesAndPauses) {
  EXPECT_EQ(told_captions(captions_of(spoken("We begin. Now it turns"))),
            (std::vector<std::string>{"0 0.5 We begin.", "0.5 1.65 Now it turns"}));
  std::vector<SpokenWord> pause = spoken("one two three");
  pause[2].start = 2, pause[2].end = 3;
  EXPECT_EQ(told_captions(captions_of(pause)), (std::vector<std::string>{"0 0.9 one two", "2 3.4 three"}));
}

TEST(Captions, HaveTwoLinesAndAFewWords) {
  const auto all =
      captions_of(spoken("the quick brown fox jumps over the lazy dog and sleeps again because it is night"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].text, "the quick brown fox jumps over the lazy");  // 39 letters, and 40: not 12 words and 4
  EXPECT_EQ(all[1].text, "dog and sleeps again because it is night");
  const auto comma =
      captions_of(spoken("the quick brown fox jumps over the, lazy dog and sleeps again because it is night"));
  ASSERT_EQ(comma.size(), 2u);
  EXPECT_EQ(comma[0].text, "the quick brown fox jumps over the,");
  const auto three = captions_of(spoken("a b c d e f g"), {.words = 3});
  ASSERT_EQ(three.size(), 3u);
  EXPECT_EQ(three[0].text, "a b");
  EXPECT_EQ(three[1].text, "c d e");
  EXPECT_EQ(three[2].text, "f g");
  for (const Caption& c : captions_of(spoken(std::string(10'000, 'w') + " end")))
    EXPECT_LE(c.text.size(), 80u) << c.text;
  EXPECT_EQ(captions_of({}).size(), 0u);
}

TEST(Captions, AreWrittenForPlayers) {
  const std::vector<Caption> all{{0.5, 61.25, "a < b\nand"}, {3661.001, 3662, "c"}};
  EXPECT_EQ(write_srt(all), "1\n00:00:00,500 --> 00:01:01,250\na < b\nand\n\n2\n01:01:01,001 --> 01:01:02,000\nc\n\n");
  EXPECT_EQ(write_webvtt(all),
            "WEBVTT\n\n00:00:00.500 --> 00:01:01.250\na &lt; b\nand\n\n"
            "01:01:01.001 --> 01:01:02.000\nc\n\n");
  EXPECT_EQ(told_captions(captions_between(all, 60, 100)), std::vector<std::string>{"0 1.25 a < b\nand"});
}

TEST_F(Words, AreShownAsCaptions) {
  const Loaded l = load(
      "film flat\ncreate voice sound file=\"talk.wav\" words=\"talk.words\" at=1s\n"
      "captions on voice words=5 size=0.5 color=red weight=bold\n");
  ASSERT_FALSE(has_errors(l.diagnostics)) << said(l.diagnostics);
  const Program program = Program::compile(l.document);
  const auto text = [&](double seconds) {
    const auto target = find_targets("voice-captions.text", l.document);
    return **std::get_if<Text>(&static_cast<const Value&>(program.read(target->front(), from_seconds(seconds))));
  };
  EXPECT_EQ(text(0), "");
  EXPECT_EQ(text(1.4), "");
  EXPECT_EQ(text(1.6), "We begin with a square.");
  EXPECT_EQ(text(3.05), "We begin with a square.");
  EXPECT_EQ(text(3.2), "The square");
  EXPECT_EQ(text(4.1), "The square");
  EXPECT_EQ(text(4.2), "");
  // What it writes is plain content: the same lines by hand give the same document.
  const Loaded again = load(write(l.document));
  EXPECT_FALSE(has_errors(again.diagnostics)) << said(again.diagnostics);
  EXPECT_TRUE(again.document.find("voice-captions"));
}

// The files of captions and the text tracks have what the film shows.
TEST_F(Words, OfCaptionsAreThoseThatTheFilmShows) {
  const std::string sound = "film flat\ncreate voice sound file=\"talk.wav\" words=\"talk.words\"\n";
  const auto told = [&](const std::string& more) {
    std::vector<std::string> all;
    for (const Caption& c : captions_of_film(load(sound + more).document.scene())) all.push_back(c.text);
    return all;
  };
  EXPECT_EQ(told(""), (std::vector<std::string>{"We begin with a square.", "The square"}));
  EXPECT_EQ(told("captions on voice words=3\n"),
            (std::vector<std::string>{"We begin with", "a square.", "The square"}));
  EXPECT_EQ(told("captions on voice\nvoice-captions.text\n  2.1s \"Le carré\"\n"),
            (std::vector<std::string>{"We begin with a square.", "Le carré"}));
}

TEST_F(Words, AreShownBeforeTheCamera) {
  const Loaded l = load(
      "create voice sound file=\"talk.wav\" words=\"talk.words\"\ncreate eye camera position=(0 0 30)\n"
      "captions on voice\n");
  ASSERT_FALSE(has_errors(l.diagnostics)) << said(l.diagnostics);
  const Object& o = l.document.scene().objects[l.document.find("voice-captions").index];
  const auto spans = attachments(o);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].to.parent, l.document.find("eye"));
}

TEST_F(Words, OfCaptionsCanBeWrong) {
  const auto first = [&](const std::string& line) {
    const auto all = errors(load(two + line));
    return all.empty() ? std::string() : all[0];
  };
  EXPECT_EQ(first("captions voice\n"), "3:10: 'on' and the name of a sound are missing here");
  EXPECT_EQ(first("captions on b\n"), "3:13: 'b' is no sound, so it has no words");
  EXPECT_EQ(first("captions on voice words=0\n"), "3:25: the number of words must be a whole number from 1 to 100");
  EXPECT_EQ(first("captions on voice colr=red\n"), "3:19: captions have no 'colr'");
  EXPECT_EQ(first("captions on voice size=0\n"), "3:24: size must be above 0");
  EXPECT_EQ(first("captions on voice color=\n"), "3:25: the value of color is missing here");
  EXPECT_NE(first("captions on voice color=nocolor\n"), "");
  EXPECT_EQ(first("captions on voice\n"), "3:13: captions need a camera above them, or a flat film");
  EXPECT_EQ(first("create c sound file=\"talk.wav\"\ncaptions on c\n"), "4:13: 'c' has no words that are heard");
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Files with the times of words: each format, and what is wrong with a file.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "exchange/files.h"
#include "exchange/words_file.h"

namespace betwixt {
namespace {

class WordFiles : public Files {
 protected:
  // "We 0 0.2|square 0.5 1"
  static std::string said(std::string_view text, const std::string& name = "talk.words") {
    const auto words = read_words(text, name);
    if (!words) return words.error().message;
    std::string all;
    for (const SpokenWord& w : (*words)->words)
      all += fmt::format("{}{} {:.4g} {:.4g}", all.empty() ? "" : "|", w.text, w.start, w.end);
    return all;
  }
};

TEST_F(WordFiles, HaveALineForEachWord) {
  EXPECT_EQ(said("# by hand\n0 0.2 We\n\n  0.5\t1.25  square. \r\n2 2 end"), "We 0 0.2|square. 0.5 1.25|end 2 2");
  EXPECT_EQ(said("\xEF\xBB\xBF"
                 "0 1 Größe\n"),
            "Größe 0 1");
}

TEST_F(WordFiles, CanBeLabelsOfAudacity) {
  EXPECT_EQ(said("0.100000\t0.300000\tWe\n\\\t100.0\t200.0\n0.300000\t0.900000\tbegin\n", "l.txt"),
            "We 0.1 0.3|begin 0.3 0.9");
  // A label of several words is divided by letters, and each has one more for the blank: 3 of 8, 5 of 8.
  EXPECT_EQ(said("1\t9\tin time\n", "l.txt"), "in 1 4|time 4 9");
}

TEST_F(WordFiles, CanBeCues) {
  EXPECT_EQ(said("WEBVTT\n\nNOTE no 00:00:01.000 --> here\n\n1\n00:01.000 --> 00:09.000 align:start\nin <b>time</b>\n\n"
                 "01:00:00.500 --> 01:00:01.500\n&lt;so&gt;\n",
                 "t.vtt"),
            "in 1 4|time 4 9|<so> 3600 3602");
  EXPECT_EQ(
      said("1\n00:00:01,000 --> 00:00:09,000\nin\ntime\n\n2\n00:00:10,250 --> 00:00:11,000\n{\\an8}now\n", "t.srt"),
      "in 1 4|time 4 9|now 10.25 11");
  EXPECT_EQ(said("WEBVTT\n\n00:01.000 --> 00:04.000\nOne <00:00:02.000><c>two</c> <00:02.500>three\n"),
            "One 1 2|two 2 2.5|three 2.5 4");
}

TEST_F(WordFiles, CanBeOfWhisper) {
  EXPECT_EQ(said(R"({"text": " We begin", "segments": [{"id": 0, "start": 0.0, "end": 1.5, "text": " We begin",
      "tokens": [1, 2], "words": [{"word": " We", "start": 0.0, "end": 0.4, "probability": 0.9},
      {"word": " \u201cbegin\u201d", "start": 0.5, "end": 1.5}]}], "language": "en"})",
                 "t.json"),
            "We 0 0.4|“begin” 0.5 1.5");
  EXPECT_EQ(said(R"({"segments": [{"start": 1, "end": 9, "text": "in time"}]})"), "in 1 4|time 4 9");
  EXPECT_EQ(
      said(R"({"words": [{"word": "a", "start": 1, "end": 2}], "segments": [{"start": 1, "end": 2, "text": "a"}]})"),
      "a 1 2");
  EXPECT_EQ(said(R"({"transcription": [{"offsets": {"from": 500, "to": 1500}, "text": " so"}]})"), "so 0.5 1.5");
  EXPECT_EQ(said(R"([{"word": "in", "start": 1, "end": 2}, {"word": "1984"}])"), "in 1 2|1984 2 2");
}

TEST_F(WordFiles, CanBeATextGrid) {
  const std::string grid =
      "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\nxmin = 0\nxmax = 2\ntiers? <exists>\nsize = 2\n"
      "item []:\n  item [1]:\n    class = \"IntervalTier\"\n    name = \"phones\"\n    xmin = 0\n    xmax = 2\n"
      "    intervals: size = 1\n    intervals [1]:\n      xmin = 0\n      xmax = 2\n      text = \"W\"\n"
      "  item [2]:\n    class = \"IntervalTier\"\n    name = \"NAME\"\n    xmin = 0\n    xmax = 2\n"
      "    intervals: size = 2\n    intervals [1]:\n      xmin = 0\n      xmax = 0.5\n      text = \"\"\n"
      "    intervals [2]:\n      xmin = 0.5\n      xmax = 2\n      text = \"say \"\"so\"\"\"\n";
  const auto named = [&](const std::string& name) {
    std::string text = grid;
    return text.replace(text.find("NAME"), 4, name);
  };
  EXPECT_EQ(said(named("words"), "t.TextGrid"), "say 0.5 1.167|\"so\" 1.167 2");
  EXPECT_EQ(said(named("others"), "t.TextGrid"), "W 0 2");
}

TEST_F(WordFiles, SayWhatIsWrongAndWhere) {
  const std::pair<std::string, std::string> wrong[] = {
      {"0 1 a\nnow 2 b\n", "t:2:1: 'now' is not a time in seconds"},
      {"0 1 a\n1\n", "t:2:1: a line is START END WORD, as in 0.52 0.81 square"},
      {"5 6 late\n1 2 early\n", "t:2:1: the words are out of order: 'early' begins before 'late'"},
      {"2 1 back\n", "t:1:3: this word ends before it begins"},
      {"-1 1 a\n", "t:1:1: a word's time must be from 0 to four hours"},
      {"0 14401 a\n", "t:1:1: a word's time must be from 0 to four hours"},
      {"0 nan a\n", "t:1:3: 'nan' is not a time in seconds"},
      {"", "t has no words"},
      {"0 1 \xFF\n", "t:1:5: this is not UTF-8 text"},
      {"WEBVTT\n\n00:01 -> 00:02\na\n\n00:0x:01 --> 00:00:02\na",
       "t:6:1: '00:0x:01' is not a time such as 00:01:02.500"},
      {"WEBVTT\n\n00:02.0 --> 00:01.0\na", "t:3:13: this cue ends before it begins"},
      {"{\"segments\": [{\"start\": }]}", "t:1:25: a number is missing here"},
      {"{\"a\": 1}", "t:1:1: this JSON has neither \"segments\" nor \"words\""},
      {"{\"a\": \"b\n\"}", "t:1:9: this text is not closed"},
      {"File type = \"ooTextFile\"\n",
       "t:1:1: this TextGrid has no tier of intervals; it must be in the long text form"},
      {"0 1 " + std::string(20'001, 'a'), "t:1:1: a word can have at most 20000 bytes"},
  };
  for (const auto& [text, message] : wrong) EXPECT_EQ(said(text, "t"), message) << text.substr(0, 100);
}

TEST_F(WordFiles, AreReadUpToALimit) {
  const auto none = load_words(at("none.words"));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "there is no file '" + at("none.words") + "'");
  std::string deep(100'000, '[');
  EXPECT_EQ(said(deep, "t.json").find("t.json:1:"), 0u);
  std::string many;
  for (int i = 0; i < 1'000'001; ++i) many += "0 0 a\n";
  EXPECT_EQ(said(many, "t"), "t:1000001:1: a recording can have at most 1000000 words");
}

TEST_F(WordFiles, CanHoldAnyBytes) {
  const std::string good[] = {
      "0 1 a\n1 2 b\n", "WEBVTT\n\n00:01.000 --> 00:09.000\nin <00:02.000>time\n",
      R"({"segments": [{"start": 1, "end": 9, "words": [{"word": "a", "start": 1, "end": 2}]}]})",
      "File type = \"ooTextFile\"\nclass = \"IntervalTier\"\nname = \"words\"\nintervals [1]:\n"
      "xmin = 0\nxmax = 1\ntext = \"a\"\n"};
  std::mt19937 random(7);
  for (int i = 0; i < 20'000; ++i) {
    std::string text = good[i % 4];
    for (unsigned n = 1 + random() % 4; n > 0; --n) {
      const std::size_t place = random() % text.size();
      if (random() % 3 == 0)
        text.erase(place, 1 + random() % 5);
      else
        text[place] = "\n\"<>{}[]:,.-0 9\\eN\xC3"[random() % 21];
      if (text.empty()) break;
    }
    const auto words = read_words(text, "t");
    if (!words) continue;
    double last = 0;
    for (const SpokenWord& w : (*words)->words) {
      EXPECT_TRUE(w.start >= last - 1e-5 && w.end >= w.start && w.end <= 14400 && !w.text.empty()) << text;
      last = w.start;
    }
  }
}

TEST_F(WordFiles, AreWrittenAsLines) {
  SpokenWords words;
  words.add({0.1, 0.25, "We"}), words.add({1, 1.5, "begin."});
  EXPECT_EQ(write_words(words), "0.100 0.250 We\n1.000 1.500 begin.\n");
  EXPECT_EQ(said(write_words(words)), "We 0.1 0.25|begin. 1 1.5");
}

}  // namespace
}  // namespace betwixt

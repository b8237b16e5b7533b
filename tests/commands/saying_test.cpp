// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sounds that say a text: create voice sound say="…".
#include "betwixt/track.h"
#include "exchange/said_text.h"
#include "language/captions.h"
#include "scene/document.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

class Saying : public testing::Test {
 protected:
  void SetUp() override {
    const auto tried = say_named("say:en-us:150:hello");
    if (!tried && tried.error().code == ErrorCode::machine) GTEST_SKIP() << tried.error().message;
  }
};

std::string wrong_saying(const std::string& line) {
  for (const Diagnostic& d : read(line + "\n").diagnostics)
    if (d.severity == Severity::error)
      return fmt::format("{} {} ({})", d.what.place.column, d.what.message, d.what.hint);
  return {};
}

TEST_F(Saying, HasWordsThatAreTimes) {
  const Loaded l = read(
      "create voice sound say=\"A square stands on a line.\" at=1s\ncreate b sphere\n"
      "b.radius\n  voice:\"square\" 2\n  voice:\"line\".end 3\n  voice.end 4\n");
  ASSERT_FALSE(has_errors(l.diagnostics)) << said(l.diagnostics);
  std::vector<double> times;
  for (const EventView& e : events(l.document, find_targets("b.radius", l.document)->front()))
    times.push_back(e.time.seconds());
  ASSERT_EQ(times.size(), 3u);
  EXPECT_GT(times[0], 1.0);
  EXPECT_LT(times[0], 1.5);
  EXPECT_GT(times[1], times[0] + 0.5);
  EXPECT_LE(times[1], times[2] + 0.01);
  EXPECT_EQ(captions_of_film(l.document.scene()).size(), 1u);
  EXPECT_EQ(captions_of_film(l.document.scene())[0].text, "A square stands on a line.");
}

TEST_F(Saying, IsWrittenAsItIsSaid) {
  const std::string line = "create voice sound say=\"Hello \\\"you\\\"\" voice=\"en-gb-scotland\" pace=120\n";
  const Loaded l = read(line);
  ASSERT_FALSE(has_errors(l.diagnostics)) << said(l.diagnostics);
  EXPECT_NE(write(l.document).find(line), std::string::npos) << write(l.document);
  EXPECT_EQ(load_text(write(l.document), "").document, l.document);
}

TEST_F(Saying, SlowerTakesLonger) {
  const auto seconds = [](int pace) {
    const auto made = say_named(said_name({"one two three four five six seven", "en-us", pace}));
    return made ? (*made)->sound->seconds : 0;
  };
  EXPECT_GT(seconds(100), 1.5 * seconds(200));
  EXPECT_GT(seconds(200), 0.5);
}

TEST_F(Saying, IsMadeOnce) {
  const auto a = say_named("say:en-us:150:once"), b = say_named("say:en-us:150:once");
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->get(), b->get());
}

TEST_F(Saying, CanBeWrong) {
  EXPECT_EQ(wrong_saying("create v sound say=\"Hello\" voice=\"xx-nope\""),
            "34 espeak-ng has no voice 'xx-nope' (to list the voices: espeak-ng --voices)");
  EXPECT_EQ(wrong_saying("create v sound say=\"Hello\" voice=\"en+nope\""),
            "34 espeak-ng has no voice 'en+nope' (to list the voices: espeak-ng --voices)");
}

TEST(SayingNames, AreChecked) {
  EXPECT_EQ(wrong_saying("create v sound say=\"  \""), "20 the text to say has no words ()");
  EXPECT_EQ(wrong_saying("create v sound say=Hello"), "20 a text in quotes is missing here (as in say=\"Hello\")");
  EXPECT_EQ(wrong_saying("create v sound voice=\"en\""), "10 the text to say is missing (as in say=\"Hello\")");
  EXPECT_EQ(wrong_saying("create v sound say=\"a\" pace=20"),
            "29 a pace is a whole number from 80 to 450 words a minute ()");
  EXPECT_EQ(
      wrong_saying("create v sound say=\"" + std::string(20'001, 'a') + "\""),
      "20 a text to say can have at most 20000 characters; this one has 20001 (make several sounds, each with its "
      "at=)");
  EXPECT_FALSE(read_said_name("say:en/../../x:150:hi;"));
  EXPECT_FALSE(read_said_name("say:en:150"));
  const auto good = read_said_name("say:en:150:a:b");
  ASSERT_TRUE(good);
  EXPECT_EQ(good->text, "a:b");
}

}  // namespace
}  // namespace betwixt

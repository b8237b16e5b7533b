// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the limit of the work that one question or command may cause. It is counted over all parts of the question.
// Without the limit these films would take from minutes to the age of the universe.
#include <algorithm>

#include "base/cancellation.h"
#include "support/loaded_film.h"
#include "track/track.h"

namespace betwixt {
namespace {

const std::string ramp = "rate 24\ncreate a sphere\na.position.x\n  1f 0 linear\n  241f 20 linear\n";

std::string times(int n, const std::string& line) {
  std::string out;
  for (int i = 0; i < n; ++i) out += line + "\n";
  return out;
}
std::vector<std::string> problems(const LoadedFilm& s, std::string_view target, std::string_view time) {
  std::vector<std::string> out;
  const Document& d = s.loaded.document;
  Program::compile(d).read(*find_targets(target, d), *parse_time(time, d), &out);
  return out;
}

// shows: R-T16
TEST(Work, FiltersOnTopOfEachOtherCostTheSumAndStayWhatTheyAre) {
  // The mean of a straight line about a time is the line, however often.
  const LoadedFilm s(ramp + times(12, "filter a.position smooth width=0.2s"));
  for (const double f : {61.0, 100.5, 121.0})
    EXPECT_NEAR(s.numbers("a.position.x", fmt::format("{}f", f))[0], (f - 1) / 12, 1e-9);
  EXPECT_TRUE(problems(s, "a.position.x", "61f").empty());
  // Means of means of a jump: the spline of a higher order, which is symmetrical about it and reaches the ends.
  const LoadedFilm jump("rate 24\ncreate a sphere\na.position.x\n  1f 0 hold\n  121f 1 hold\n" +
                        times(6, "filter a.position smooth width=0.25s"));
  EXPECT_NEAR(jump.numbers("a.position.x", "5s")[0], 0.5, 0.02);
  EXPECT_EQ(jump.numbers("a.position.x", "4.2s")[0], 0);
  EXPECT_EQ(jump.numbers("a.position.x", "5.8s")[0], 1);
  for (const double t : {0.1, 0.2, 0.35}) {
    const double before = jump.numbers("a.position.x", fmt::format("{}s", 5 - t))[0];
    const double after = jump.numbers("a.position.x", fmt::format("{}s", 5 + t))[0];
    EXPECT_NEAR(before + after, 1, 0.03) << t;
  }
}

TEST(Work, CodeThatAsksThriceForTheOneBelowItIsAskedOnceATime) {
  const LoadedFilm s(ramp + "procedure mean filter lua \"(input(t - 0.25) + input(t) + input(t + 0.25)) / 3\"\n" +
                     times(30, "filter a.position mean"));
  EXPECT_NEAR(s.numbers("a.position.x", "121f")[0], 10, 1e-9);  // thirty deep: 3^30 questions
  EXPECT_TRUE(problems(s, "a.position.x", "121f").empty());
}

TEST(Work, TooMuchIsSaidAndTheValueIsWhatItIsWithoutIt) {
  // Grids that have nothing in common: each look of one is 33 others of the next.
  const std::string deep =
      "filter a.position smooth width=0.001s\nfilter a.position smooth width=0.04s\n"
      "filter a.position smooth width=1.7s\nfilter a.position smooth width=71s\n"
      "filter a.position smooth width=3600s\n";
  const LoadedFilm s(ramp + deep);
  const auto said_of = problems(s, "a.position", "121f");
  ASSERT_EQ(said_of.size(), 1u);
  EXPECT_EQ(said_of[0], "a.position takes more than 10000000 steps: its value is shown without code and filters");
  // Whoever asks for it counts all of it, and is cut itself.
  const LoadedFilm two(ramp + "create b sphere\nset b.radius = \"1 + value('a.position.x')\"\n" + deep);
  EXPECT_EQ(two.numbers("b.radius", "121f")[0], 1);
}

TEST(Work, AFrameHasAnEndToo) {
  // Each of many asks the one before it twice, before and after: two to the power of their number.
  std::string text = "rate 24\ncreate o{1..120} sphere\n";
  for (int i = 2; i <= 120; ++i)
    text += fmt::format("set o{}.radius = \"value('o{}.radius', t - 0.1) + value('o{}.radius', t + 0.1)\"\n", i, i - 1,
                        i - 1);
  const Program program = Program::compile(LoadedFilm(text).loaded.document);
  const Frame one = program.frame(Rate{}.frame(24)), two = program.frame(Rate{}.frame(24));
  EXPECT_EQ(one.items.size(), 120u);
  EXPECT_TRUE(
      std::find(one.problems.begin(), one.problems.end(),
                "one frame takes more than 50000000 steps: the remaining values are shown without code and filters") !=
      one.problems.end());
  for (std::size_t i = 0; i < one.items.size(); ++i) EXPECT_EQ(one.items[i].shape->size, two.items[i].shape->size) << i;
}

TEST(Work, CommandsThatRunOthersShareTheirs) {
  const std::string text =
      "procedure inner command lua \"for i = 1, 20000 do end\"\n"
      "procedure outer command lua \"for i = 1, 1000 do run('inner') end\"\n";
  EXPECT_TRUE(all_told(read(text + "inner\n")).empty());
  const auto all = all_told(read(text + "outer\n"));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0], "type 3:1 outer");
  EXPECT_TRUE(mentions(text + "outer\n", "1000000"));
}

TEST(Work, ManyEditsOfAListAreShownTogether) {
  std::string text = "rate 24\nmake m\n  tag t\n  color gold\n  polygon (0 0) (1 0) (0 1)\nstart m\n";
  for (int i = 0; i < 1500; ++i)
    text += fmt::format("at {}f edit m\n  replace t\n  color rgb({} 0 0)\n", i + 2, i / 1500.0);
  const LoadedFilm s(text);
  const auto red = [&](std::string_view time) {
    const Frame f = s.frame(time);
    return f.items.empty() ? -1.0 : to_srgb(f.items[0].color.x);
  };
  for (const int i : {0, 1, 700, 1499}) EXPECT_NEAR(red(fmt::format("{}f", i + 2)), i / 1500.0, 1e-6) << i;
}

TEST(Work, TextsHaveAnEnd) {
  const std::string long_text(20'001, 'x');
  EXPECT_EQ(all_told(read("create a text text=\"" + long_text + "\"\n"))[0], "range 1:20 \"");
  EXPECT_TRUE(all_told(read("create a text text=\"" + long_text.substr(1) + "\"\n")).empty());
  const LoadedFilm s("create a text\nset a.text = \"('x'):rep(30000)\"\n");
  const auto said_of = problems(s, "a.text", "1f");
  ASSERT_EQ(said_of.size(), 1u);
  EXPECT_NE(said_of[0].find("its text has more than 20000 letters"), std::string::npos) << said_of[0];
}

// Lua knows no exceptions: one that went through it left it with less room each time, until it had none.
TEST(Work, CodeIsAsItWasAfterWorkThatWasCalledOff) {
  const std::string text =
      "create a sphere\nprocedure many command lua \"for k = 1, 200 do run('set a.radius ' .. k) end\"\nmany\n";
  const std::atomic<bool> no = false;
  const std::atomic<int> others = 1;
  for (int n = 0; n < 300; ++n) {
    bool called_off = false;
    try {
      const Cancellation wanted(no, no, others, std::chrono::nanoseconds(1));  // it ends with its 64th question
      (void)load_text(text, "film.bx");
    } catch (const Cancelled&) {
      called_off = true;
    }
    ASSERT_TRUE(called_off);
    const Loaded whole = load_text(text, "film.bx");
    ASSERT_TRUE(whole.diagnostics.empty()) << n << "\n" << to_string(whole.diagnostics[0]);
  }
}

}  // namespace
}  // namespace betwixt

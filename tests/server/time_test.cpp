// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The time of a history must continue in the next server. (C97, C133)
#include <charconv>
#include <filesystem>
#include <random>

#include "server/stage.h"

namespace betwixt {
namespace {

std::int64_t number_in(const std::string& answer, const std::string& member) {
  std::int64_t n = INT64_MIN;
  const std::size_t at = answer.find("\"" + member + "\":");
  EXPECT_NE(at, std::string::npos) << answer;
  std::from_chars(answer.data() + at + member.size() + 3, answer.data() + answer.size(), n);
  return n;
}
std::int64_t tick_of(Stage& s, Nanos now = 0) { return number_in(s.say(s.imaging.arrive(), "time", now), "tick"); }

// Slides one to the right every tick, by tick 100.
void slide(Stage& s) {
  const auto host = s.imaging.arrive();
  for (const char* line :
       {"create ball sphere", "set ball.environments (slide)", "animate slide every 1t by translate(1 0 0)"})
    s.done(host, line, tick(10));
  EXPECT_EQ(number_in(s.say(host, "time", tick(100)), "tick"), 100);
  ASSERT_TRUE(s.imaging.sync(tick(100)));
}

TEST(ServerTime, GoesOnAfterAKill) {
  const Folder folder;
  {
    Stage s({}, "", folder / "live.bx");
    slide(s);
  }
  Stage again({}, "", folder / "live.bx");
  const auto host = again.imaging.arrive();
  const std::int64_t first = tick_of(again);
  EXPECT_GE(first, 100);
  EXPECT_LE(first, 160);  // two seconds are left out at most
  // A is M at tick 11, and what moved goes on moving.
  for (const int later : {0, 7}) {
    const std::string answer = again.say(host, "eval ball.world", tick(later));
    EXPECT_TRUE(holds(answer, fmt::format(",{},", first + later - 10))) << answer;
  }
  again.done(host, "halt slide", tick(10));
  EXPECT_TRUE(holds(again.imaging.history(), fmt::format("at {}t halt slide", first + 11))) << again.imaging.history();
}

TEST(ServerTime, IsExactWhereTheServerEndedWell) {
  const Folder folder;
  {
    Stage s({}, "", folder / "live.bx");
    slide(s);
    ASSERT_TRUE(s.imaging.finish(tick(130)));
  }
  EXPECT_FALSE(folder.has(".live.bx.journal"));
  {
    Stage again({}, "", folder / "live.bx");
    EXPECT_EQ(tick_of(again), 130);
    ASSERT_TRUE(again.imaging.finish(tick(5)));
  }
  {  // what a shell or a person has written below it goes on, too
    folder.put("live.bx", folder.get("live.bx") + "create box box\n");
    Stage again({}, "", folder / "live.bx");
    EXPECT_EQ(tick_of(again), 135);
    ASSERT_TRUE(again.imaging.finish());
  }
  folder.put("live.bx", "create ball box\n# another film\n");
  Stage other({}, "", folder / "live.bx");
  EXPECT_EQ(tick_of(other), 0);
}

TEST(ServerTime, StandsWhereItStood) {
  const Folder folder;
  const auto life = [&](const std::vector<std::string>& lines, bool wait = false) {
    Imaging::Options options;
    options.wait = wait;
    Stage s(options, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    const std::string begins = s.say(host, "time");
    for (const std::string& line : lines) s.done(host, line, tick(50));
    EXPECT_TRUE(s.imaging.sync(tick(51)));
    return begins;
  };
  EXPECT_TRUE(holds(life({}, true), "\"seconds\":0,\"slot\":0,\"running\":false"));
  EXPECT_TRUE(holds(life({"start", "pause"}, true), "\"seconds\":0,\"slot\":0,\"running\":false"));
  EXPECT_TRUE(holds(life({"seek 90t"}), "\"seconds\":0,\"slot\":0,\"running\":false"))
      << "it stands without --wait, too";
  EXPECT_TRUE(holds(life({"seek 1.5s"}), "\"seconds\":3,\"slot\":0,\"running\":false"));
  EXPECT_TRUE(holds(life({"go"}), "\"seconds\":1.5,\"slot\":15,\"running\":false"));
  // What went goes on, whatever a server that begins anew would wait for.
  const std::string goes = life({"seek -10s"}, true);
  EXPECT_TRUE(holds(goes, "\"running\":true")) << goes;
  EXPECT_GE(number_in(goes, "tick"), 46);
  EXPECT_LE(number_in(life({}), "tick"), -240);
}

TEST(ServerTime, WithoutItsFileItBeginsAtNothing) {
  const Folder folder;
  {
    Stage s({}, "", folder / "live.bx");
    slide(s);
    s.done(s.imaging.arrive(), "pause", tick(140));
    ASSERT_TRUE(s.imaging.sync());
  }
  const std::string whole = folder.get(".live.bx.time");
  const auto begins = [&](const std::string& text) {
    folder.put(".live.bx.time", text);
    Stage s({}, "", folder / "live.bx");
    EXPECT_EQ(s.imaging.document().scene().objects.size(), 2u);
    return tick_of(s);
  };
  EXPECT_EQ(begins(whole), 140);
  EXPECT_EQ(begins(""), 0);
  EXPECT_EQ(begins("nonsense"), 0);
  // One of its two places is damaged: the other one has it, or what it was before.
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 2);
    EXPECT_GE(begins(changed), 100) << at;
  }
}

TEST(ServerTime, BeginsAnewWhereThatIsAskedFor) {
  const Folder folder;
  {
    Stage s({}, "", folder / "live.bx");
    slide(s);
  }
  Imaging::Options options;
  options.from_start = true;
  Stage again(options, "", folder / "live.bx");
  EXPECT_EQ(tick_of(again), 0);
  EXPECT_EQ(tick_of(again, tick(3)), 3) << "it goes";
}

TEST(ServerTime, IsWrittenAheadNowAndThen) {
  const Folder folder;
  Stage without, s({}, "", folder / "live.bx");
  EXPECT_FALSE(without.imaging.sync_again());
  for (Nanos now = 0; now < 60 * second;) {
    const auto again = s.imaging.sync_again();
    ASSERT_TRUE(again);
    EXPECT_GT(*again, now);
    EXPECT_LE(*again, now + 2 * second);
    const std::string before = folder.get(".live.bx.time");
    ASSERT_TRUE(s.imaging.sync(*again - 1));
    EXPECT_EQ(folder.get(".live.bx.time"), before);
    now = *again;
    ASSERT_TRUE(s.imaging.sync(now));
    EXPECT_NE(folder.get(".live.bx.time"), before);
  }
  s.done(s.imaging.arrive(), "pause", 60 * second);
  EXPECT_FALSE(s.imaging.sync_again());
}

// Whatever is said and whenever it is killed: no time is answered twice, but where a host seeks.
TEST(ServerTime, IsNeverBeforeWhatWasAnswered) {
  std::mt19937 random(7);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const Folder folder;
  std::int64_t answered = 0;
  for (int life = 0; life < 40; ++life) {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    Nanos now = 0;
    for (int k = pick(12); k >= 0; --k) {
      now += pick(1500) * 1'000'000;
      const std::string words[] = {"time",
                                   "go",
                                   "pause",
                                   "start",
                                   fmt::format("create o{}-{} sphere", life, k),
                                   fmt::format("seek {}t", pick(1000))};
      const std::string& said = words[pick(6)];
      const std::int64_t at = number_in(s.say(host, said, now), "tick");
      if (!said.starts_with("seek")) {
        EXPECT_GE(at, answered) << life << " " << said;
      }
      ASSERT_TRUE(s.imaging.sync(now));
      answered = at;
    }
  }
}

}  // namespace
}  // namespace betwixt

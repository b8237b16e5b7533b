// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/stages.h"

#include <gtest/gtest.h>

#include <numeric>
#include <thread>

namespace betwixt {
namespace {

using namespace std::chrono_literals;
constexpr auto beat = 2ms;
constexpr double least = 0.002;

double of(const StageSeconds& s, Stage stage) { return s[static_cast<std::size_t>(stage)]; }

TEST(Stages, HaveTheTimeOfTheirScopesLessThatOfScopesWithin) {
  using Clock = std::chrono::steady_clock;
  const auto begun = Clock::now();
  StageTimes times;
  {
    const InStage draw(Stage::draw);
    std::this_thread::sleep_for(beat);
    {
      const InStage gather(Stage::gather);
      std::this_thread::sleep_for(beat);
    }
    std::this_thread::sleep_for(beat);
  }
  const StageSeconds s = times.take();
  const double all = std::chrono::duration<double>(Clock::now() - begun).count();
  EXPECT_GE(of(s, Stage::draw), 2 * least);
  EXPECT_GE(of(s, Stage::gather), least);
  EXPECT_EQ(of(s, Stage::tracks), 0);
  EXPECT_LE(std::accumulate(s.begin(), s.end(), 0.0), all);  // nothing counts twice
  EXPECT_EQ(of(times.take(), Stage::draw), 0);
}

TEST(Stages, AreHeardByWhoListensOnTheThread) {
  EXPECT_FALSE(StageTimes::listened());
  { const InStage unheard(Stage::tracks); }
  StageTimes outer;
  {
    StageTimes inner;
    const InStage tracks(Stage::tracks);
    std::this_thread::sleep_for(beat);
    EXPECT_GE(of(inner.take(), Stage::tracks), least);
  }
  std::thread([] {
    EXPECT_FALSE(StageTimes::listened());
    const InStage tracks(Stage::tracks);
  }).join();
  EXPECT_EQ(of(outer.take(), Stage::tracks), 0);
}

}  // namespace
}  // namespace betwixt

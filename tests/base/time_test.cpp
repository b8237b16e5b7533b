// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/time.h"

#include <gtest/gtest.h>

#include "betwixt/result.h"

namespace betwixt {
namespace {

TEST(Time, FramesAreWholeFlicksAndComeBack) {
  const std::pair<Rate, std::int64_t> lengths[] = {{{24, 1}, 29'400'000},       {{25, 1}, 28'224'000},
                                                   {{30, 1}, 23'520'000},       {{60, 1}, 11'760'000},
                                                   {{30000, 1001}, 23'543'520}, {{24000, 1001}, 29'429'400}};
  for (const auto& [rate, flicks] : lengths) {
    EXPECT_EQ(flicks * rate.num, flicks_per_second * rate.den);
    for (const std::int64_t n : {-1000L, 0L, 1L, 2L, 3L, 24L, 25L, 1001L, 30000L, 107'892L, 2'589'408L, 100'000'003L}) {
      const Time t = rate.frame(static_cast<double>(n));
      EXPECT_EQ(t.flicks, (n - 1) * flicks);
      EXPECT_EQ(rate.frame_number(t), static_cast<double>(n));
    }
    EXPECT_EQ(rate.frame(1), Time{});
    EXPECT_EQ(rate.frame(24.5).flicks, 23 * flicks + flicks / 2);
  }
}

TEST(Time, FramesThatAreNoWholeFlicksAreNearest) {
  const Rate rate{7, 1};  // 100 800 000 flicks: whole; 11 is not
  EXPECT_EQ(rate.span(3).flicks, 302'400'000);
  const Rate odd{11, 1};
  EXPECT_EQ(odd.span(1).flicks, 64'145'455);  // 64 145 454.54…
  for (int n = 1; n < 1000; ++n) EXPECT_EQ(odd.frame_number(odd.frame(n)), n);
}

TEST(Time, SlowRatesReachFar) {
  const Rate slow{1, 1000};
  EXPECT_EQ(slow.span(1e6).flicks, 705'600'000'000'000'000);
  EXPECT_EQ(slow.frame_number(slow.frame(4e6)), 4e6);
}

TEST(Time, SecondsAreNearestFlicks) {
  EXPECT_EQ(from_seconds(2.5).flicks, 1'764'000'000);
  EXPECT_EQ(from_seconds(-0.001).flicks, -705'600);
  EXPECT_EQ(from_seconds(1e-9).flicks, 1);
  EXPECT_DOUBLE_EQ(Time{1'764'000'000}.seconds(), 2.5);
}

TEST(Diagnostics, ShowThePlace) {
  Diagnostic d;
  d.severity = Severity::error;
  d.what = {ErrorCode::name, "nothing is called 'bal'", "did you mean 'ball'?", {"a.bx", 3, 6, 3}};
  d.line = "\tset bal.color";
  d.caret = 5;
  EXPECT_EQ(to_string(d),
            "a.bx:3:6: error: nothing is called 'bal'\n  \tset bal.color\n  \t    ^~~\n  did you mean 'ball'?\n");
  EXPECT_TRUE(has_errors({d}));
  d.severity = Severity::warning;
  EXPECT_FALSE(has_errors({d}));
}

}  // namespace
}  // namespace betwixt

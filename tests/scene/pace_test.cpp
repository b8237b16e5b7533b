// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/pace.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/told.h"

namespace betwixt {
namespace {

Pace pace(const Timing& t, std::optional<std::int64_t> first = std::nullopt) {
  const Result<Pace> p = Pace::make(t, first);
  EXPECT_TRUE(p) << p.error().message;
  return *p;
}
std::vector<Pace::Row> rows(const Pace& p, std::int64_t until) {
  std::vector<Pace::Row> out;
  for (std::int64_t t = 0; t <= until; ++t)
    if (const Pace::Row r = p.row(t); out.empty() || !(out.back() == r)) out.push_back(r);
  return out;
}

// The thesis' way: an entry waits for its retrace, and is put forward by the interval of that moment.
struct Entry {
  Timing with;
  std::int64_t next, count = 0, now;
  bool listed = true;
  Entry(const Timing& t, std::optional<std::int64_t> first)
      : with(t), next(first.value_or(t.interval)), now(t.interval) {
    if (t.change > 0 && t.interval >= t.ceiling) listed = false;
  }
  void retrace(std::int64_t tick) {
    if (!listed || tick != next) return;
    ++count;
    now = with.interval;
    for (std::int64_t passed = with.period; passed <= tick; passed += with.period) now += with.change;
    if (now < 1) now = 1;
    if (with.change > 0 && now >= with.ceiling) listed = false, now = with.ceiling;
    next = tick + now;
  }
};

void compare(const Timing& t, std::int64_t until, std::optional<std::int64_t> first = std::nullopt) {
  const Pace p = pace(t, first);
  Entry e(t, first);
  for (std::int64_t tick = 0; tick <= until; ++tick) {
    e.retrace(tick);
    const std::int64_t due = e.listed ? e.next : -1;
    if (p.count(tick) == e.count && p.due(tick).value_or(-1) == due && p.interval(tick) == e.now) continue;
    FAIL() << t.interval << " " << t.change << " " << t.period << " " << t.ceiling << " at " << tick << ": "
           << p.count(tick) << " for " << e.count << ", interval " << p.interval(tick) << " for " << e.now;
  }
}

// shows: C135 C136 R-E10
TEST(Pace, RowsAreThoseOfTheRules) {
  using Row = Pace::Row;
  const std::vector<Row> slower{{0, 0, 2}, {30, 15, 3}, {60, 25, 4}, {92, 33, 5}, {122, 39, 6, true}};
  EXPECT_EQ(rows(pace({2, 1, 30, 6}), 1000), slower);
  const std::vector<Row> faster{{0, 0, 5}, {30, 6, 4}, {62, 14, 3}, {92, 24, 2}, {120, 38, 1}};
  EXPECT_EQ(rows(pace({5, -1, 30}), 1000), faster);
}

// shows: C46 C111 R-E7
TEST(Pace, WithoutChangeItIsADivision) {
  for (std::int64_t d : {1LL, 2LL, 30LL, 31LL, 1000LL}) {
    const Pace p = pace({d});
    for (std::int64_t t = 0; t < 3000; ++t) {
      ASSERT_EQ(p.count(t), t / d);
      ASSERT_EQ(p.due(t), (t / d + 1) * d);
      ASSERT_EQ(p.interval(t), d);
    }
  }
}

// shows: C135 C137 C138 R-E10
TEST(Pace, EveryParameterSetIsThatOfATickLoop) {
  int sets = 0;
  for (std::int64_t interval = 1; interval <= 30; ++interval)
    for (std::int64_t change : {-29, -7, -4, -3, -2, -1, 0, 1, 2, 3, 5, 7, 11, 13, 17, 20, 29})
      for (std::int64_t period : {1, 2, 3, 5, 7, 10, 13, 29, 30, 31, 60, 97}) {
        compare({interval, change, period, 30}, 700);
        ++sets;
      }
  EXPECT_EQ(sets, 6120);
}

TEST(Pace, OtherCeilingsAndWhatIsLeftOfAnOlderInterval) {
  for (std::int64_t interval : {1, 2, 5, 9, 40})
    for (std::int64_t change : {-2, -1, 0, 1, 3})
      for (std::int64_t period : {1, 4, 30})
        for (std::int64_t ceiling : {1, 2, 6, 100})
          for (std::int64_t first : {1, 2, 5, 17, 100}) {
            compare({interval, change, period, ceiling}, 1500);
            compare({interval, change, period, ceiling}, 1500, first);
          }
}

// shows: C138
TEST(Pace, ACeilingThatIsReachedAtOnceLeavesNothingToDo) {
  const Pace p = pace({40, 1, 5});
  EXPECT_EQ(p.count(1'000'000), 0);
  EXPECT_EQ(p.due(0), std::nullopt);
  EXPECT_EQ(p.interval(5), 40);
  EXPECT_EQ(pace({40, -1, 5}).due(0), 40);
}

// shows: R-E7
TEST(Pace, LargeNumbersDoNotOverflow) {
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max(), large = Pace::largest;
  EXPECT_EQ(pace({most}).due(0), most);
  EXPECT_EQ(pace({most}).due(most), std::nullopt);
  EXPECT_EQ(pace({most}).count(most), 1);
  EXPECT_EQ(pace({1}).count(most), most);
  EXPECT_EQ(pace({1}).due(most), std::nullopt);
  const Pace faster = pace({large, -large, large});
  EXPECT_EQ(faster.count(large), 1);
  EXPECT_EQ(faster.due(large), large + 1);
  const Pace slower = pace({1, large, 1, large});
  EXPECT_EQ(slower.due(0), 1);
  EXPECT_EQ(slower.due(1), std::nullopt);
  EXPECT_EQ(slower.interval(1), large);
  EXPECT_EQ(pace({1, 1, 1, large}).count(1'000'000), 19);  // at 1, 3, 7, 15, ...
  EXPECT_EQ(pace({large, -1, 1}).count(large + 5), 6);
}

TEST(Pace, WhatCannotBeIsSaidInWords) {
  const auto message = [](const Timing& t) { return Pace::make(t).error().message; };
  EXPECT_EQ(message({0}), "an interval must be at least 1 tick, not 0 ticks");
  EXPECT_EQ(told(Pace::make({-3})), "range");
  EXPECT_TRUE(mentions(Pace::make({-3}), "-3 ticks"));
  EXPECT_EQ(message({1, 1, 0}), "an interval must change every 1 tick or more, not every 0 ticks");
  EXPECT_EQ(message({1, 1, 1, 0}), "a limit must be at least 1 tick, not 0 ticks");
  EXPECT_EQ(message({1, std::numeric_limits<std::int64_t>::min(), 1}),
            "an interval that changes can have at most 1099511627776 ticks, not -9223372036854775808 ticks");
  const Result<Pace> many = Pace::make({1, 1, 1'000'000, 1'000'000});
  EXPECT_EQ(many.error().message, "this interval changes more than 4096 times");
  EXPECT_EQ(many.error().hint, "make each change larger");
}

}  // namespace
}  // namespace betwixt

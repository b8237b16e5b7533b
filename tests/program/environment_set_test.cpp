// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/environment_set.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <bit>
#include <random>

#include "support/environments.h"
#include "support/random.h"

namespace betwixt {
namespace {

using namespace environments;
using Member = EnvironmentSet::Member;
using Range = EnvironmentSet::Range;

const Mat4 turn_about_z = rotation(axis_angle({0, 0, 1}, 1.234));

Member member(std::vector<Event> events, int generation = 0) {
  return {std::make_shared<const Environment>(Environment::compile(std::move(events))), generation};
}
Member steady(std::int64_t tick, std::int64_t interval, const Mat4& m) {
  return member({{tick, 1, every(interval, m)}});
}

// The largest difference, beside the largest number.
double difference(const Mat4& a, const Mat4& b) {
  double most = 0, size = 1;
  for (std::size_t i = 0; i < 16; ++i) {
    most = std::max(most, std::abs(a.m[i] - b.m[i]));
    size = std::max(size, std::abs(b.m[i]));
  }
  return most / size;
}
bool same_bits(const Mat4& a, const Mat4& b) {
  return std::bit_cast<std::array<std::uint64_t, 16>>(a.m) == std::bit_cast<std::array<std::uint64_t, 16>>(b.m);
}
Mat4 asked(const Member& m, std::int64_t tick) { return m.environment->at(m.generation, tick); }

Mat4 turn(Random& r) {
  const double angle = whole(r, 0, 1) ? degree * static_cast<double>(whole(r, -180, 180)) : between(r, -pi, pi);
  return rotation(axis_angle(vector(r, 1), angle));
}
Mat4 about(Vec3 centre, const Mat4& m) { return translation(centre) * m * translation(-centre); }
Mat4 even(double s) { return scaling({s, s, s}); }

Mat4 motion(Random& r) {
  switch (whole(r, 0, 7)) {
    case 0:
      return translation(vector(r, 2));
    case 1:
      return turn(r);
    case 2:
      return about(vector(r, 10), turn(r));
    case 3:
      return translation(vector(r, 1)) * turn(r);
    case 4:
      return about(vector(r, 3), even(between(r, 0.995, 1.005)));
    case 5:
      return translation(vector(r, 1)) * turn(r) * even(between(r, 0.99, 1.01));
    case 6:
      return about(vector(r, 1), even(between(r, 0.5, 2)));
    default:
      return Mat4{};
  }
}
Member any_steady(Random& r) {
  const std::int64_t interval = whole(r, 0, 9) ? whole(r, 1, 30) : whole(r, 31, 5000);
  Animate a = every(interval, motion(r));
  if (!whole(r, 0, 3)) a.from = whole(r, 0, 100);
  return member({{whole(r, -200, 200), 1, a}});
}
// With rarer motions and several events.
Member any(Random& r) {
  if (whole(r, 0, 3)) return any_steady(r);
  std::vector<Event> events;
  std::int64_t tick = whole(r, -100, 100);
  for (std::uint64_t number = 1; number <= static_cast<std::uint64_t>(whole(r, 1, 5)); ++number) {
    Animate a = every(whole(r, 1, 30), motion(r));
    const std::int64_t rare = whole(r, 0, 5);
    if (rare == 0) a.motion = scaling({1, -1, 1}) * a.motion;
    if (rare == 1) a.motion(0, 1) += 0.01;
    if (rare == 2) a.timing.change = whole(r, -2, 2), a.timing.period = whole(r, 1, 40);
    if (rare == 3) a.until = whole(r, 1, 100);
    if (whole(r, 0, 2))
      events.push_back({tick, number, a});
    else if (whole(r, 0, 1))
      events.push_back({tick, number, Halt{}});
    else
      events.push_back({tick, number, Kill{}});
    tick += whole(r, 0, 50);
  }
  return member(std::move(events), static_cast<int>(whole(r, 0, 1)));
}
std::vector<Member> many(std::size_t count, Member (*one)(Random&), std::uint64_t seed) {
  Random r(seed);
  std::vector<Member> all;
  while (all.size() < count) all.push_back(one(r));
  return all;
}
std::vector<Mat4> matrices(const EnvironmentSet& s) {
  std::vector<Mat4> all;
  for (std::size_t i = 0; i < s.size(); ++i) all.push_back(s.matrix(i));
  return all;
}
bool covers(std::span<const Range> ranges, std::size_t slot) {
  return std::any_of(ranges.begin(), ranges.end(), [&](Range r) { return r.begin <= slot && slot < r.end; });
}

TEST(EnvironmentSet, NoneAtAll) {
  EnvironmentSet s({});
  s.seek(5);
  EXPECT_TRUE(s.advance(6).empty());
  EXPECT_EQ(s.next_due(6), std::nullopt);
  EXPECT_EQ(s.next_due(0), std::nullopt);
  EXPECT_EQ(s.slots(), 0u);
}

// shows: R-E2 R-E5
TEST(EnvironmentSet, BeginsAsTheIdentityThenIsEachPowerForOneInterval) {
  EnvironmentSet s({steady(10, 3, step), steady(-5, 3, step), steady(11, 7, step)});
  EXPECT_EQ(s.matrix(1), Mat4{});
  for (std::int64_t t = -20; t < 100; ++t) {
    const auto x = [&](std::int64_t begin, std::int64_t interval) {
      return t < begin ? 0.0 : static_cast<double>((t - begin) / interval + 1);
    };
    s.seek(t);
    EXPECT_EQ(s.matrix(0), translation({x(10, 3), 0, 0}));
    EXPECT_EQ(s.matrix(1), translation({x(-5, 3), 0, 0}));
    EXPECT_EQ(s.matrix(2), translation({x(11, 7), 0, 0}));
  }
}

// shows: R-E15
TEST(EnvironmentSet, EveryValueIsThatOfTheEnvironment) {
  const std::vector<Member> all = many(3000, any, 1);
  EnvironmentSet s(all);
  Random r(2);
  for (int k = 0; k < 60; ++k) {
    // Half of them early, the others up to a thousand million ticks later.
    const auto tick = static_cast<std::int64_t>(std::pow(10, between(r, 0, k % 2 ? 9 : 3))) - 200;
    s.seek(tick);
    for (std::size_t i = 0; i < all.size(); ++i)
      ASSERT_LT(difference(s.matrix(i), asked(all[i], tick)), 1e-12) << "member " << i << " at " << tick;
  }
}

TEST(EnvironmentSet, FarTimesAndBoundsAreThoseOfTheEnvironment) {
  Random r(3);
  std::vector<Member> all = many(200, any, 4);
  const std::int64_t end = Environment::furthest;
  for (std::int64_t tick : {-end, end, std::int64_t{0}})
    for (double size : {1e-9, 1.0, 1e9, 1e15, 1e17, 3e18})
      for (double scale : {0.5, 1 - 1e-7, 1.0, 1 + 1e-7, 2.0})
        all.push_back(steady(tick, whole(r, 1, 50), translation(vector(r, size)) * turn(r) * even(scale)));
  EnvironmentSet s(all);
  for (std::int64_t tick : {-2 * end, -end, -end + 90, std::int64_t{0}, std::int64_t{100}, std::int64_t{5000}, end,
                            end + 1000, 2 * end, 4 * end}) {
    s.seek(tick);
    for (std::size_t i = 0; i < all.size(); ++i)
      ASSERT_LT(difference(s.matrix(i), asked(all[i], tick)), 1e-12) << "member " << i << " at " << tick;
  }
}

// Growing at different speeds, a group comes to the bound one after the other; each alone is in a set of its own.
TEST(EnvironmentSet, WhatGrowsIsHeldWhereTheEnvironmentHoldsItWhateverStandsBesideIt) {
  Random r(11);
  std::vector<Member> all;
  for (int i = 0; i < 60; ++i)
    all.push_back(steady(whole(r, 0, 9), 1, translation(vector(r, 5)) * turn(r) * even(between(r, 0.99, 1.1))));
  for (int i = 0; i < 20; ++i) all.push_back(steady(0, 2, translation(vector(r, 1e14))));
  for (int i = 0; i < 20; ++i) all.push_back(steady(0, 2, translation(vector(r, 1e14)) * turn(r)));
  EnvironmentSet together(all);
  std::vector<EnvironmentSet> alone;
  for (const Member& m : all) alone.emplace_back(std::vector{m});
  for (std::int64_t tick : {300, 380, 400, 430, 435, 440, 500, 700, 1000, 5000, 20'000, 1'000'000, 1'000'000'000}) {
    together.seek(tick);
    for (std::size_t i = 0; i < all.size(); ++i) {
      alone[i].seek(tick);
      ASSERT_LT(difference(together.matrix(i), asked(all[i], tick)), 1e-12) << "member " << i << " at " << tick;
      ASSERT_TRUE(same_bits(together.matrix(i), alone[i].matrix(0))) << "member " << i << " at " << tick;
    }
  }
}

// What is large goes to memory past the caches, and is sought by several threads.
TEST(EnvironmentSet, OfVeryManyEachHasTheBitsItHasAmongFew) {
  const std::vector<Member> all = many(60'000, any, 12);
  EnvironmentSet large(all);
  constexpr std::size_t few = 1000;
  for (std::int64_t tick : {100, 101, 103, 1'000'000}) {
    large.advance(tick);
    for (std::size_t first = 0; first < all.size(); first += few) {
      EnvironmentSet s(
          {all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(first + few)});
      s.seek(tick);
      for (std::size_t i = 0; i < few; ++i)
        ASSERT_TRUE(same_bits(large.matrix(first + i), s.matrix(i))) << "member " << first + i << " at " << tick;
    }
  }
}

TEST(EnvironmentSet, BeginningsFarApartAreInTheirOwnTimes) {
  std::vector<Member> all;
  for (std::int64_t tick : {-1'000'000, -65'537, -65'536, -1, 0, 65'535, 65'536, 200'000})
    all.push_back(steady(tick, 1, step));
  EnvironmentSet s(all);
  for (std::int64_t t : {-1'000'001, -1'000'000, -65'536, -1, 0, 1, 65'535, 65'536, 199'999, 200'000, 3'000'000}) {
    s.seek(t);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::int64_t begin = all[i].environment->event(0).tick;
      EXPECT_EQ(s.matrix(i), translation({t < begin ? 0 : static_cast<double>(t - begin + 1), 0, 0}))
          << i << " at " << t;
    }
  }
}

TEST(EnvironmentSet, WhatShrinksIsHeldWhereTheEnvironmentHoldsIt) {
  const std::vector<Member> all{steady(0, 1, even(0.5)), steady(0, 1, turn_about_z * even(0.99))};
  EnvironmentSet s(all);
  for (std::int64_t tick : {10, 58, 59, 60, 61, 62, 1000, 4000, 4124, 4200, 1'000'000}) {
    s.seek(tick);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k : {0, 1, 5, 10}) {
        const double want = asked(all[i], tick).m[k];
        EXPECT_NEAR(s.matrix(i).m[k], want, 1e-12 * std::abs(want)) << i << " at " << tick;
      }
  }
}

// shows: C52b C112 C115 C118 C119 C126 R-E7 R-E8
TEST(EnvironmentSet, AdvancingGivesTheBitsOfSeekingAndTouchesWhatIsDue) {
  const std::vector<Member> all = many(500, any, 5);
  EnvironmentSet played(all), sought(all);
  Random r(6);
  std::int64_t tick = -400;
  played.seek(tick);
  while (tick < 1500) {
    const std::vector<Mat4> before = matrices(played);
    const std::int64_t last = tick;
    tick += whole(r, 0, 9) ? 1 : whole(r, 0, 50);
    const auto changed = played.advance(tick);
    std::vector<Range> ranges(changed.begin(), changed.end());
    sought.seek(tick);
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_TRUE(same_bits(played.matrix(i), sought.matrix(i))) << "member " << i << " at " << tick;
      if (covers(ranges, played.slot(i))) continue;
      ASSERT_TRUE(same_bits(played.matrix(i), before[i])) << "member " << i << " was not said to change at " << tick;
    }
    std::sort(ranges.begin(), ranges.end(), [](Range a, Range b) { return a.begin < b.begin; });
    for (std::size_t k = 1; k < ranges.size(); ++k) ASSERT_LE(ranges[k - 1].end, ranges[k].begin);
    ASSERT_TRUE(tick != last || ranges.empty());
  }
}

TEST(EnvironmentSet, GoingBackIsSeeking) {
  const std::vector<Member> all = many(100, any, 7);
  EnvironmentSet s(all), other(all);
  s.seek(1000);
  const auto changed = s.advance(300);
  EXPECT_EQ(std::vector(changed.begin(), changed.end()), (std::vector<Range>{{0, s.slots()}}));
  other.seek(300);
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(same_bits(s.matrix(i), other.matrix(i)));
}

// shows: C114 C115 C116 C117
TEST(EnvironmentSet, OnlyGroupsThatAreDueAreTouched) {
  std::vector<Member> all;
  for (int i = 0; i < 8; ++i) all.push_back(steady(0, 10, step));
  for (int i = 0; i < 8; ++i) all.push_back(steady(40, 10, step));  // the same phase
  for (int i = 0; i < 8; ++i) all.push_back(steady(3, 10, step));
  for (int i = 0; i < 8; ++i) all.push_back(steady(0, 4, step));
  EnvironmentSet s(all);
  EXPECT_EQ(s.slots(), 32u);
  s.seek(100);
  std::size_t touched = 0;
  for (std::int64_t t = 101; t <= 120; ++t)
    for (Range r : s.advance(t)) touched += r.end - r.begin;
  EXPECT_EQ(touched, 2u * 16 + 2 * 8 + 5 * 8);
  std::vector<std::size_t> together;
  for (std::size_t i = 0; i < 16; ++i) together.push_back(s.slot(i));
  const auto [first, last] = std::minmax_element(together.begin(), together.end());
  EXPECT_EQ(*last - *first, 15u);
}

TEST(EnvironmentSet, TheNextUpdateIsTheFirstOfAll) {
  const std::vector<Member> all = many(12, any, 8);
  EnvironmentSet s(all);
  for (std::int64_t t = -300; t < 600; ++t) {
    std::optional<std::int64_t> want;
    for (const Member& m : all) {
      const auto due = m.environment->next_due(t);
      if (!due || m.environment->generation_at(*due).value_or(0) > m.generation) continue;
      want = std::min(*due, want.value_or(*due));
    }
    ASSERT_EQ(s.next_due(t), want) << "from elsewhere, after " << t;
    s.advance(t);
    ASSERT_EQ(s.next_due(t), want) << "after " << t;
  }
}

TEST(EnvironmentSet, WhatHasEndedIsNeverDue) {
  Animate slowing = every(1, step);
  slowing.timing = {.interval = 1, .change = 1, .period = 1, .ceiling = 5};
  const Member again = member({{0, 1, every(1, step)}, {3, 2, Kill{}}, {50, 3, every(1, step)}});
  EnvironmentSet s({member({{0, 1, slowing}}), member({{0, 1, every(2, step)}, {9, 2, Halt{}}}), again});
  s.seek(40);
  EXPECT_EQ(s.next_due(40), std::nullopt);
  EXPECT_TRUE(s.advance(1000).empty());
  EXPECT_EQ(s.matrix(2), translation({4, 0, 0}));
}

TEST(EnvironmentSet, EverySlotHasItsMemberOrNone) {
  const std::vector<Member> all = many(1000, any, 9);
  const EnvironmentSet s(all);
  std::size_t found = 0;
  for (std::size_t slot = 0; slot < s.slots(); ++slot) {
    const auto m = s.member(slot);
    if (!m) continue;
    EXPECT_EQ(s.slot(*m), slot);
    ++found;
  }
  EXPECT_EQ(found, all.size());
}

// shows: R-E15
TEST(EnvironmentSet, ATurnOfAThousandMillionTicksIsRight) {
  EnvironmentSet s({steady(0, 1, rotation(axis_angle({0, 0, 1}, 7 * degree))),
                    steady(0, 1, about({1, 2, 3}, rotation(axis_angle({0, 1, 0}, 7 * degree))))});
  const std::int64_t tick = 1'000'000'000;
  s.seek(tick);
  const Quat z = axis_angle({0, 0, 1}, degree * static_cast<double>(7 * (tick + 1) % 360));
  const Quat y = axis_angle({0, 1, 0}, degree * static_cast<double>(7 * (tick + 1) % 360));
  EXPECT_LT(difference(s.matrix(0), rotation(z)), 1e-9);
  EXPECT_LT(difference(s.matrix(1), about({1, 2, 3}, rotation(y))), 1e-9);
}

TEST(EnvironmentSet, TheSineIsGoodToTheLastDigits) {
  // An angle of the environment's is a number of 2^-64 turns: in long double it is nearly exact.
  const Member m = steady(0, 1, rotation(axis_angle({0, 0, 1}, 1.2345)));
  EnvironmentSet s({m});
  const std::uint64_t turns = m.environment->span(0, 0)->motion->power.similarity().turns;
  long double most = 0;
  for (std::int64_t t = 0; t < 20000; ++t) {
    s.seek(t);
    const std::uint64_t angle = static_cast<std::uint64_t>(t + 1) * turns;
    const long double x =
        std::ldexp(static_cast<long double>(static_cast<std::int64_t>(angle)), -63) * std::numbers::pi_v<long double>;
    const Mat4 a = s.matrix(0);
    most = std::max({most, std::abs(a(1, 0) - std::sin(x)), std::abs(a(0, 0) - std::cos(x))});
  }
  EXPECT_LT(most, 2.5e-16);
}

TEST(EnvironmentSet, TheBitsAreTheSameOnEveryKindOfMachine) {
  const std::vector<Member> all = many(2000, any_steady, 10);
  const std::vector<std::int64_t> kinds = hwy::SupportedAndGeneratedTargets();
  for (std::int64_t tick : {50, 4321, 123'456'789}) {
    std::vector<Mat4> want;
    for (std::int64_t kind : kinds) {
      hwy::SetSupportedTargetsForTest(kind);
      hwy::GetChosenTarget().Update(kind);
      EnvironmentSet s(all);
      s.seek(tick);
      if (want.empty()) want = matrices(s);
      for (std::size_t i = 0; i < all.size(); ++i)
        ASSERT_TRUE(same_bits(s.matrix(i), want[i])) << "member " << i << ", " << hwy::TargetName(kind);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/environment.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>
#include <thread>

#include "support/environments.h"
#include "support/thesis_animator.h"

namespace betwixt {
namespace {

using namespace environments;

const Mat4 turn = rotation(axis_angle({0, 0, 1}, 90 * degree));

Animate between(std::optional<std::int64_t> from, std::optional<std::int64_t> until, Animate a) {
  a.from = from, a.until = until;
  return a;
}
double x_at(const Environment& e, std::int64_t tick, int generation = 0) { return e.at(generation, tick)(0, 3); }
double difference(const Mat4& a, const Mat4& b) {
  double most = 0;
  for (std::size_t i = 0; i < 16; ++i) most = std::max(most, std::abs(a.m[i] - b.m[i]));
  return most;
}
std::string refused(Environment e, const Event& event) {
  const Status s = e.add(event);
  return s ? "" : s.error().message;
}

// shows: C42 C43 C53 C82 C110 R-E2 R-E5 R-E6
TEST(Environment, BeginsAsTheIdentityThenIsEachPowerForOneInterval) {
  const Environment e = Environment::compile({{10, 1, every(3, step)}});
  EXPECT_EQ(e.at(0, 9), Mat4{});
  for (std::int64_t t = 10; t < 100; ++t) {
    EXPECT_EQ(x_at(e, t), static_cast<double>((t - 10) / 3 + 1));
    EXPECT_EQ(e.count(0, t), (t - 10) / 3);
    EXPECT_EQ(e.next_due(t), 10 + ((t - 10) / 3 + 1) * 3);
  }
  EXPECT_EQ(e.next_due(-5), 10);
  EXPECT_EQ(e.generation_at(9), std::nullopt);
  EXPECT_EQ(e.generation_at(10), 0);
  EXPECT_EQ(e.matrix(9), std::nullopt);
  EXPECT_EQ(e.matrix(10), step);
  EXPECT_EQ(e.interval(12), 3);
  EXPECT_EQ(e.at(7, 50), Mat4{});
}

// shows: C59 R-E2
TEST(Environment, OfEqualIntervalsNestAsAProductOfPowers) {
  const Environment outer = Environment::compile({{0, 1, every(2, step)}});
  const Environment inner = Environment::compile({{0, 1, every(2, turn)}});
  for (std::int64_t n = 0; n < 20; ++n) {
    const Mat4 want = translation({static_cast<double>(n + 1), 0, 0}) *
                      rotation(axis_angle({0, 0, 1}, 90 * degree * static_cast<double>((n + 1) % 4)));
    EXPECT_LT(difference(outer.at(0, 2 * n) * inner.at(0, 2 * n), want), 1e-15);
  }
}

// shows: R-E3
TEST(Environment, ANewMotionActsInTheAxesOfTheMovedObject) {
  // A quarter turn, then steps along x: the object's own x axis looks along y by now.
  const Environment e = Environment::compile({{0, 1, every(100, turn)}, {5, 2, every(1, step)}});
  EXPECT_LT(length(transform_point(e.at(0, 8), {}) - Vec3{0, 3, 0}), 1e-15);
  EXPECT_LT(difference(e.at(0, 8), turn * translation({3, 0, 0})), 1e-15);
}

// shows: C86 C87 R-E4
TEST(Environment, AnotherAnimateKeepsWhereItIsAndForgetsWhatIsLeftOfTheInterval) {
  const Environment e = Environment::compile({{0, 1, every(10, step)}, {14, 2, every(4, translation({0, 1, 0}))}});
  EXPECT_EQ(translation_of(e.at(0, 17)), (Vec3{2, 0, 0}));
  EXPECT_EQ(translation_of(e.at(0, 18)), (Vec3{2, 1, 0}));
  Animate keep = every(4, translation({0, 1, 0}));
  keep.keep_phase = true;
  const Environment k = Environment::compile({{0, 1, every(10, step)}, {14, 2, keep}});
  EXPECT_EQ(k.next_due(14), 20);
  EXPECT_EQ(translation_of(k.at(0, 20)), (Vec3{2, 1, 0}));
  EXPECT_EQ(k.next_due(20), 24);
}

// shows: R-E4
TEST(Environment, IsWarnedAboutOnceWhenAnimatesComeTooFast) {
  std::vector<Event> events;
  for (std::int64_t t = 0; t < 100; ++t) events.push_back({t, static_cast<std::uint64_t>(t), every(2, step)});
  const Environment e = Environment::compile(events);
  EXPECT_EQ(e.count(0, 99), 0);
  EXPECT_EQ(x_at(e, 99), 1);
  ASSERT_EQ(e.problems().size(), 1U);
  EXPECT_EQ(e.problems()[0].number, 1U);
  EXPECT_EQ(e.problems()[0].severity, Severity::warning);
  EXPECT_EQ(e.problems()[0].what.message,
            "this animate comes before the first update of the previous one; if it repeats like this, nothing moves");
  for (Event& event : events) std::get<Animate>(event.what).keep_phase = true;
  const Environment kept = Environment::compile(events);
  EXPECT_EQ(kept.count(0, 99), 49);
  EXPECT_TRUE(kept.problems().empty());
}

// shows: C88 C90 C91 C92 R-E1b R-E9
TEST(Environment, UpdatesComeBeforeTheEventsOfTheirTick) {
  const Environment e = Environment::compile({{0, 1, every(5, step)}, {10, 2, Halt{}}, {30, 3, every(5, step)}});
  EXPECT_EQ(x_at(e, 9), 2);
  EXPECT_EQ(x_at(e, 10), 3);
  EXPECT_EQ(x_at(e, 34), 3);
  EXPECT_EQ(x_at(e, 35), 4);
  EXPECT_EQ(e.next_due(10), 35);
  EXPECT_EQ(e.matrix(20), step);
  EXPECT_EQ(e.interval(20), 5);
}

// shows: C88 C92 C138 R-E9b
TEST(Environment, AHaltedOneRemembersTheIntervalThatRan) {
  Animate slower = every(2, step);
  slower.timing = {2, 1, 30, 6};
  const Environment e = Environment::compile({{0, 1, slower}, {70, 2, Halt{}}});
  EXPECT_EQ(e.interval(29), 2);
  EXPECT_EQ(e.interval(65), 4);
  EXPECT_EQ(e.interval(1000), 4);
  EXPECT_EQ(e.next_due(70), std::nullopt);
  const Environment stopped = Environment::compile({{0, 1, slower}});
  EXPECT_EQ(stopped.count(0, 121), 38);
  EXPECT_EQ(stopped.count(0, 1'000'000), 39);
  EXPECT_EQ(stopped.next_due(122), std::nullopt);
  EXPECT_EQ(stopped.interval(500), 6);
}

// shows: C94 C95 C96 R-E9
TEST(Environment, AKilledNameMayBeUsedAgainAndTheOldStays) {
  const Environment e =
      Environment::compile({{0, 1, every(1, step)}, {5, 2, Kill{}}, {8, 3, every(1, translation({0, 1, 0}))}});
  EXPECT_EQ(e.generations(), 2);
  EXPECT_EQ(x_at(e, 1000), 6);
  EXPECT_EQ(translation_of(e.at(1, 10)), (Vec3{0, 3, 0}));
  EXPECT_EQ(e.generation_at(4), 0);
  EXPECT_EQ(e.generation_at(5), std::nullopt);
  EXPECT_EQ(e.generation_at(8), 1);
  EXPECT_EQ(e.matrix(6), std::nullopt);
  EXPECT_EQ(e.interval(6), std::nullopt);
  EXPECT_EQ(e.next_due(5), 8);
  // Sites: before any, in the first life, after the Kill; by their numbers within its tick.
  EXPECT_EQ(e.bind(std::numeric_limits<std::int64_t>::min()), 0);
  EXPECT_EQ(e.bind(3), 0);
  EXPECT_EQ(e.bind(5, 1), 0);
  EXPECT_EQ(e.bind(5), 1);
  EXPECT_EQ(e.bind(100), 1);
  EXPECT_EQ(Environment::compile({{0, 1, every(1, step)}, {5, 2, Kill{}}}).bind(5), std::nullopt);
  EXPECT_EQ(Environment().bind(0), std::nullopt);
}

// shows: C143 C144 C145 R-E11
TEST(Environment, StartsAndStopsLater) {
  const Environment e = Environment::compile({{10, 1, between(20, 26, every(2, step))}});
  EXPECT_EQ(e.generation_at(10), 0);
  EXPECT_EQ(e.matrix(10), step);
  EXPECT_EQ(e.interval(10), 2);
  EXPECT_EQ(e.at(0, 29), Mat4{});
  EXPECT_EQ(e.next_due(10), 30);
  EXPECT_EQ(x_at(e, 30), 1);
  EXPECT_EQ(x_at(e, 36), 4);
  EXPECT_EQ(x_at(e, 1000), 4);
  EXPECT_EQ(e.next_due(36), std::nullopt);
  // Neither a later Animate nor a Halt undoes it.
  Environment more = e;
  EXPECT_TRUE(more.add({12, 2, every(1, translation({0, 1, 0}))}));
  EXPECT_TRUE(more.add({20, 3, Halt{}}));
  EXPECT_EQ(translation_of(more.at(0, 25)), (Vec3{0, 9, 0}));
  EXPECT_EQ(translation_of(more.at(0, 30)), (Vec3{0, 9, 0}));  // A is kept
  EXPECT_EQ(translation_of(more.at(0, 36)), (Vec3{3, 9, 0}));
  EXPECT_EQ(translation_of(more.at(0, 99)), (Vec3{3, 9, 0}));
  // Cancel and Kill do; what has happened has happened.
  EXPECT_TRUE(more.add({31, 4, Cancel{}}));
  EXPECT_EQ(translation_of(more.at(0, 40)), (Vec3{5, 9, 0}));
  Environment killed = e;
  EXPECT_TRUE(killed.add({29, 2, Kill{}}));
  EXPECT_EQ(killed.at(0, 1000), Mat4{});
  EXPECT_EQ(killed.next_due(0), std::nullopt);
  Environment cancelled = e;
  EXPECT_TRUE(cancelled.add({30, 2, Cancel{}}));
  EXPECT_EQ(x_at(cancelled, 40), 6);
}

// shows: R-E15
TEST(Environment, ARotationIsRightAfterAThousandMillionTicks) {
  const Mat4 seven = rotation(axis_angle({0, 0, 1}, 7 * degree));
  const Environment e = Environment::compile({{0, 1, every(1, seven)}});
  const double left = 7'000'000'007 % 360;
  EXPECT_LT(difference(e.at(0, 1'000'000'000), rotation(axis_angle({0, 0, 1}, left * degree))), 1e-9);
}

// shows: R-E1d
TEST(Environment, SmoothMotionGoesThroughTheSteps) {
  const Environment e = Environment::compile({{0, 1, every(4, step)}, {40, 2, every(2, scaling({2, 1, 1}))}});
  EXPECT_EQ(e.smooth(0, -0.5), Mat4{});
  EXPECT_EQ(e.smooth(0, 8.0)(0, 3), 3);
  EXPECT_EQ(e.smooth(0, 9.0)(0, 3), 3.25);
  EXPECT_EQ(e.smooth(0, 9.5)(0, 3), 3.375);
  EXPECT_EQ(e.smooth(0, 43.5), e.at(0, 43));
}

TEST(Environment, WhatGrowsTooLargeIsHeld) {
  const Mat4 turn = rotation(axis_angle({0, 1, 1}, 0.3));
  const Environment e = Environment::compile({{0, 1, every(1, scaling({2, 2, 2}))}, {100, 2, every(1, turn)}});
  EXPECT_FALSE(e.clamped(0, 50));
  EXPECT_TRUE(e.clamped(0, 99));
  EXPECT_TRUE(std::isfinite(e.at(0, 1'000'000)(0, 0)));
  EXPECT_TRUE(e.problems().empty());
}

TEST(Environment, WhatMeansNothingIsRefusedInWords) {
  const Environment none;
  EXPECT_EQ(refused(none, {3, 1, Halt{}}), "there is nothing to halt: it has not been animated before this");
  const Environment gone = Environment::compile({{0, 1, every(1, step)}, {5, 2, Kill{}}});
  EXPECT_EQ(refused(gone, {6, 3, Kill{}}), "there is nothing to kill: it has not been animated since it was killed");
  EXPECT_EQ(refused(gone, {6, 3, Cancel{}}),
            "there is nothing to cancel: it has not been animated since it was killed");
  EXPECT_EQ(refused(gone, {-1, 3, Halt{}}), "there is nothing to halt: it has not been animated before this");
  EXPECT_EQ(refused(gone, {3, 3, Halt{}}), "");
  EXPECT_EQ(refused(none, {0, 1, every(0, step)}), "an interval must be at least 1 tick, not 0 ticks");
  EXPECT_EQ(refused(none, {0, 1, between(5, 5, every(1, step))}),
            "an environment must halt after it starts: until 5t is not after from 5t");
  EXPECT_EQ(refused(none, {0, 1, between({}, 0, every(1, step))}),
            "an environment must halt after its animate, not after 0t");
  EXPECT_EQ(refused(none, {0, 1, between(-1, {}, every(1, step))}), "an environment cannot start before its animate");
  EXPECT_EQ(refused(none, {0, 1, between(INT64_MAX, {}, every(1, step))}),
            "a start or a stop is too far in the future");
  EXPECT_EQ(refused(none, {INT64_MIN, 1, every(1, step)}), "this time is too far away");
  Mat4 broken;
  broken(1, 2) = std::nan("");
  EXPECT_EQ(refused(none, {0, 1, every(1, broken)}), "the matrix of a motion has an element that is not finite");
  const Environment e = Environment::compile({{5, 7, Halt{}}, {6, 8, every(1, step)}});
  ASSERT_EQ(e.problems().size(), 1U);
  EXPECT_EQ(e.problems()[0].number, 7U);
  EXPECT_EQ(x_at(e, 6), 1);
}

TEST(Environment, AnyTickCanBeAskedFor) {
  const std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();
  Environment e =
      Environment::compile({{-Environment::furthest, 1, every(high, step)},
                            {0, 2, every(1, turn)},
                            {Environment::furthest, 3, between(Environment::furthest, {}, every(1, step))}});
  for (std::int64_t t :
       {low, low + 1, -Environment::furthest, std::int64_t{0}, Environment::furthest, high - 1, high}) {
    for (double v : e.at(0, t).m) EXPECT_TRUE(std::isfinite(v));
    e.next_due(t), e.bind(t), e.interval(t), e.matrix(t), e.count(0, t), e.smooth(0, static_cast<double>(t));
  }
  EXPECT_EQ(e.smooth(0, std::nan("")), Mat4{});
}

TEST(Environment, CopiesGoTheirOwnWays) {
  Environment trunk;
  std::vector<Environment> kept;
  for (std::int64_t i = 0; i < 300; ++i) {
    ASSERT_TRUE(trunk.add({i, static_cast<std::uint64_t>(i), every(1, step)}));
    kept.push_back(trunk);
    Environment branch = trunk;  // takes the place that the trunk would have gone on in
    ASSERT_TRUE(branch.add({i, 1000, every(1, translation({0, 1, 0}))}));
    EXPECT_EQ(translation_of(branch.at(0, i + 4)), (Vec3{static_cast<double>(i + 1), 4, 0}));
  }
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(kept[i].size(), i + 1);
    EXPECT_EQ(x_at(kept[i], 500), 501);
  }
}

// shows: R-E14
TEST(Environment, IsReadWhileItsSuccessorsAreMade) {
  Environment e = Environment::compile({{0, 0, between(1'000'000, {}, every(1, turn))}, {0, 0, every(1, step)}});
  std::vector<std::thread> readers;
  for (std::int64_t i = 1; i <= 2000; ++i) {
    ASSERT_TRUE(e.add({i, 0, every(1, step)}));
    if (i % 500 != 0) continue;
    for (int reader = 0; reader < 2; ++reader)
      readers.emplace_back([e, i] {
        for (std::int64_t t = 0; t < i; ++t) EXPECT_EQ(x_at(e, t), static_cast<double>(t + 1));
        EXPECT_EQ(e.next_due(999'999), 1'000'000);
      });
  }
  for (std::thread& t : readers) t.join();
}

// ---- Against the thesis' own way

class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  std::int64_t whole(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  double number(double low, double high) { return low + (high - low) * static_cast<double>(engine_()) * 0x1p-64; }
  bool one_in(std::int64_t n) { return whole(1, n) == 1; }
  Vec3 vector(double size) { return {number(-size, size), number(-size, size), number(-size, size)}; }

  Mat4 motion() {
    const Mat4 shift = translation(vector(1)), spin = rotation(axis_angle(vector(1), number(-4, 4)));
    const double s = 1 + (one_in(2) ? 1 : -1) * number(0.001, 0.01);  // not so little that it is taken for rounding
    switch (whole(0, 7)) {
      case 0:
        return shift;
      case 1:
        return rotation(axis_angle({0, 0, 1}, static_cast<double>(whole(1, 359)) * degree));
      case 2:
        return spin;
      case 3:
        return shift * spin;
      case 4:
        return shift * spin * scaling({s, s, s});
      case 5:
        return shift * spin * scaling({1, -1, 1});
      case 6:
        return shift * scaling({s, 1, 1 / s}) * rotation(axis_angle(vector(1), number(-0.1, 0.1)));
      default: {
        Mat4 m;
        for (double& e : m.m) e += number(-1e-3, 1e-3);
        return m;
      }
    }
  }
  Animate animate() {
    Animate a = every(whole(1, one_in(4) ? 70 : 8), motion());
    if (one_in(3)) a.timing = {whole(1, 35), whole(-5, 5), whole(1, 40), whole(1, 40)};
    a.keep_phase = one_in(4);
    if (one_in(4)) a.from = whole(0, 60);
    if (one_in(4)) a.until = a.from.value_or(0) + whole(1, 80);
    return a;
  }
  std::vector<Event> history(std::int64_t length) {
    std::vector<Event> events;
    const std::int64_t many = whole(1, 14);
    for (std::int64_t i = 0; i < many; ++i) {
      Event e{whole(-length / 4, length), static_cast<std::uint64_t>(i), {}};
      if (one_in(4) && !events.empty()) e.tick = events.back().tick;
      const std::int64_t kind = whole(0, 9);
      if (kind < 6)
        e.what = animate();
      else if (kind < 8)
        e.what = Halt{};
      else if (kind < 9)
        e.what = Kill{};
      else
        e.what = Cancel{};
      events.push_back(std::move(e));
    }
    return events;
  }

 private:
  std::mt19937_64 engine_;
};

thesis::Order order(const Event& e) {
  thesis::Order o;
  o.tick = e.tick, o.number = e.number;
  if (std::holds_alternative<Halt>(e.what)) o.kind = thesis::Order::halt;
  if (std::holds_alternative<Kill>(e.what)) o.kind = thesis::Order::kill;
  if (std::holds_alternative<Cancel>(e.what)) o.kind = thesis::Order::cancel;
  if (const auto* a = std::get_if<Animate>(&e.what)) {
    // Row vectors row by row are column vectors column by column.
    std::copy(a->motion.m.begin(), a->motion.m.end(), o.motion.begin());
    o.interval = a->timing.interval, o.change = a->timing.change;
    o.period = a->timing.period, o.ceiling = a->timing.ceiling;
    o.keep_phase = a->keep_phase, o.from = a->from, o.until = a->until;
  }
  return o;
}

// How far two matrices are apart, in parts of the larger of 1 and the largest element.
double apart(const Mat4& a, const thesis::Matrix& b) {
  double most = 0, size = 1;
  for (std::size_t i = 0; i < 16; ++i) {
    most = std::max(most, static_cast<double>(std::abs(a.m[i] - b[i])));
    size = std::max(size, static_cast<double>(std::abs(b[i])));
  }
  return most / size;
}

std::optional<int> bound_to(const thesis::Animator& a, std::int64_t tick, std::uint64_t number) {
  int born = 0;
  bool living = false;
  for (const auto& life : a.lives) {
    if (life.at > std::pair(tick, number)) break;
    living = life.birth;
    if (living) ++born;
  }
  if (living) return born - 1;
  return born < static_cast<int>(a.entries.size()) ? std::optional(born) : std::nullopt;
}

struct Tally {
  std::int64_t seeks = 0, wrong = 0;
  double worst = 0;
};

void seek(const Environment& e, const thesis::Animator& a, std::int64_t tick, Tally& tally) {
  ++tally.seeks;
  const int generations = static_cast<int>(a.entries.size());
  bool good = e.generation_at(tick) == (a.known ? std::optional(generations - 1) : std::nullopt);
  for (int g = 0; g < generations; ++g) {
    const auto& entry = a.entries[static_cast<std::size_t>(g)];
    good = good && e.count(g, tick) == entry.updates;
    tally.worst = std::max(tally.worst, apart(e.at(g, tick), entry.a));
  }
  if (a.known) {
    const auto& entry = a.entries.back();
    good = good && e.interval(tick) == entry.interval && apart(*e.matrix(tick), entry.motion) == 0;
  }
  if (!good) ++tally.wrong;
}

// Plays a history through, looking at some ticks on the way; then at what can be told of the future only afterwards.
void play(unsigned seed, Tally& tally) {
  Dice dice(seed);
  const std::int64_t length = dice.whole(20, 400), begin = -length / 4 - 5, end = length + 250;
  const std::vector<Event> events = dice.history(length);
  const Environment e = Environment::compile(events);
  std::vector<thesis::Order> orders;
  for (const Event& event : events) orders.push_back(order(event));
  thesis::Animator a(orders, begin);
  std::vector<bool> changed;
  while (a.tick() <= end) {
    a.retrace();
    changed.push_back(a.changed);
    if (dice.one_in(8)) seek(e, a, a.tick() - 1, tally);
  }
  for (int i = 0; i < 20; ++i) {
    const std::int64_t tick = dice.whole(begin, end);
    std::int64_t next = tick + 1;
    while (next <= end && !changed[static_cast<std::size_t>(next - begin)]) ++next;
    const std::int64_t due = e.next_due(tick).value_or(end + 1);
    if (std::min(due, end + 1) != next) ++tally.wrong;
    const auto number = static_cast<std::uint64_t>(dice.whole(0, 14));
    if (e.bind(tick, number) != bound_to(a, tick, number)) ++tally.wrong;
  }
  std::vector<std::uint64_t> refused;
  std::optional<std::uint64_t> starved;
  for (const auto& p : e.problems()) {
    if (p.severity == Severity::error) refused.push_back(p.number);
    if (p.severity == Severity::warning) starved = p.number;
  }
  if (refused != a.refused || starved != a.starved) ++tally.wrong;
}

// shows: C54 C135 C143 R-E4 R-E9 R-E11
TEST(Environment, RandomHistoriesAreThoseOfTheThesis) {
  const char* asked = std::getenv("BETWIXT_HISTORIES");
  const unsigned histories = asked ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : 10000;
  Tally tally;
  for (unsigned seed = 1; seed <= histories; ++seed) {
    const std::int64_t before = tally.wrong;
    play(seed, tally);
    ASSERT_EQ(tally.wrong, before) << "history " << seed;
    ASSERT_LT(tally.worst, 1e-9) << "history " << seed;
  }
  RecordProperty("seeks", std::to_string(tally.seeks));
  RecordProperty("worst", std::to_string(tally.worst * 1e15) + "e-15");
}

// Whatever way the events came in, the track is the same to the bit.
// shows: R-E12
TEST(Environment, EventsMayComeOneByOneAndInAnyOrder) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    Dice dice(seed);
    std::vector<Event> events = dice.history(200);
    std::erase_if(events, [](const Event& e) { return !std::holds_alternative<Animate>(e.what); });
    const Environment whole = Environment::compile(events);
    for (std::size_t i = events.size(); i > 1; --i)
      std::swap(events[i - 1], events[static_cast<std::size_t>(dice.whole(0, static_cast<std::int64_t>(i) - 1))]);
    Environment grown;
    for (const Event& event : events) ASSERT_TRUE(grown.add(event));
    ASSERT_EQ(grown, whole);
    for (std::int64_t tick = -60; tick < 400; tick += 7) {
      ASSERT_EQ(grown.at(0, tick), whole.at(0, tick));
      ASSERT_EQ(grown.next_due(tick), whole.next_due(tick));
    }
  }
}

}  // namespace
}  // namespace betwixt

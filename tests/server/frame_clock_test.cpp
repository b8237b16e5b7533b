// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the clock: which frames it makes, when it sleeps, what it counts. It runs in real time, so the tests must hold
// on the slowest machine. No test checks how late the clock is.
#include "server/frame_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "betwixt/language.h"

namespace betwixt {
namespace {

// Writes down what it is told.
struct Seen {
  std::mutex mutex;
  std::vector<std::string> order;  // "draw", "show"
  std::vector<Time> drawn, shown;
};

class Witness final : public Screen {
 public:
  explicit Witness(Seen& seen) : seen_(seen) {}
  Status draw(const Evaluation& e) override {
    const std::lock_guard lock(seen_.mutex);
    seen_.order.emplace_back("draw"), seen_.drawn.push_back(e.time());
    return Nothing{};
  }
  Status show(const Shown& s) override {
    const std::lock_guard lock(seen_.mutex);
    seen_.order.emplace_back("show"), seen_.shown.push_back(s.time);
    return Nothing{};
  }

 private:
  Seen& seen_;
};

std::unique_ptr<FrameClock> started(Seen& seen, Rate rate = {60, 1}) {
  FrameClock::Options o;
  o.rate = rate;
  o.priority = Priority::ordinary;
  o.screen = [&seen]() -> Result<std::unique_ptr<Screen>> {
    return std::unique_ptr<Screen>(std::make_unique<Witness>(seen));
  };
  auto clock = FrameClock::start(std::move(o));
  EXPECT_TRUE(clock);
  return *std::move(clock);
}

FrameClock::Edition edition(const std::string& script, bool running = true) {
  const Loaded loaded = load_text(script, "");
  EXPECT_FALSE(has_errors(loaded.diagnostics));
  return {Program::compile(loaded.document), {running, monotonic_now(), Time{}}, true};
}

template <class Done>
bool soon(Done&& done) {
  for (int i = 0; i < 2000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(10)))
    if (done()) return true;
  return false;
}
std::size_t count(Seen& seen) {
  const std::lock_guard lock(seen.mutex);
  return seen.shown.size();
}
long figure(const FrameClock& clock, const std::string& name) {
  const std::string all = clock.stats();
  return std::stol(all.substr(all.find("\"" + name + "\":") + name.size() + 3));
}

// Where nothing changes one frame is made, and then nothing wakes the thread until something is published. (C114)
TEST(FrameClock, SleepsWhereNothingIsDue) {
  Seen seen;
  const auto clock = started(seen);
  clock->publish(edition("create ball sphere"));
  ASSERT_TRUE(soon([&] { return count(seen) == 1; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const long wakes = figure(*clock, "wakes");
  std::this_thread::sleep_for(std::chrono::milliseconds(200));  // a dozen frames
  EXPECT_EQ(figure(*clock, "wakes"), wakes);
  EXPECT_EQ(count(seen), 1u);
  clock->publish(edition("create ball sphere radius=2"));
  EXPECT_TRUE(soon([&] { return count(seen) == 2; }));
}

// Many environments are updated in a tick; there is one picture of it, drawn whole before it is shown, and none between
// ticks. (C102, C103, C127, C129, C130)
TEST(FrameClock, MakesOneFrameOfAllThatIsDue) {
  Seen seen;
  const auto clock = started(seen, {120, 1});
  clock->publish(
      edition("ticks 30\ncreate ball sphere\nset ball.environments (e1 e2 e3)\n"
              "animate e{1..3} every 1t by rotate(1deg, y)"));
  ASSERT_TRUE(soon([&] { return count(seen) >= 10; }));
  const std::lock_guard lock(seen.mutex);
  for (std::size_t i = 0; i + 1 < seen.order.size(); i += 2)
    EXPECT_TRUE(seen.order[i] == "draw" && seen.order[i + 1] == "show") << i;
  for (std::size_t i = 0; i < seen.shown.size(); ++i) {
    EXPECT_EQ(seen.shown[i], seen.drawn[i]);
    if (i > 0) {
      EXPECT_LT(seen.shown[i - 1], seen.shown[i]);
    }
  }
  // At four frames to a tick: no more pictures than ticks, but for the first, which is shown as soon as it is known.
  const std::int64_t ticks = (seen.shown.back() - seen.shown.front()).flicks / (flicks_per_second / 30);
  EXPECT_LE(static_cast<std::int64_t>(seen.shown.size()), ticks + 2);
  EXPECT_LE(figure(*clock, "frames_made") + figure(*clock, "frames_missed"), figure(*clock, "frames_due"));
}

// A time that stands is shown once; one that is sought, where it is.
TEST(FrameClock, ShowsWhereTheTimeStands) {
  Seen seen;
  const auto clock = started(seen);
  FrameClock::Edition e = edition("create ball sphere\nball.position\n  0s (0 0 0)\n  100s (1 0 0) linear", false);
  e.transport.at = from_seconds(7.125);
  clock->publish(e);
  ASSERT_TRUE(soon([&] { return count(seen) == 1; }));
  EXPECT_EQ(seen.shown[0], from_seconds(7.125));
  const auto told = clock->shown();
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].time, from_seconds(7.125));
  EXPECT_EQ(count(seen), 1u);
}

// Publishing as fast as can be: what is looked at is always whole, nothing is lost for good, nothing leaks. (R-E14)
TEST(FrameClock, TakesEditionsAsTheyCome) {
  Seen seen;
  const auto clock = started(seen, {1000, 1});
  FrameClock::Edition e = edition("create ball sphere\nset ball.radius 2");
  for (int i = 0; i < 2000; ++i) {
    e.transport = {false, 0, Time{i}};
    clock->publish(e);
  }
  EXPECT_TRUE(soon([&] {
    const std::lock_guard lock(seen.mutex);
    return !seen.shown.empty() && seen.shown.back() == Time{1999};
  }));
  EXPECT_TRUE(std::is_sorted(seen.shown.begin(), seen.shown.end()));
}

// Draws when it is let, and looks whether what it is given is right and in order.
struct Gate {
  std::atomic<bool> open{true}, inside{false};  // inside: it waits to be let
  std::atomic<int> at_once{0};
  std::mutex mutex;
  struct Picture {
    Time time;
    std::size_t objects;
    bool right;
  };
  std::vector<Picture> shown;
  void await() {
    for (; !open; std::this_thread::sleep_for(std::chrono::milliseconds(1))) inside = true;
    inside = false;
  }
  std::size_t count() {
    const std::lock_guard lock(mutex);
    return shown.size();
  }
  bool shows(Time t) {
    const std::lock_guard lock(mutex);
    return shown.back().time == t;
  }
};

class GatedScreen final : public Screen {
 public:
  explicit GatedScreen(Gate& gate) : gate_(gate) {}
  Status draw(const Evaluation& e) override {
    EXPECT_EQ(++gate_.at_once, 1);
    gate_.await();
    const Frame seen = e.frame(), pure = e.program().frame(e.time());
    next_ = {e.time(), pure.items.size(), seen.items.size() == pure.items.size()};
    for (std::size_t i = 0; i < pure.items.size() && next_.right; ++i)
      next_.right = seen.items[i].world == pure.items[i].world;
    --gate_.at_once;
    return Nothing{};
  }
  Status show(const Shown& s) override {
    EXPECT_EQ(++gate_.at_once, 1);
    EXPECT_EQ(s.time, next_.time);
    const std::lock_guard lock(gate_.mutex);
    gate_.shown.push_back(next_);
    --gate_.at_once;
    return Nothing{};
  }

 private:
  Gate& gate_;
  Gate::Picture next_{};
};

std::unique_ptr<FrameClock> gated(Gate& gate) {
  FrameClock::Options o;
  o.rate = {100, 1};
  o.screen = [&gate]() -> Result<std::unique_ptr<Screen>> {
    return std::unique_ptr<Screen>(std::make_unique<GatedScreen>(gate));
  };
  auto clock = FrameClock::start(std::move(o));
  EXPECT_TRUE(clock);
  return *std::move(clock);
}

constexpr const char* turning =
    "create ball sphere\nset ball.environments (e)\nanimate e every 1t by rotate(1deg, y)\n";

// Whatever a frame takes, the clock keeps time: moments that pass without it are missed as they pass, the last one
// stands, everybody else goes on; and then the newest is shown.
TEST(FrameClock, WhatIsNotReadyIsMissedAtItsMoment) {
  Gate gate;
  const auto clock = gated(gate);
  const std::string one = std::string("ticks 100\n") + turning, two = one + "create box box\n";
  FrameClock::Edition e = edition(one);
  clock->publish(e);
  ASSERT_TRUE(soon([&] { return gate.count() >= 3; }));
  gate.open = false;
  ASSERT_TRUE(soon([&] { return gate.inside.load(); }));
  const std::size_t stands = gate.count();
  const long missed = figure(*clock, "frames_missed"), made = figure(*clock, "frames_made");
  ASSERT_TRUE(soon([&] { return figure(*clock, "frames_missed") >= missed + 20; }));
  const Time stuck = e.transport.time(monotonic_now());
  for (int i = 0; i < 100; ++i) clock->publish({Program::compile(load_text(two, "").document), e.transport, true});
  ASSERT_TRUE(soon([&] { return figure(*clock, "frames_missed") >= missed + 40; }));
  EXPECT_EQ(gate.count(), stands);
  EXPECT_EQ(figure(*clock, "frames_made"), made);
  gate.open = true;
  ASSERT_TRUE(soon([&] { return gate.count() >= stands + 5; }));
  const long late = figure(*clock, "frames_missed");
  ASSERT_TRUE(soon([&] { return figure(*clock, "frames_made") >= made + 3; })) << late;
  const std::lock_guard lock(gate.mutex);
  for (std::size_t i = 0; i < gate.shown.size(); ++i) {
    const Gate::Picture& p = gate.shown[i];
    EXPECT_TRUE(p.right) << i;
    EXPECT_EQ(p.objects, i <= stands ? 1u : 2u) << i;  // that which was stuck is shown, too
    EXPECT_EQ(p.time > stuck, i > stands) << i;
    EXPECT_TRUE(i == 0 || gate.shown[i - 1].time < p.time) << i;
  }
}

// Each moment counts once: shown in time, missed, or nothing was due at it.
TEST(FrameClock, EveryMomentCountsOnce) {
  Gate gate;
  auto clock = gated(gate);
  FrameClock::Edition e = edition(std::string("ticks 50\n") + turning);  // every other moment
  clock->publish(e);
  for (int k = 0; k < 6; ++k) {
    const std::size_t n = gate.count();
    ASSERT_TRUE(soon([&] { return gate.count() >= n + 3; }));
    gate.open = false;
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * k));
    gate.open = true;
  }
  e.transport = {false, monotonic_now(), e.transport.time(monotonic_now())};
  clock->publish(e);
  ASSERT_TRUE(soon([&] { return gate.shows(e.transport.at); }));
  const long due = figure(*clock, "frames_due"), idle = figure(*clock, "frames_idle");
  EXPECT_EQ(due, figure(*clock, "frames_made") + figure(*clock, "frames_missed"));
  const std::lock_guard lock(gate.mutex);
  const auto number = [](Time t) { return Rate{100, 1}.whole(t) + 1; };
  EXPECT_GE(due + idle, number(gate.shown[gate.shown.size() - 2].time) - number(gate.shown[0].time) + 1);
  EXPECT_LE(due + idle, number(e.transport.at) - number(gate.shown[0].time) + 2);
  EXPECT_LE(std::abs(due - idle), 8 + figure(*clock, "frames_missed")) << "every other moment, but for what was late";
}

// It ends while a frame is being made: that is waited for, and nothing else.
TEST(FrameClock, EndsInTheMiddleOfAFrame) {
  Gate gate;
  auto clock = gated(gate);
  gate.open = false;
  clock->publish(edition(turning));
  ASSERT_TRUE(soon([&] { return gate.inside.load(); }));
  std::thread end([&] { clock.reset(); });
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  gate.open = true;
  end.join();
  EXPECT_FALSE(gate.inside);
  EXPECT_EQ(gate.at_once, 0);
}

TEST(FrameClock, SaysWhatAScreenCannot) {
  FrameClock::Options o;
  o.screen = []() -> Result<std::unique_ptr<Screen>> { return fail(ErrorCode::machine, "no stage"); };
  const auto clock = FrameClock::start(std::move(o));
  ASSERT_FALSE(clock);
  EXPECT_EQ(clock.error().message, "no stage");
}

}  // namespace
}  // namespace betwixt

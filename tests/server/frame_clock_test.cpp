// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The clock: which frames it makes, when it sleeps, what it counts. It runs in real time, so that what is asked of it
// here holds on the slowest machine: nothing is said of how late it is.
#include "server/frame_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
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

TEST(FrameClock, SaysWhatAScreenCannot) {
  FrameClock::Options o;
  o.screen = []() -> Result<std::unique_ptr<Screen>> { return fail(ErrorCode::machine, "no stage"); };
  const auto clock = FrameClock::start(std::move(o));
  ASSERT_FALSE(clock);
  EXPECT_EQ(clock.error().message, "no stage");
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Workers answer slow questions beside the frames. These tests have a clock of their own: only code that waits moves
// it, so a slow machine gives the same results.
#include "server/quarantine.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>

#include "base/still_wanted.h"
#include "betwixt/language.h"
#include "scene/document.h"
#include "server/frame_clock.h"

namespace betwixt {
namespace {

constexpr Nanos share = 1'000'000;

// Code that gives the time plus one, when it is let.
struct Gate {
  std::atomic<bool> open{false};
  std::atomic<int> begun{0}, ended{0};
  std::atomic<Nanos>* clock = nullptr;
};
class Waiting final : public Routine {
 public:
  explicit Waiting(Gate& gate) : gate_(gate) { language = "lua", source = "wait()"; }
  Result<Value> value(Questions& q, const std::vector<Value>&, std::uint64_t&) const override {
    ++gate_.begun;
    if (!gate_.open && gate_.clock) *gate_.clock += 40 * share;
    while (!gate_.open && StillWanted::wanted()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ++gate_.ended;
    return Value(q.seconds() + 1);
  }

 private:
  Gate& gate_;
};

Document film(const std::string& script) {
  const Loaded loaded = load_text(script, "");
  EXPECT_FALSE(has_errors(loaded.diagnostics)) << to_string(loaded.diagnostics[0]);
  return loaded.document;
}
// With code of the gate as a value.
Document waiting(const Document& d, const std::string& target, Gate& gate) {
  Scene s = d.scene();
  set_value(s, *find_target(s, target), Value(Procedure{std::make_shared<Waiting>(gate)}));
  return Document(std::make_shared<const Scene>(std::move(s)));
}

bool same(const Frame& a, const Frame& b) {
  if (a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (std::memcmp(&a.items[i].world, &b.items[i].world, sizeof(Mat4)) != 0 ||
        !(*a.items[i].shape == *b.items[i].shape))
      return false;
  return std::memcmp(&a.camera.world, &b.camera.world, sizeof(Mat4)) == 0;
}
const Item& item(const Frame& f, const Document& d, const std::string& name) {
  return *std::find_if(f.items.begin(), f.items.end(), [&](const Item& i) { return i.id == d.find(name); });
}
double radius(const Frame& f, const Document& d, const std::string& name) { return item(f, d, name).shape->radius; }

struct Maker {
  std::atomic<Nanos> now{1};
  std::atomic<int> heard{0};
  Quarantine quarantine{{share, 0, [this] { return now.load(); }, [this] { ++heard; }}};
  std::optional<Evaluation> played;
  std::vector<SlowTurn> turns;

  void show(const Document& d) { played.emplace(Program::compile(d), quarantine); }
  Frame at(double seconds) {
    quarantine.wait_until(now + 10'000 * share);
    played->to(from_seconds(seconds));
    for (SlowTurn& t : quarantine.turns()) turns.push_back(std::move(t));
    return played->frame();
  }
  // Until something has come beside.
  void await(int answers) {
    for (int i = 0; i < 20'000 && heard < answers; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_GE(heard, answers);
  }
};

const std::string moving =
    "create cam camera\ncreate ball sphere\nset ball.position = \"vec(t, 2*t, value('post.height'))\"\n"
    "create post cylinder\nset post.height = \"1 + t*t\"\n"
    "create way polyline points=((0 0) (1 0) (1 1))\n"
    "way.points\n  0s ((0 0) (1 0) (1 1))\n  2s ((0 0) (3 0) (3 5))\n"
    "create fly sphere\nfly.position\n  0s..50s along way linear\ncreate trail trace of=ball\n"
    "create sign text\nset sign.text = \"'at ' .. t\"\nfilter ball.position smooth width=0.5s\n";

// shows: issue 31, quarantine
TEST(Quarantine, WhatIsQuickIsThatOfTheFilm) {
  const Document d = film(moving);
  const Program pure = Program::compile(d);
  Maker m;
  m.show(d);
  for (const double t : {0.0, 0.5, 0.75, 1.5, 0.25, 1.0}) EXPECT_TRUE(same(m.at(t), pure.frame(from_seconds(t)))) << t;
  EXPECT_TRUE(m.turns.empty());
  EXPECT_NE(m.quarantine.stats().find("\"quarantine\":0"), std::string::npos);
}

TEST(Quarantine, ASlowOneHoldsItsValueAndTheOthersGoOn) {
  Maker m;
  Gate gate{.clock = &m.now};
  const Document d = waiting(film(moving + "create slow sphere radius=7\n"), "slow.radius", gate);
  m.show(d);
  for (int i = 0; i < 10; ++i) {  // one open question is enough
    const double t = 0.125 * i;
    const Frame f = m.at(t);
    EXPECT_EQ(radius(f, d, "slow"), 1) << "the radius of a sphere without code";
    EXPECT_EQ(item(f, d, "post").shape->height, 1 + t * t) << t;
    EXPECT_EQ(gate.begun, 1);
  }
  ASSERT_EQ(m.turns.size(), 1u);
  EXPECT_EQ(m.turns[0].target, "slow.radius");
  EXPECT_TRUE(m.turns[0].slow);
  EXPECT_NE(m.quarantine.stats().find("\"target\":\"slow.radius\""), std::string::npos);
  EXPECT_EQ(m.played->problems().size(), 1u);
  gate.open = true;
  m.await(1);
  Frame f = m.at(2);
  EXPECT_EQ(radius(f, d, "slow"), 1) << "its value of 0 s, when it comes";
  m.await(2);
  f = m.at(3);
  EXPECT_EQ(radius(f, d, "slow"), 3) << "… and of 2 s";
  m.await(3);
  m.at(4);
  m.await(4);
  f = m.at(5);  // three quick answers have come
  EXPECT_EQ(radius(f, d, "slow"), 6);
  ASSERT_EQ(m.turns.size(), 2u);
  EXPECT_FALSE(m.turns[1].slow);
  EXPECT_TRUE(same(f, Program::compile(d).frame(from_seconds(5))));
}

// An edit of another object leaves the open question alone. If its own object goes, the question is called off.
TEST(Quarantine, EditsKeepWhatIsKnownAndCallOffWhatIsGone) {
  Maker m;
  Gate gate{.clock = &m.now};
  const Document d = waiting(film(moving + "create slow sphere\n"), "slow.radius", gate);
  m.show(d);
  m.at(1);
  Scene s = d.scene();
  set_value(s, *find_target(s, "way.display"), Value(false));
  m.show(Document(std::make_shared<const Scene>(s)));
  m.at(2);
  EXPECT_EQ(gate.begun, 1);
  EXPECT_EQ(gate.ended, 0);
  m.show(film(moving));
  m.at(3);
  for (int i = 0; i < 20'000 && gate.ended == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(gate.ended, 1);
  EXPECT_EQ(m.quarantine.stats(), "\"quarantine\":0,\"quarantined\":[]");
}

// If the time stands still, frames show the late answer, and the code runs once.
TEST(Quarantine, ATimeThatStandsGetsItsAnswer) {
  Maker m;
  Gate gate{.clock = &m.now};
  const Document d = waiting(film("create cam camera\ncreate slow sphere\n"), "slow.radius", gate);
  m.show(d);
  EXPECT_EQ(radius(m.at(4), d, "slow"), 1);
  gate.open = true;
  m.await(1);
  EXPECT_EQ(radius(m.at(4), d, "slow"), 5);
  EXPECT_EQ(radius(m.at(4), d, "slow"), 5);
  EXPECT_EQ(gate.begun, 1);
}

// Few threads serve many slow values, and quick values stay exact.
TEST(Quarantine, ManySlowOnesLeaveRoomForTheOthers) {
  Maker m;
  Gate gate{.clock = &m.now};
  std::string script = moving;
  for (int i = 1; i <= 20; ++i) script += "create slow" + std::to_string(i) + " sphere\n";
  Document d = film(script);
  m.show(d);
  m.at(0);
  for (int i = 1; i <= 20; ++i) d = waiting(d, "slow" + std::to_string(i) + ".radius", gate);
  m.show(d);
  for (int i = 1; i < 30; ++i) EXPECT_EQ(item(m.at(i), d, "post").shape->height, 1 + i * i) << i;
  EXPECT_LE(gate.begun, 10);
  gate.open = true;
  const Program pure = Program::compile(d);
  bool all_back = false;
  for (int i = 40; i < 5'000 && !all_back; ++i) {
    all_back = same(m.at(i), pure.frame(from_seconds(i)));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(all_back);
}

// A question that is called off leaves the program whole for the next one.
TEST(Quarantine, WhatIsCalledOffSpoilsNothing) {
  const std::string script =
      "create ball sphere\nset ball.position = \"vec(sin(3*t), cos(5*t), t)\"\ncreate trail trace of=ball\n";
  const Document d = film(script);
  const Program whole = Program::compile(d), halved = Program::compile(d);
  const Time end = from_seconds(3);
  const std::atomic<int> nobody{0};
  const std::atomic<bool> over{false};
  std::atomic<bool> gone{false};
  for (int i = 0; i < 20; ++i) {
    gone = false;
    std::thread caller([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(300 * i));
      gone = true;
    });
    try {
      const StillWanted wanted(gone, over, nobody, {});
      for (const Question& q : questions_of(halved.compiled())) work_out(halved.compiled(), q, end);
    } catch (const NotWanted&) {
    }
    caller.join();
  }
  EXPECT_TRUE(same(halved.frame(end), whole.frame(end)));
}

class Witness final : public Screen {
 public:
  explicit Witness(std::atomic<int>& frames) : frames_(frames) {}
  Status draw(const Evaluation&) override { return Nothing{}; }
  Status show(const Shown&) override { return ++frames_, Nothing{}; }

 private:
  std::atomic<int>& frames_;
};

// The clock shows frames, and can end.
TEST(Quarantine, FramesComeWhileCodeWaits) {
  std::atomic<int> frames{0};
  Gate gate;
  FrameClock::Options o;
  o.rate = {100, 1}, o.priority = Priority::ordinary;
  o.screen = [&]() -> Result<std::unique_ptr<Screen>> { return std::unique_ptr<Screen>(new Witness(frames)); };
  auto clock = FrameClock::start(std::move(o));
  ASSERT_TRUE(clock);
  const Document d = waiting(film(moving + "create slow sphere\n"), "slow.radius", gate);
  (*clock)->publish({Program::compile(d), {true, monotonic_now(), Time{}}, true});
  for (int i = 0; i < 20'000 && frames < 20; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_GE(frames, 20);
  EXPECT_EQ(gate.begun, 1);
  EXPECT_EQ(gate.ended, 0);
  EXPECT_NE((*clock)->stats().find("\"target\":\"slow.radius\""), std::string::npos);
  bool told = false;
  for (const Shown& s : (*clock)->shown())
    for (const SlowTurn& t : s.turns) told = told || (t.slow && t.target == "slow.radius");
  EXPECT_TRUE(told);
  clock->reset();
  EXPECT_EQ(gate.ended, 1);
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests workers that answer slow questions outside the frame loop. These tests have their own clock, which only waiting
// code moves, so a slow machine gives the same results.
#include "server/quarantine.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <numbers>

#include "base/cancellation.h"
#include "betwixt/language.h"
#include "scene/document.h"
#include "scene/rig.h"
#include "server/frame_clock.h"
#include "server/stage.h"

namespace betwixt {
namespace {

constexpr Nanos share = 1'000'000;

// Code that gives the time plus one, when it is let. As a twerper it gives the square.
struct Gate {
  std::atomic<bool> open{false};
  std::atomic<int> begun{0}, ended{0};
  std::atomic<Nanos>* clock = nullptr;
  const std::thread::id maker = std::this_thread::get_id();
  std::atomic<int> by_maker{0};  // how often the maker itself ran it
};
class Waiting final : public Routine {
 public:
  explicit Waiting(Gate& gate) : gate_(gate) { language = "lua", source = "wait()"; }
  Result<Value> value(Questions& q, const std::vector<Value>&, std::uint64_t&) const override {
    pass();
    return Value(q.seconds() + 1);
  }
  Result<double> blend(double u) const override {
    pass();
    return u * u;
  }

 private:
  void pass() const {
    ++gate_.begun;
    gate_.by_maker += std::this_thread::get_id() == gate_.maker;
    if (!gate_.open && gate_.clock) *gate_.clock += 40 * share;
    while (!gate_.open && Cancellation::wanted()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ++gate_.ended;
  }
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

// With code of the gate in place of the film's first procedure.
Document twerping(const Document& d, Gate& gate) {
  Scene s = d.scene();
  s.procedures.edit()[0].code = std::make_shared<Waiting>(gate);
  return Document(std::make_shared<const Scene>(std::move(s)));
}

bool same_shape(const Shape& a, const Shape& b) {
  if (!a.mesh || !b.mesh) return a == b;
  Shape same_mesh = b;
  same_mesh.mesh = a.mesh;
  return a == same_mesh && a.mesh->positions == b.mesh->positions && a.mesh->normals == b.mesh->normals;
}
bool same(const Item& a, const Item& b) {
  const bool both = (a.toward == nullptr) == (b.toward == nullptr);
  return both && std::memcmp(&a.world, &b.world, sizeof(Mat4)) == 0 && same_shape(*a.shape, *b.shape) &&
         (!a.toward || (same_shape(*a.toward, *b.toward) && a.blend == b.blend)) && a.color == b.color &&
         a.transparency == b.transparency && a.material == b.material;
}
bool same(const Frame& a, const Frame& b) {
  if (a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!same(a.items[i], b.items[i])) return false;
  return std::memcmp(&a.camera.world, &b.camera.world, sizeof(Mat4)) == 0;
}
const Item& item(const Frame& f, const Document& d, const std::string& name) {
  return *std::find_if(f.items.begin(), f.items.end(), [&](const Item& i) { return i.id == d.find(name); });
}
double radius(const Frame& f, const Document& d, const std::string& name) { return item(f, d, name).shape->radius; }

struct Maker {
  explicit Maker(Nanos one = share) : most(one) {}
  const Nanos most;  // for one answer
  std::atomic<Nanos> now{1};
  std::atomic<int> heard{0};
  Quarantine quarantine{{most, 0, [this] { return now.load(); }, [this] { ++heard; }}};
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

// Large films are evaluated in advance, without answers. The first frame has them, at the same time too.
TEST(Quarantine, WhatIsEvaluatedInAdvanceTakesTheAnswers) {
  const Document d = film(moving);
  const Program pure = Program::compile(d);
  Maker m(1'000 * share);
  for (const auto& [ahead, shown] : {std::pair{0.5, 0.5}, {0.5, 0.75}, {3.0, 1.0}, {0.0, 0.0}}) {
    m.show(d);
    m.played->prepare(from_seconds(ahead));
    EXPECT_TRUE(same(m.at(shown), pure.frame(from_seconds(shown)))) << ahead << shown;
    EXPECT_EQ(m.played->changed().size(), m.played->drawables().size());
    EXPECT_TRUE(same(m.at(1.5), pure.frame(from_seconds(1.5)))) << ahead;
  }
}

// No answer comes with that frame, but one is known.
TEST(Quarantine, WhatIsEvaluatedInAdvanceHasTheLastAnswer) {
  Maker m;
  Gate gate{.clock = &m.now};
  const Document d = waiting(film("create cam camera\ncreate slow sphere\n"), "slow.radius", gate);
  m.show(d);
  m.at(0);
  gate.open = true;
  m.await(1);
  m.at(2);
  m.await(2);
  gate.open = false;
  EXPECT_EQ(radius(m.at(3), d, "slow"), 3) << "its value of 2 s";
  m.show(d);
  m.played->prepare(from_seconds(3));
  EXPECT_EQ(radius(m.at(3), d, "slow"), 3);
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

// On a busy machine a frame is late before all its questions are begun: the others are asked in the background at once.
TEST(Quarantine, SlowOnesAreNamedIfNoFrameHasWaitedForThem) {
  Maker m;
  Gate gate{.clock = &m.now};
  Document d = film(moving + "create slow{1..3} sphere\n");
  for (const char* target : {"slow1.radius", "slow2.radius", "slow3.radius"}) d = waiting(d, target, gate);
  m.show(d);
  const auto named = [&](const char* target) {
    return holds(m.quarantine.stats(), fmt::format("\"target\":\"{}.radius\"", target));
  };
  const auto all = [&] { return named("slow1") && named("slow2") && named("slow3"); };
  for (int i = 0; i < 20'000 && !all(); ++i) {
    m.quarantine.wait_until(0);
    m.played->to(from_seconds(0.001 * i));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(all()) << m.quarantine.stats();
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

// A paused film shows the late answer in its next frame. The code runs once.
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
      const Cancellation wanted(gone, over, nobody, {});
      for (const Question& q : questions_of(halved.compiled())) work_out(halved.compiled(), q, end);
    } catch (const Cancelled&) {
    }
    caller.join();
  }
  EXPECT_TRUE(same(halved.frame(end), whole.frame(end)));
}

// Tracks of each kind: numbers, components, shapes, points, aims, motions; repeated, extended and at rest.
const std::string coded =
    "procedure dip twerper lua \"u * u\"\ncreate cam camera\ncreate hand sphere\nhand.position\n"
    "  0s (0 0 0) dip\n  2s (4 0 0) linear\n  4s (4 4 0)\nhand.radius\n  1s 1 dip\n  3s 3\n"
    "create ring torus\nring.rotation.y\n  0s 0deg dip\n  1s 90deg\nextend ring.rotation.y cycle\n"
    "ring.color\n  0s red dip\n  2s blue\nring.transparency\n  0s 0 dip\n  1s 0.5\n"
    "extend ring.transparency linear\ncreate way polyline points=((0 0) (1 0) (1 1))\n"
    "way.points\n  0s ((0 0) (1 0) (1 1)) dip\n  2s ((0 0) (3 0) (3 5))\n"
    "create low box\ncreate high cylinder\nhide {low,high}\ncreate form box\nform.geometry\n"
    "  0s shape(low) dip\n  2s shape(high) dip\n  3s shape(low)\n"
    "create eye cone look-at=hand\neye.look-at\n  0s ring dip\n  2s hand\n"
    "create wheel torus position=(0 1 0)\nwheel.motion\n  0s..2s T(6 0) R(-1turn @ wheel) dip\n"
    "create plain box\nplain.position\n  0s (0 0 0) linear\n  9s (9 0 0)\n";

TEST(Quarantine, CodedTwerpersGiveTheFilm) {
  const Document d = film(coded);
  const Program pure = Program::compile(d);
  Maker m;
  m.show(d);
  for (const double t : {0.0, 0.5, 1.25, 2.0, 2.5, 5.0, 0.75, 1.0, 7.5})
    EXPECT_TRUE(same(m.at(t), pure.frame(from_seconds(t)))) << t;
  EXPECT_TRUE(m.turns.empty());
}

// The maker runs no twerper. Without an answer it is linear; where no coded twerper blends, values stay exact.
TEST(Quarantine, ASlowTwerperIsLinearUntilItsAnswerComes) {
  Gate gate;
  Maker m;
  gate.clock = &m.now;
  const Document d = twerping(film(coded), gate);
  const Program pure = Program::compile(film(coded));
  m.show(d);
  Frame f = m.at(1);
  const auto place = [&](const char* name) { return translation_of(item(f, d, name).world); };
  EXPECT_EQ(place("hand"), (Vec3{2, 0, 0}));
  EXPECT_EQ(place("plain"), (Vec3{1, 0, 0}));
  EXPECT_NEAR(place("wheel").x, 3, 1e-12);
  EXPECT_EQ(item(f, d, "form").blend, 0.5);
  EXPECT_EQ((*item(f, d, "way").shape->points).size(), 0u) << "it has never been made";
  f = m.at(3);
  EXPECT_EQ(place("hand"), (Vec3{4, 2, 0})) << "a linear segment";
  gate.open = true;
  bool exact = false;
  for (int i = 0; i < 5'000 && !exact; ++i) {
    exact = same(m.at(1.5), pure.frame(from_seconds(1.5)));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(exact);
  EXPECT_EQ(gate.by_maker, 0);
}

// The plain value of a live value may have a coded twerper too.
TEST(Quarantine, TheValueBelowAFilterIsLinearToo) {
  Gate gate;
  Maker m;
  gate.clock = &m.now;
  const Document d = twerping(film(coded + "filter hand.position smooth width=0.5s\n"), gate);
  m.show(d);
  EXPECT_EQ(translation_of(item(m.at(1), d, "hand").world), (Vec3{2, 0, 0}));
  EXPECT_EQ(gate.by_maker, 0);
}

// An edited value may have become slow. Before a worker has answered, the maker does not compute it for other times,
// nor what reads it.
TEST(Quarantine, TheMakerDoesNotTryWhatWasEdited) {
  Gate gate;
  Maker m;
  const Document d = film(
      "create cam camera\ncreate ball sphere\nset ball.radius = \"1 + t\"\n"
      "create post cylinder\nset post.height = \"value('ball.radius')\"\n"
      "create other box\nset other.position = \"vec(t, 0, 0)\"\n");
  const auto quick = [&](const Document& now, const std::string& name) {
    const Program p = Program::compile(now);
    for (const Question& q : questions_of(p.compiled()))
      if (subject_of(p.compiled(), q).first == now.find(name).index) return m.quarantine.quick(q);
    return false;
  };
  m.show(d);
  m.at(1);
  for (const char* name : {"ball", "post", "other"}) EXPECT_TRUE(quick(d, name)) << name;
  const Document edited = waiting(d, "ball.radius", gate);
  m.show(edited);
  m.quarantine.wait_until(0);
  m.played->to(from_seconds(2));
  EXPECT_FALSE(quick(edited, "ball"));
  EXPECT_FALSE(quick(edited, "post"));
  EXPECT_TRUE(quick(edited, "other"));
  gate.open = true;
  for (int i = 0; i < 5'000 && !(quick(edited, "ball") && quick(edited, "post")); ++i) {
    m.at(3 + i);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(quick(edited, "ball"));
  EXPECT_TRUE(quick(edited, "post"));
}

// A grid of 80 by 80 vertices that follow two joints, moved by code.
Document skinned() {
  constexpr int side = 80;
  auto mesh = std::make_shared<Mesh>();
  auto rig = std::make_shared<Rig>();
  for (int i = 0; i < side * side; ++i) {
    const float x = static_cast<float>(i % side) / side, y = static_cast<float>(i / side) / side;
    mesh->positions.push_back({x, y, 0}), mesh->normals.push_back({0, 0, 1});
    rig->joints.push_back({0, 1, 0, 0}), rig->weights.push_back({1 - y, y, 0, 0});
  }
  for (std::uint32_t i = 0; i + side + 1 < side * side; ++i)
    for (const std::uint32_t corner : {i, i + 1, i + side}) mesh->triangles.push_back(corner);
  rig->inverse_bind = {translation({0, -0.2, 0}), translation({0, -0.8, 0})};
  mesh->rig = rig;
  const Document d = film(
      "create cam camera\ncreate skin box position=(1 2 3)\ncreate low group position=(0 0.2 0)\n"
      "create high group position=(0 0.6 0)\nhang low on skin\nhang high on low\n"
      "low.rotation\n  0s (0deg 0deg 0deg) linear\n  2s (30deg 0deg -20deg)\ncreate slow sphere\nset high.position = "
      "\"vec(t * value('slow.radius'), 0.6, 0)\"\n"
      "create plain box\nplain.position\n  0s (0 0 0) linear\n  9s (9 0 0)\n");
  Scene s = d.scene();
  s.objects.edit(d.find("skin").index).kind = Kind::mesh;
  s.meshes.edit()["grid"] = mesh;
  set_value(s, *find_target(s, "skin.file"), Value(Text("grid")));
  set_value(s, *find_target(s, "skin.joints"), Value(Names({"low", "high"})));
  return Document(std::make_shared<const Scene>(std::move(s)));
}

TEST(Quarantine, LargeSkinsAreDeformedByWorkers) {
  const Document d = skinned();
  const Program pure = Program::compile(d);
  EXPECT_EQ(pure.compiled().slow_shapes.size(), 1u);
  {
    Maker m(1'000 * share);
    m.show(d);
    for (const double t : {0.0, 0.5, 1.75, 1.0}) EXPECT_TRUE(same(m.at(t), pure.frame(from_seconds(t)))) << t;
    ASSERT_TRUE(item(m.at(1), d, "skin").shape->mesh);
    EXPECT_NE(item(m.at(1), d, "skin").shape->mesh->positions, (*d.scene().meshes).at("grid")->positions);
  }
  Gate gate;
  Maker m;
  gate.clock = &m.now;
  const Document slow = waiting(d, "slow.radius", gate);
  m.show(slow);
  const Frame f = m.at(1);
  EXPECT_FALSE(item(f, slow, "skin").shape->mesh) << "it has never been made";
  EXPECT_EQ(translation_of(item(f, slow, "plain").world), (Vec3{1, 0, 0}));
  EXPECT_NE(m.quarantine.stats().find("\"target\":\"skin\""), std::string::npos);
}

// Two stars of 2 x 400 points as polygons, one into the other.
std::string large_blend(const std::string& twerper) {
  std::string script = "procedure dip twerper lua \"u * u\"\ncreate cam camera\n";
  for (const int tips : {5, 9}) {
    script += fmt::format("create star{} polygon points=(", tips);
    for (int i = 0; i < 800; ++i) {
      const double angle = i * std::numbers::pi / 400, r = 2 + std::cos(tips * angle);
      script += fmt::format("({:.4f} {:.4f}) ", r * std::cos(angle), r * std::sin(angle));
    }
    script += ")\n";
  }
  return script + fmt::format(
                      "hide star*\ncreate form polygon\nform.geometry\n  0s shape(star5) {0}\n"
                      "  2s shape(star9) {0}\n  4s shape(star5)\n"
                      "create plain box\nplain.position\n  0s (0 0 0) linear\n  9s (9 0 0)\n",
                      twerper);
}

TEST(Quarantine, LargeBlendsAreMadeByWorkers) {
  for (const char* twerper : {"linear", "smooth", "dip"}) {
    const Document d = film(large_blend(twerper));
    const Program pure = Program::compile(d);
    EXPECT_EQ(pure.compiled().slow_blends.size(), 1u);
    Maker m(1'000 * share);
    m.show(d);
    for (const double t : {0.0, 0.5, 2.0, 1.25, 3.0, 4.0, 5.0})
      EXPECT_TRUE(same(m.at(t), pure.frame(from_seconds(t)))) << twerper << t;
  }
  Gate gate;
  Maker m;
  gate.clock = &m.now;
  const Document d = twerping(film(large_blend("dip")), gate);
  m.show(d);
  const Frame f = m.at(1);
  EXPECT_FALSE(item(f, d, "form").toward) << "nothing is blended yet";
  EXPECT_EQ(item(f, d, "form").shape->points->size(), 800u);
  EXPECT_EQ(translation_of(item(f, d, "plain").world), (Vec3{1, 0, 0}));
  EXPECT_NE(m.quarantine.stats().find("\"target\":\"form.geometry\""), std::string::npos);
  EXPECT_EQ(gate.by_maker, 0);
}

// What a server shows late is exact in its history. Here every value that code gives is late.
TEST(Quarantine, TheHistoryHasTheExactValues) {
  const Folder folder;
  const auto lines = {"create cam camera",
                      "procedure dip twerper lua \"u * u\"",
                      "create ball sphere",
                      "set ball.position = \"vec(sin(3*t), 2*t, 0)\"",
                      "create post cylinder",
                      "set post.height = \"1 + value('ball.position.y')\"",
                      "create far box",
                      "far.position",
                      "  0s (0 0 0) dip",
                      "  4s (4 0 0)",
                      "filter far.position smooth width=0.5s",
                      "create trail trace of=ball"};
  Quarantine late{{1, 0, monotonic_now, [] {}}};
  {
    Stage s({}, "", folder / "live.bx");
    const auto host = s.imaging.arrive();
    std::optional<Evaluation> played;
    int n = 0;
    for (const char* line : lines) {
      s.done(host, line, tick(n));
      played.emplace(s.imaging.program(), late);
      late.wait_until(monotonic_now());
      played->to(from_seconds(n++ / 30.0));
    }
    for (int i = 0; i < 20'000 && !holds(late.stats(), "\"target\":\"ball.position\""); ++i) {
      played->to(from_seconds(n++ / 30.0));
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(holds(late.stats(), "\"target\":\"ball.position\"")) << late.stats();
    EXPECT_TRUE(s.imaging.sync());
  }  // killed, as it were: the journal has the rest
  std::string said;
  for (const char* line : lines) said += std::string(line) + "\n";
  const Program wanted = Program::compile(film(said));
  Stage again({}, "", folder / "live.bx");
  const Program journal = Program::compile(again.imaging.document()),
                script = Program::compile(film(again.imaging.history()));
  for (const double t : {0.0, 0.1, 1.0, 2.5, 6.0}) {
    EXPECT_TRUE(same(journal.frame(from_seconds(t)), wanted.frame(from_seconds(t)))) << t;
    EXPECT_TRUE(same(script.frame(from_seconds(t)), wanted.frame(from_seconds(t)))) << t;
  }
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
  // The code counts as slow after its share of a frame: on a busy machine that can be later than 20 frames.
  bool listed = false, told = false;
  for (int i = 0; i < 20'000 && !(listed && told); ++i) {
    listed = listed || holds((*clock)->stats(), "\"target\":\"slow.radius\"");
    for (const Shown& s : (*clock)->shown())
      for (const SlowTurn& t : s.turns) told = told || (t.slow && t.target == "slow.radius");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(listed);
  EXPECT_TRUE(told);
  clock->reset();
  EXPECT_EQ(gate.ended, 1);
}

}  // namespace
}  // namespace betwixt

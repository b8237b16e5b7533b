// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares attachment tracks with a separate model. It uses row vectors and 3×3 arrays, as the rules R-H1 to R-H6 are
// written.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "scene/functions.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

using V = std::array<double, 3>;
using M = std::array<V, 3>;  // rows
constexpr M one{V{1, 0, 0}, V{0, 1, 0}, V{0, 0, 1}};

V operator+(V a, V b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
V operator-(V a, V b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
V operator*(V v, const M& m) {
  V out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) out[i] += v[k] * m[k][i];
  return out;
}
M operator*(const M& a, const M& b) { return {a[0] * b, a[1] * b, a[2] * b}; }
M inverse(const M& m) {
  const auto minor = [&](std::size_t i, std::size_t k) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (k + 1) % 3, d = (k + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  M out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) out[k][i] = minor(i, k) / det;
  return out;
}

struct World {
  M a;  // the 3×3
  V p;  // the position
  M q;  // what it hands on without scales
};

// An object whose tracks go straight from frame 1 to frame 73.
struct Thing {
  V position[2], scale[2], attach[2], axis, pivot;
  double angle[2];  // degrees
  static double between(const double x[2], double frame) { return x[0] + (x[1] - x[0]) * (frame - 1) / 72; }
  static V between(const V x[2], double frame) {
    V out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = x[0][i] + (x[1][i] - x[0][i]) * (frame - 1) / 72;
    return out;
  }
  M turn(double frame) const {  // Rodrigues; rows are where the axes go
    const double a = between(angle, frame) * std::acos(-1.0) / 180, c = std::cos(a), s = std::sin(a);
    const double l = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    const V n{axis[0] / l, axis[1] / l, axis[2] / l};
    const double cross[3][3] = {{0, n[2], -n[1]}, {-n[2], 0, n[0]}, {n[1], -n[0], 0}};
    M m{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) m[i][k] = (i == k ? c : 0) + (1 - c) * n[i] * n[k] + s * cross[i][k];
    return m;
  }
  M scaled(double frame) const {
    M m = turn(frame);
    const V s = between(scale, frame);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k) m[i][k] *= s[i];
    return m;
  }
  V place(double frame) const { return between(position, frame) + pivot - pivot * scaled(frame); }
  World free(double frame) const { return {scaled(frame), place(frame), turn(frame)}; }
  // `by`: hang, attach or couple.
  World on(const World& parent, const std::string& by, double frame) const {
    const M b = by == "hang" ? one : by == "attach" ? parent.q : parent.a;
    return {scaled(frame) * b, (place(frame) + between(attach, frame)) * parent.a + parent.p,
            by == "hang" ? turn(frame) : turn(frame) * parent.q};
  }
  World let_go(const World& parent, const std::string& by, double at, double frame) const {  // parent: at `at`
    const M b = by == "hang" ? one : by == "attach" ? parent.q : parent.a;
    return {scaled(frame) * b, (place(frame) + between(attach, at)) * parent.a + parent.p,
            by == "hang" ? turn(frame) : turn(frame) * parent.q};
  }
};

class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}
  double number(double low, double high) { return low + (high - low) * static_cast<double>(random_() % 4097) / 4096; }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string mode() { return std::array{"hang", "attach", "couple"}[static_cast<std::size_t>(below(3))]; }
  Thing thing(const std::string& name, std::string& script) {
    Thing t;
    const auto vector = [&](double low, double high) {
      return V{number(low, high), number(low, high), number(low, high)};
    };
    for (int i = 0; i < 2; ++i) t.position[i] = vector(-5, 5), t.scale[i] = vector(0.4, 3), t.attach[i] = vector(-2, 2);
    t.axis = vector(-1, 1), t.axis[1] += 2, t.pivot = below(2) ? vector(-1, 1) : V{};
    t.angle[0] = number(-80, 80), t.angle[1] = number(-80, 80);
    const auto words = [](V v) { return fmt::format("({} {} {})", v[0], v[1], v[2]); };
    script += fmt::format("create {} sphere pivot={}\n", name, words(t.pivot));
    for (const auto& [f, x] : {std::pair("position", t.position), {"scale", t.scale}, {"attach-position", t.attach}})
      script += fmt::format("{}.{}\n  1f {} linear\n  73f {}\n", name, f, words(x[0]), words(x[1]));
    script += fmt::format("{}.rotation\n", name);
    for (int i = 0; i < 2; ++i)
      script +=
          fmt::format("  {}f axis({} {} {}, {}deg) linear\n", 1 + 72 * i, t.axis[0], t.axis[1], t.axis[2], t.angle[i]);
    return t;
  }

 private:
  std::mt19937 random_;
};

std::string link(const std::string& mode) { return mode == "hang" ? "on" : "to"; }

std::vector<double> world(const LoadedFilm& s, const std::string& name, double frame) {
  return s.numbers(name + ".world", fmt::format("{}f", frame));
}
double away(const std::vector<double>& a, const std::vector<double>& b) {
  double size = 1, d = 0;
  for (std::size_t i = 0; i < 16; ++i) size = std::max(size, std::abs(a[i])), d = std::max(d, std::abs(a[i] - b[i]));
  return d / size;
}
std::vector<double> as_written(const World& w) {  // columns, row by row
  std::vector<double> out;
  for (std::size_t i = 0; i < 3; ++i) out.insert(out.end(), {w.a[0][i], w.a[1][i], w.a[2][i], w.p[i]});
  out.insert(out.end(), {0, 0, 0, 1});
  return out;
}

// shows: G75 G76 G77 G79 G80 G82 G83 R-H1 R-H2 R-H4 R-H6
TEST(Attachment, HoldingAndLettingGoAreTheRules) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    Maker make(seed);
    std::string script = "rate 24\n";
    const Thing arm = make.thing("arm", script), hand = make.thing("hand", script), ball = make.thing("ball", script),
                tail = make.thing("tail", script);
    const std::string hand_by = make.mode(), by = make.mode(), tail_by = make.mode();
    script += fmt::format("{} hand {} arm\n{} tail {} ball\nat 20f {} ball {} hand\nat 60f letgo ball\n", hand_by,
                          link(hand_by), tail_by, link(tail_by), by, link(by));
    const LoadedFilm s(script);
    const auto of_hand = [&](double f) { return hand.on(arm.free(f), hand_by, f); };
    const auto of_ball = [&](double f) {
      return f < 20 ? ball.free(f) : f < 60 ? ball.on(of_hand(f), by, f) : ball.let_go(of_hand(60), by, 60, f);
    };
    for (const double f : {70.5, 10.25, 20.0, 60.0, 41.5, 73.0, 59.75, 90.0}) {
      const double k = std::min(f, 73.0);  // the tracks hold; the times do not
      const World w = f < 60 ? of_ball(f) : ball.let_go(of_hand(60), by, 60, k);
      ASSERT_LT(away(world(s, "hand", f), as_written(of_hand(k))), 1e-9) << script << f;
      ASSERT_LT(away(world(s, "ball", f), as_written(w)), 1e-9) << script << f;
      ASSERT_LT(away(world(s, "tail", f), as_written(tail.on(w, tail_by, k))), 1e-9) << script << f;
    }
    // No jump: at frame 60 it is where the hand still holds it.
    ASSERT_LT(away(world(s, "ball", 60), as_written(ball.on(of_hand(60), by, 60))), 1e-9) << script;
  }
}

// shows: G82 G84 R-H4 R-H5 R-H6
TEST(Attachment, NothingJumpsInAnyHistoryOfHandsAndKeptWorlds) {
  for (unsigned seed = 0; seed < 700; ++seed) {
    Maker make(seed + 10'000);
    std::string script = "rate 24\n";
    for (const char* name : {"arm", "hand", "ball", "tail"}) make.thing(name, script);
    script += "couple hand to arm\ncouple tail to ball\n";
    std::string before = script;
    for (int k = 1; k <= 6; ++k) {
      const int frame = 10 * k;
      const std::string mode = make.mode(), to = make.below(2) ? "hand" : "arm";
      const int what = make.below(4);
      const std::string line = what == 0 ? fmt::format("at {}f letgo ball\n", frame)
                               : what == 1
                                   ? fmt::format("at {}f {} ball {} {}\n", frame, mode, link(mode), to)
                                   : fmt::format("at {}f {} ball {} {} keep-world\n", frame, mode, link(mode), to);
      const std::string after = before + line;
      if (what != 1) {
        const LoadedFilm without(before), with(after);
        for (const char* name : {"ball", "tail"})
          ASSERT_LT(away(world(without, name, frame), world(with, name, frame)), 1e-9) << after << name;
      }
      before = after;
    }
  }
}

// shows: G80 G82 R-H5
TEST(Attachment, AKeptWorldGoesOnRigidly) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Maker make(seed + 20'000);
    std::string script = "rate 24\n";
    const Thing hand = make.thing("hand", script);
    script +=
        "create ball sphere position=(1 2 3) scale=(1 2 1) rotation=axis(1 1 0, 50deg)\n"
        "at 30f couple ball to hand keep-world\n";
    const LoadedFilm s(script);
    const auto still = world(s, "ball", 1);
    World b;
    for (std::size_t i = 0; i < 3; ++i) {
      b.p[i] = still[4 * i + 3];
      for (std::size_t k = 0; k < 3; ++k) b.a[k][i] = still[4 * i + k];
    }
    const World then = hand.free(30);
    const M back = inverse(then.a);
    for (const double f : {30.0, 44.5, 73.0}) {
      const World now = hand.free(f);
      const World wanted{b.a * back * now.a, (b.p - then.p) * back * now.a + now.p, one};
      ASSERT_LT(away(world(s, "ball", f), as_written(wanted)), 1e-9) << script << f;
    }
  }
}

// shows: G81 G82 R-H3 R-H5
TEST(Attachment, DetachJumpsAndLettingGoTwiceIsOnce) {
  std::string script = "rate 24\n";
  Maker make(7);
  const Thing hand = make.thing("hand", script), ball = make.thing("ball", script);
  const std::string held = script + "at 20f couple ball to hand\n";
  const LoadedFilm detached(held + "at 60f detach ball\n"), once(held + "at 40f letgo ball\n"),
      again(held + "at 40f letgo ball\nat 50f letgo ball\n"),
      cleared(held + "at 40f letgo ball\nat 50f letgo ball\nat 60f detach ball\n"),
      never(script + "at 40f letgo ball\n");
  EXPECT_LT(away(world(detached, "ball", 59.5), as_written(ball.on(hand.free(59.5), "couple", 59.5))), 1e-9);
  EXPECT_LT(away(world(detached, "ball", 60), as_written(ball.free(60))), 1e-12);
  EXPECT_GT(away(world(detached, "ball", 60), world(detached, "ball", 59.999)), 0.01);
  for (const double f : {40.0, 50.0, 55.0, 73.0}) EXPECT_EQ(world(once, "ball", f), world(again, "ball", f)) << f;
  EXPECT_LT(away(world(cleared, "ball", 60), as_written(ball.free(60))), 1e-12);
  EXPECT_LT(away(world(never, "ball", 50), as_written(ball.free(50))), 1e-12);
  // A letgo that is overridden at its own time has no effect.
  const LoadedFilm overridden(held + "at 40f letgo ball\nat 40f couple ball to hand\n");
  EXPECT_EQ(world(overridden, "ball", 55), world(LoadedFilm(held), "ball", 55));
}

// shows: G78 R-H1 R-H2
TEST(Attachment, ARodOnAPinKeepsItsOrientation) {
  const LoadedFilm s(
      "create wheel disc scale=(2 2 2)\nwheel.rotation\n  1f euler(0 0 0deg) linear\n  25f euler(0 0 360deg)\n"
      "create rod box attach-position=(1 0 0)\nhang rod on wheel\n");
  for (int k = 0; k <= 24; k += 3) {
    const double a = k * std::acos(-1.0) / 12;
    expect_numbers(s, "rod.world", fmt::format("{}f", k + 1),
                   {1, 0, 0, 2 * std::cos(a), 0, 1, 0, 2 * std::sin(a), 0, 0, 1, 0, 0, 0, 0, 1}, 1e-12);
  }
}

// shows: G79 R-H9
TEST(Attachment, ALampsRangeIsItsOwn) {
  for (const std::string by : {"hang", "attach", "couple"}) {
    const LoadedFilm s(
        "create hand group scale=(10 10 10) position=(1 0 0)\n"
        "create lamp light range=6 scale=(0.5 2 1) attach-position=(0 1 0)\nat 5f " +
        by + " lamp " + link(by) + " hand\nat 9f letgo lamp\n");
    for (const char* f : {"1f", "7f", "12f"}) {
      const Frame frame = s.program.frame(*parse_time(f, s.loaded.document));
      ASSERT_EQ(frame.lights.size(), 1U);
      EXPECT_EQ(frame.lights[0].range, 12) << by << f;  // its largest scale
      EXPECT_NEAR(frame.lights[0].position.y, f[0] == '1' && f[1] == 'f' ? 0 : 10, 1e-12);
    }
  }
}

// shows: G84 R-H4
TEST(Attachment, AnyOrderOfSeeksGivesTheSameBits) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    Maker make(seed + 30'000);
    std::string script = "rate 24\n";
    for (const char* name : {"arm", "hand", "ball", "tail"}) make.thing(name, script);
    script +=
        "couple hand to arm\nattach tail to ball\nat 10f couple ball to hand\nat 20f letgo ball\n"
        "at 30f attach ball to arm keep-world\nat 40f letgo ball\nat 50f hang ball on hand keep-world\n"
        "at 45f letgo hand\nat 55f letgo tail\n";
    const LoadedFilm s(script);
    std::vector<std::vector<double>> played;
    for (int f = 1; f <= 73; ++f) played.push_back(world(s, "tail", f));
    std::vector<int> order;
    for (int f = 1; f <= 73; ++f) order.push_back(f);
    std::shuffle(order.begin(), order.end(), std::mt19937(seed));
    const LoadedFilm other(script);
    for (const int f : order) ASSERT_EQ(world(other, "tail", f), played[static_cast<std::size_t>(f - 1)]) << f;
    for (const int f : {11, 33, 60})
      ASSERT_EQ(world(LoadedFilm(script), "tail", f), played[static_cast<std::size_t>(f - 1)]);
    // All worlds at once, and one alone.
    const Frame frame = s.program.frame(*parse_time("60f", s.loaded.document));
    for (const Item& item : frame.items)
      ASSERT_EQ(numbers(Matrix(item.world)), world(s, s.loaded.document.name(item.id), 60));
  }
}

// shows: G61 R-H6
TEST(Attachment, CirclesAreRefusedWithTheirPath) {
  const std::string head = "create a sphere\ncreate b sphere\ncreate c sphere\n";
  const auto message = [&](const std::string& more) {
    const auto all = all_told(read(head + more));
    return all.size() == 1 ? all[0] : fmt::format("{} errors", all.size());
  };
  const std::string three = "at 1f couple a to b\nat 5f hang b on c\nat 9f attach c to a\n";
  EXPECT_EQ(message(three), "name 6:14 c");
  EXPECT_TRUE(mentions(head + three, "c → b → a → c"));
  EXPECT_EQ(message("couple a to a\n"), "name 4:8 a");
  EXPECT_EQ(message("at 3f hang a on a\n"), "name 4:12 a");
  EXPECT_EQ(message("at 10f couple a to b\nat 5f couple b to a\n"),
            "name 5:14 b");  // from frame 10 on
  EXPECT_TRUE(mentions(head + "at 10f couple a to b\nat 5f couple b to a\n", "b → a → b"));
  // Not at the same time: no circle.
  const LoadedFilm s(head + "at 1f couple a to b\nat 5f letgo a\nat 9f couple b to a\n");
  EXPECT_TRUE(s.program.frame({}).problems.empty());
}

// shows: G84 G39 R-H6
TEST(Attachment, ACircleMadeByMovingIsLeftOutAndSaid) {
  const std::string moved = "move a.attachment 10f..15f by 15f\n";  // to 25f and 30f, where b hangs on a
  const Loaded l = read(
      "rate 24\ncreate a sphere position=(1 0 0)\ncreate b sphere position=(0 1 0)\n"
      "at 10f couple a to b\nat 15f letgo a\nat 20f couple b to a\n" +
      moved);
  ASSERT_FALSE(has_errors(l.diagnostics)) << said(l.diagnostics);
  const Program p = Program::compile(l.document);
  const Frame f = p.frame(*parse_time("27f", l.document));
  ASSERT_EQ(f.problems.size(), 1U);
  EXPECT_EQ(f.problems[0],
            "'a' cannot have the parent 'b', which is below it at that time: this attachment is left out");
  ASSERT_EQ(f.items.size(), 2U);
  EXPECT_EQ(translation_of(f.items[0].world), (Vec3{1, 0, 0}));
  EXPECT_EQ(translation_of(f.items[1].world), (Vec3{1, 1, 0}));
}

// shows: G84 G39 G40 G95 R-T10
TEST(Attachment, TracksOfItAreCopiedMovedAndStretched) {
  const std::string head =
      "rate 24\ncreate hand group position=(0 10 0)\ncreate ball sphere position=(1 0 0)\ncreate other sphere\n"
      "at 10f couple ball to hand\nat 20f detach ball\n";
  const auto height = [&](const std::string& more, const char* name, int frame) {
    return world(LoadedFilm(head + more), name, frame)[7];
  };
  const auto heights = [&](const std::string& more, const char* name = "ball") {
    std::string out;
    for (int f = 5; f <= 75; f += 10) out += height(more, name, f) > 5 ? '^' : '_';
    return out;
  };
  EXPECT_EQ(heights(""), "_^______");
  EXPECT_EQ(heights("move ball.attachment 10f..20f by 20f\n"), "___^____");
  EXPECT_EQ(heights("copy ball.attachment 10f..20f to 40f\n"), "_^__^___");
  EXPECT_EQ(heights("copy ball.attachment 10f..20f to 40f on other.attachment\n", "other"), "____^___");
  EXPECT_EQ(heights("stretch ball.attachment 10f..20f by 3\n"), "_^^^____");
  EXPECT_EQ(heights("clear ball.attachment 20f\n"), "_^^^^^^^");
  EXPECT_EQ(heights("clear ball.attachment 10f..20f\n"), "________");
  EXPECT_EQ(heights("couple ball to hand\nat 10f letgo ball\nreverse ball.attachment 10f..20f\n").size(), 8U);
  // Written and read back it is the same.
  const LoadedFilm s(head + "copy ball.attachment 10f..20f to 40f\nat 70f attach ball to hand keep-world\n");
  EXPECT_EQ(load_text(write(s.loaded.document), "w.bx").document, s.loaded.document) << write(s.loaded.document);
}

// shows: G81 G61
TEST(Attachment, RemovingAParentFreesItsChildren) {
  for (const char* how : {"couple ball to hand\n", "at 1f couple ball to hand\n",
                          "at 1f couple ball to hand keep-world\n", "at 1f couple ball to hand\nat 3f letgo ball\n"}) {
    const LoadedFilm s(std::string("create hand group position=(0 10 0)\ncreate ball sphere position=(1 0 0)\n") + how +
                       "remove hand\n");
    EXPECT_EQ(world(s, "ball", 10)[3], 1) << how;
    EXPECT_EQ(world(s, "ball", 10)[7], 0) << how;
    EXPECT_TRUE(s.program.frame({}).problems.empty());
    EXPECT_EQ(write(load_text(write(s.loaded.document), "w.bx").document), write(s.loaded.document));
    EXPECT_EQ(load_text(write(s.loaded.document), "w.bx").document, s.loaded.document) << how;  // nothing of it is left
  }
}

// shows: G84
TEST(Attachment, BeforeTheFirstEventIsWhatHoldsFromTheBeginning) {
  const Document d = read("create h group\ncreate b sphere\nat 20f couple b to h\n").document;
  const Program p = Program::compile(d);
  const Target t{d.find("b"), fn::attachment};
  EXPECT_EQ(std::get<Attachment>(p.read(t, d.rate().frame(12))), Attachment{});
  EXPECT_EQ(std::get<Attachment>(p.read(t, d.rate().frame(20))),
            (Attachment{AttachmentKind::couple, d.find("h"), false}));
}

// shows: G61 G80
TEST(Attachment, HierarchyByNameAndByCouple) {
  const LoadedFilm s(
      "create car group position=(10 0 0)\ncreate car/wheel sphere position=(1 0 0) attach-position=(0 1 0)\n"
      "create dog sphere position=(0 0 5)\ncouple dog to car/wheel\ncreate cat sphere position=(0 0 5)\n"
      "couple cat to car\ndetach cat\nset car.scale (2 2 2)\nrename car bus\n");
  const Frame f = s.program.frame({});
  const auto at = [&](const char* name) {
    const auto m = s.numbers(std::string(name) + ".world", "1f");
    return std::vector<double>{m[3], m[7], m[11]};
  };
  EXPECT_EQ(at("bus/wheel"), (std::vector<double>{12, 2, 0}));  // what is below it goes along
  EXPECT_EQ(at("dog"), (std::vector<double>{12, 2, 10}));
  EXPECT_EQ(at("cat"), (std::vector<double>{0, 0, 5}));
}

TEST(Attachment, CirclesOfCouples) {
  const Loaded l = read("create a group\ncreate a/b group\ncreate c group\ncouple c to a/b\ncouple a to c\n");
  EXPECT_EQ(all_told(l), (std::vector<std::string>{"name 5:8 a"}));
  EXPECT_TRUE(mentions(l, "a → a/b → c → a"));
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests films that use every feature. Any order of times and many threads must give the same bits as forward playback.
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <thread>

#include "support/dice.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

class Film : Dice {
 public:
  using Dice::Dice;
  std::string script() {
    std::string s =
        "rate 24\nrange 1f 72f\ndefine heat number = \"value('.position.y') + math.sin(t)\"\n"
        "procedure swing lua \"return math.sin(3 * t) + value('o0.position.x', t - 0.1)\"\n"
        "procedure dip twerper lua \"u * u\"\nprocedure half filter lua \"0.5 * (input() + input(t - 0.2))\"\n"
        "layer sway add weight=0.7\nlayer over mix\nsway.weight\n  1f 0 linear\n  60f 1\n"
        "over.weight\n  20f 0 linear\n  40f 1\ncreate lamp light\ncreate eye camera look-at=o1 position=(9 9 20)\n";
    s.replace(s.find("look-at=o1 "), 11, "");
    for (int i = 0; i < 5; ++i) {
      s += fmt::format("create o{} sphere position={}\n", i, vector());
      s += fmt::format("o{}.position\n  1f {} linear\n  {}f {} dip\n  50f {}\n", i, vector(), 10 + below(30), vector(),
                       vector());
    }
    s += "set eye.look-at o1\nanimate spin every 2t by rotate(7deg, y) @ (1 0 0) slower 1t per 20t\n"
         "animate drift every 1t by translate(0.02 0 0)\nset o1.drive spin\n";
    for (int i = 8 + below(14); i > 0; --i) s += line();
    return s;
  }

 private:
  std::string number() { return fmt::format("{}", (below(1000) - 500) / 128.0); }
  std::string vector() { return "(" + number() + " " + number() + " " + number() + ")"; }
  std::string turn() { return fmt::format("axis({} 1 {}, {}deg)", number(), number(), below(170)); }
  int frame() { return 1 + below(70); }
  std::string line() {
    const int i = below(5);
    const int to = i > 0 ? below(i) : 4;  // upwards, but for one that may close a circle and be refused
    switch (below(18)) {
      case 0:
        return fmt::format("at {}f o{}.position.velocity {}\n", frame(), i, vector());
      case 1:
        return fmt::format("at {}f o{}.position.velocity release\n", frame(), i);
      case 2:
        return fmt::format("at {}f o{}.rotation.velocity {}\nat {}f o{}.rotation.velocity {}\n", frame(), i, turn(),
                           frame(), i, turn());
      case 3:
        return i == 0 ? "" : fmt::format("at {}f couple o{} to o{} keep-world\n", frame(), i, to);
      case 4:
        return i == 0 ? ""
                      : fmt::format("at {}f {} o{} {} o{}\n", frame(), below(2) ? "attach" : "couple", i, "to", to);
      case 5:
        return fmt::format("at {}f letgo o{}\n", frame(), i);
      case 6:
        return fmt::format("on {} at {}f o{}.position {}\n", below(2) ? "sway" : "over", frame(), i, vector());
      case 7:
        return fmt::format(
            "filter o{}.position {}\n", i,
            std::string(std::array{"smooth width=5f", "delay by=3f", "noise amount=0.3 seed=2", "wobble amount=0.2",
                                   "spring", "half"}[static_cast<std::size_t>(below(6))]));
      case 8:
        return fmt::format("at {}f o{}.scale = \"vec(1, 1 + 0.1 * math.abs(value('o{}.position.y', t - 0.3)), 1)\"\n",
                           frame(), i, below(5));
      case 9:
        return fmt::format("o{}.transparency\n  {}f = \"clamp(value('o{}.heat') / 9, 0, 1)\"\n", i, frame(), below(5));
      case 10:
        return fmt::format("at {}f o{}.radius = \"2 + swing()\"\n", frame(), i);
      case 11:
        return fmt::format("at {}f o{}.heat = \"value('o{}.heat') + value('o{}.world')[4]\"\n", frame(), i, below(5),
                           below(5));
      case 12:
        return fmt::format("at {}f o{}.rotation {}\nat {}f o{}.rotation {}\n", frame(), i, turn(), frame(), i, turn());
      case 13:
        return fmt::format("at {}f o{}.environments {}\n", frame(), i, below(2) ? "(drift spin)" : "spin");
      case 14:
        return fmt::format("at {}t {} {}\n", below(90), below(3) ? "halt" : "cancel", below(2) ? "spin" : "drift");
      case 15:
        return fmt::format("at {}t animate spin every {}t by rotate({}deg, z) translate(0 0.1 0)\n", below(90),
                           1 + below(4), below(90));
      case 16:
        return fmt::format("at 8f..{}f o{}.motion T{} R({}deg @ o{} axis 1 2 3) S(1.1 0.9 @ {} 0) ease-out=4f\n",
                           10 + below(50), i, vector(), below(900), below(5), number());
      default:
        return fmt::format("at {}f o{}.color.r.velocity 0.25\n", frame(), i);
    }
  }
};

// All that a frame says and all that is read, as bits.
std::vector<double> everything(const Program& p, Time t) {
  const Frame f = p.frame(t);
  std::vector<double> out;
  const auto matrix = [&](const Mat4& m) { out.insert(out.end(), std::begin(m.m), std::end(m.m)); };
  for (const Item& i : f.items) {
    matrix(i.world);
    out.insert(out.end(), {i.color.x, i.color.y, i.color.z, i.transparency, i.shape->radius});
  }
  matrix(f.camera.world);
  for (const Light& l : f.lights) out.insert(out.end(), {l.position.x, l.position.y, l.position.z, l.range});
  for (const std::string& s : f.problems) out.push_back(static_cast<double>(std::hash<std::string>{}(s) >> 12));
  for (const char* target : {"o1.heat", "o4.position.velocity", "o2.world", "o3.rotation.velocity"})
    for (double d : numbers(p.read(find_targets(target, p.document())->front(), t))) out.push_back(d);
  return out;
}
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
           return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
         });
}

// shows: G31 G36 G47 G55 G58 G105 R-T5 R-T11 R-T16 R-H4 C7 C127
TEST(Purity, AnyOrderAndAnyThreadGivesTheBitsOfPlaying) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const std::string text = Film(seed).script();
    const Loaded l = read(text);
    if (has_errors(l.diagnostics)) RC_FAIL(text + said(l.diagnostics));
    std::vector<Time> times;
    for (int k = 0; k < 24; ++k) times.push_back(*parse_time(fmt::format("{}f", 1 + 3.125 * k), l.document));
    const Program played = Program::compile(l.document);
    std::vector<std::vector<double>> film;
    for (const Time t : times) film.push_back(everything(played, t));
    const Program p = Program::compile(l.document);
    std::array<int, 4> wrong{};
    const auto seek = [&](std::size_t who) {
      std::vector<std::size_t> order(times.size());
      for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
      std::shuffle(order.begin(), order.end(), std::mt19937_64(seed + who));
      for (const std::size_t k : order) wrong[who] += !same(everything(p, times[k]), film[k]);
    };
    std::vector<std::thread> threads;
    for (std::size_t who = 0; who < 4; ++who) threads.emplace_back(seek, who);
    for (std::thread& t : threads) t.join();
    if (wrong != std::array<int, 4>{}) RC_FAIL(text);
  }));
}

// Where a thing is, asked for alone, is where its whole matrix has it; of all at once, too.
TEST(Purity, PlacesAskedForAloneAreThoseOfTheFrame) {
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    const LoadedFilm s(Film(seed).script() +
                       "set o2.look-at o3\nset o3.look-at eye\nset o4.pivot (1 2 0)\ncreate hat box position=(1 2 3)\n"
                       "couple hat to o2\nset o0.pivot.y = \"t\"\n");
    const Document& d = s.loaded.document;
    std::vector<Target> all;
    for (const char* name : {"o0", "o1", "o2", "o3", "o4", "eye", "hat"})
      for (const char* part : {".world", ".world.x", ".world.y", ".world.z"})
        all.push_back(find_targets(std::string(name) + part, d)->front());
    for (const char* time : {"1f", "9.5f", "30f", "55f"}) {
      const std::vector<Value> together = s.program.read(all, *parse_time(time, d));
      for (std::size_t k = 0; k < all.size(); ++k) {
        const auto is = numbers(s.program.read(all[k], *parse_time(time, d))), wanted = numbers(together[k]);
        EXPECT_EQ(is, wanted) << d.name(all[k]) << " at " << time << ", film " << seed;
        const std::size_t c = k % 4;
        if (c > 0) {
          EXPECT_EQ(is[0], numbers(together[k - c])[4 * c - 1]) << d.name(all[k]) << " at " << time;
        }
      }
    }
  }
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests stepped procedures: each state against the same law integrated here or in closed form; the same bits in any
// order, from several threads and after another history; and wrong steps.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <thread>

#include "scene/functions.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

Vec3 position(const Program& p, const Document& d, std::string_view object, Time t) {
  return std::get<Vec3>(p.read(Target{d.find(object), fn::position, -1}, t));
}

double number(const LoadedFilm& s, std::string_view target, std::string_view time) {
  return s.numbers(target, time)[0];
}

std::string film(const std::string& procedure, const std::string& value = "chase()") {
  return "rate 24\nrange 1f 240f\ncreate fox sphere\ncreate hare sphere\nhare.position\n  1f (0 0 0) linear\n  241f "
         "(20 0 "
         "0)\nprocedure chase " +
         procedure + "\nset fox.position = \"" + value + "\"\n";
}
const std::string pursuit =
    "steps lua \"local p = state or vec(0, 6, 0) "
    "return p + normalize(value('hare.position', t - dt) - p) * (3 * dt)\"";

// shows: S1
TEST(Steps, APursuitIsThatOfAPlainLoop) {
  const LoadedFilm s(film(pursuit));
  Vec3 p{0, 6, 0};
  for (int k = 0; k <= 240; ++k) {
    const Vec3 hare{20.0 * std::max(0, k - 1) / 240, 0, 0};
    const Vec3 to = hare - p;
    p = p + (3.0 / 24 / length(to)) * to;
    if (k % 30 == 7) {
      const Vec3 is = position(s.program, s.loaded.document, "fox", s.loaded.document.rate().frame(k + 1));
      EXPECT_NEAR(length(is - p), 0, 1e-12) << k;
    }
  }
}

// Symplectic Euler for x'' = -w² x has a closed form: x_k = cos((k + 1/2) a) / cos(a / 2) with sin(a / 2) = w dt / 2,
// if v_0 is chosen so.
TEST(Steps, AHundredThousandStepsOfASpring) {
  const LoadedFilm s(
      "rate 100\nrange 1f 10f\ncreate a sphere\nprocedure law steps lua \"if not state then return {x = 1, v = "
      "-0.05} "
      "end local v = state.v - state.x * 100 * dt * dt / dt return {x = state.x + v * dt, v = v}\"\n"
      "set a.position.x = \"law().x\"\n");
  const double dt = 0.01, w = 10, angle = 2 * std::asin(w * dt / 2);
  // x_0 = 1 and v_0 = -0.05 fix amplitude and phase: x_k = A cos(k angle + phase), with x_1 - x_0 = (v_0 - w² dt) dt.
  const double x1 = 1 + (-0.05 - w * w * dt) * dt;
  const double phase = std::atan2(std::cos(angle) - x1, std::sin(angle)), amplitude = 1 / std::cos(phase);
  for (const int k : {0, 1, 17, 1000, 99'999}) {
    const Vec3 is = position(s.program, s.loaded.document, "a", Rate{100, 1}.frame(k + 1));
    EXPECT_NEAR(is.x, amplitude * std::cos(k * angle + phase), 1e-7) << k;
  }
}

TEST(Steps, TheSameBitsInAnyOrderAndFromAnyThread) {
  const std::string script = film(pursuit);
  std::vector<Time> times;
  for (int i = 0; i < 200; ++i) times.push_back(Time{flicks_per_second / 31 * i});
  const auto values = [&](const std::vector<Time>& order) {
    const LoadedFilm s(script);
    std::map<Time, Vec3> out;
    for (const Time t : order) out[t] = position(s.program, s.loaded.document, "fox", t);
    return out;
  };
  const auto forwards = values(times);
  std::mt19937 random(5);
  for (int round = 0; round < 3; ++round) {
    std::shuffle(times.begin(), times.end(), random);
    EXPECT_EQ(values(times), forwards);
  }
  const LoadedFilm shared(script);
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      for (std::size_t i = 0; i < times.size(); ++i) {
        const Time t = times[(i * 7 + static_cast<std::size_t>(k) * 50) % times.size()];
        EXPECT_EQ(position(shared.program, shared.loaded.document, "fox", t), forwards.at(t));
      }
    });
  for (std::thread& t : threads) t.join();
}

// More states than are kept: 100,000 tables of a hundred entries. Going back starts from a checkpoint.
TEST(Steps, CheckpointsGiveTheStatesOfTheFirstTime) {
  const LoadedFilm s(
      "rate 24\nrange 1f 10f\ncreate a sphere\nprocedure many steps lua \"local s = {} for i = 1, 300 do s[i] = (state "
      "and "
      "state[i] or i) * 0.999 + 0.001 * i % 7 end return s\"\nset a.position.x = \"many()[17]\"\n");
  std::map<int, double> first;
  for (const int k : {100, 1500, 2500, 3000}) first[k] = number(s, "a.position.x", std::to_string(k) + "f");
  for (const int k : {1500, 100, 2500}) EXPECT_EQ(number(s, "a.position.x", std::to_string(k) + "f"), first[k]);
  double x = 17;
  for (int k = 1; k <= 100; ++k) x = x * 0.999 + std::fmod(0.001 * 17, 7);
  EXPECT_NEAR(first[100], x, 1e-12);
}

TEST(Steps, BetweenTwoStepsNumbersBlendAndWholeNumbersHold) {
  const std::string code = "lua \"return {n = step, x = step * 1.0, v = vec(step, 0, 0), s = 'at ' .. step}\"";
  const auto at = [&](const std::string& options, const std::string& value, const char* time) {
    const LoadedFilm s("rate 24\ncreate a sphere\nprocedure c steps " + options + code + "\nset a.position.x = \"" +
                       value + "\"\n");
    return number(s, "a.position.x", time);
  };
  EXPECT_EQ(at("", "c().n", "3.5f"), 2);
  EXPECT_EQ(at("", "c().x", "3.5f"), 2.5);
  EXPECT_EQ(at("", "c().v.x", "3.25f"), 2.25);
  EXPECT_EQ(at("", "#c().s", "3.5f"), 4);
  EXPECT_EQ(at("hold ", "c().x", "3.5f"), 2);
  EXPECT_EQ(at("every 2f ", "c().x", "4f"), 1.5);
  EXPECT_EQ(at("every 2f from 5f ", "c().x", "9f"), 2);
  EXPECT_EQ(at("from 5f ", "c().x", "2f"), 0);  // before the beginning
  EXPECT_EQ(at("", "c(t - 1/24).x", "9f"), 7);
}

// Two that read each other's past; a plain loop does the same.
TEST(Steps, CirclesThroughThePast) {
  const LoadedFilm s(
      "rate 10\nrange 1f 100f\ncreate {a,b} sphere\n"
      "procedure one steps lua \"return state and state + 0.1 * (value('b.position.x', t - dt) - state) or 0.0\"\n"
      "procedure two steps lua \"return state and state + 0.3 * (one(t - dt) - state) or 5.0\"\n"
      "set a.position.x = \"one()\"\nset b.position.x = \"two()\"\n");
  double a = 0, b = 5;
  for (int k = 1; k <= 90; ++k) {
    const double was = a;
    a += 0.1 * (b - a), b += 0.3 * (was - b);
  }
  EXPECT_NEAR(number(s, "b.position.x", "91f"), b, 1e-12);
  EXPECT_NEAR(number(s, "a.position.x", "91f"), a, 1e-12);
  EXPECT_TRUE(s.frame("91f").problems.empty());
}

// A row of cells by rule 30, as whole numbers, which hold between two steps; and by the table of the rule.
TEST(Steps, ACellularAutomaton) {
  const LoadedFilm s(
      "rate 24\ncreate a text text=\"\"\nprocedure row steps lua \"local r = {} for i = 1, 33 do if not state then "
      "r[i] = i == "
      "17 and 1 or 0 else local l, c, n = state[i - 1] or 0, state[i], state[i + 1] or 0 r[i] = (l + c + n + c * n) % "
      "2 "
      "end end return r\"\nset a.text = \"local s = '' for _, c in ipairs(row()) do s = s .. c end return s\"\n");
  std::vector<int> cells(35, 0);
  cells[17] = 1;
  for (int k = 1; k <= 15; ++k) {
    std::vector<int> next(35, 0);
    for (std::size_t i = 1; i <= 33; ++i) next[i] = (30 >> (4 * cells[i - 1] + 2 * cells[i] + cells[i + 1])) & 1;
    cells = next;
  }
  std::string row;
  for (std::size_t i = 1; i <= 33; ++i) row += std::to_string(cells[i]);
  EXPECT_EQ(s.text("a.text", "16.5f"), row);
  EXPECT_EQ(s.text("a.text", "5f"), "000000000000110010001000000000000");
}

std::vector<std::string> problems(const std::string& procedure, const char* time = "20f",
                                  const std::string& value = "chase()") {
  const LoadedFilm s(film(procedure, value));
  return s.frame(time).problems;
}

TEST(Steps, WrongStepsAreErrorsWithTheStep) {
  const auto one = [](const std::string& procedure, const char* time = "20f") {
    const auto all = problems(procedure, time);
    return all.size() == 1 ? all[0] : std::to_string(all.size()) + " problems";
  };
  EXPECT_EQ(one("steps lua \"if step == 7 then return nosuch.x end return vec(step, 0, 0)\""),
            "chase: step 7 at 8f failed: attempt to index a nil value (global 'nosuch')");
  EXPECT_EQ(one("steps lua \"while step == 3 do end return vec(0, 0, 0)\""),
            "chase: step 3 at 4f failed: stopped: it took more than 1000000 steps");
  EXPECT_EQ(one("steps lua \"local s = vec(0, 0, 0) if step == 3 then s = {} for i = 1, 30000 do s[i] = i end end "
                "return s\""),
            "chase: step 3 at 4f failed: a state can have at most 20000 entries");
  const std::string circle =
      "it depends on itself: a step can read its own state only at earlier times, as in (t - dt)";
  EXPECT_EQ(one("steps lua \"return step == 0 and vec(0, 0, 0) or chase(t + dt)\""),
            "chase: step 1 at 2f failed: " + circle);
  EXPECT_EQ(one("steps lua \"return step < 4 and vec(0, 0, 0) or value('fox.position')\""),
            "chase: step 4 at 5f failed: " + circle);
  EXPECT_EQ(one("steps lua \"if step == 2 then return nil end return vec(0, 0, 0)\""),
            "chase: step 2 at 3f failed: it returned no state");
  // Before the step that fails, all is well; after it, the last good state stays.
  const std::string code = "steps lua \"if step == 7 then return nil + 1 end return vec(step, 0, 0)\"";
  EXPECT_TRUE(problems(code, "7f").empty());
  const LoadedFilm s(film(code));
  EXPECT_EQ(position(s.program, s.loaded.document, "fox", s.loaded.document.rate().frame(20)), (Vec3{6, 0, 0}));
}

// Two that need each other at the same step both fail there, whichever is asked for first.
TEST(Steps, ACircleWithinAStepFailsTheSameFromEverywhere) {
  const std::string script =
      "rate 10\nrange 1f 100f\ncreate {a,b,c} sphere\n"
      "procedure one steps lua \"return (state or 1.0) + (step < 5 and 0 or two(t))\"\n"
      "procedure two steps lua \"return (state or 2.0) * 1.5 + (step < 3 and 0 or one(t + (step > 8 and 0.1 or "
      "-0.1)))\"\n"
      "procedure three steps lua \"return one(t) + 100 * two(t)\"\n"
      "set a.position.x = \"one()\"\nset b.position.x = \"two()\"\nset c.position.x = \"three()\"\n";
  std::vector<std::string> order{"a.position.x", "b.position.x", "c.position.x"};
  std::map<std::string, double> first;
  do {
    const LoadedFilm s(script);
    for (const char* time : {"30f", "7f", "12f"})
      for (const std::string& target : order) {
        const double is = number(s, target, time);
        const auto [at, fresh] = first.emplace(target + time, is);
        EXPECT_EQ(at->second, is) << target << " at " << time;
      }
    const Frame f = s.frame("30f");
    EXPECT_EQ(f.problems.size(), 2u);  // of one and two; three goes on with their last good states
  } while (std::next_permutation(order.begin(), order.end()));
}

// What a frame reports does not depend on the frames before it.
TEST(Steps, ProblemsOfLaterStepsAreNotThoseOfEarlierFrames) {
  const std::string script =
      "rate 24\nrange 1f 40f\ncreate {a,b,c} sphere\n"
      "set b.position.x = \"if t > 0.7 then error('late') end return t\"\n"
      "procedure law steps lua \"return (state or 0.0) + (step < 24 and 1 or value('b.position.x') + "
      "value('c.position.x'))\"\nset a.position.x = \"law()\"\n";
  const LoadedFilm fresh(script), used(script);
  EXPECT_EQ(used.frame("30f").problems.size(), 1u);
  EXPECT_TRUE(fresh.frame("10f").problems.empty());
  EXPECT_TRUE(used.frame("10f").problems.empty());
  const Target law{used.loaded.document.find("a"), fn::position, 0};
  EXPECT_EQ(used.program.reads(law, used.loaded.document.rate().frame(10)).size(), 0u);
  EXPECT_EQ(used.program.reads(law, used.loaded.document.rate().frame(30)).size(), 2u);
}

TEST(Steps, AnErrorPointsIntoTheCodeOfTheSteps) {
  for (const char* code : {"return nosuch()", "return step < 1 and vec(0, 0, 0) or nosuch()"}) {
    const LoadedFilm s(film(std::string("steps lua \"") + code + "\""));
    const Frame f = s.frame("3f");
    ASSERT_FALSE(f.reports.empty());
    EXPECT_EQ(f.reports[0].source, code);
  }
}

TEST(Steps, AreWrittenAndReadAgain) {
  const std::string line = "procedure c steps every 3f from 5f hold lua \"state or 1\"";
  const LoadedFilm s("rate 24\n" + line + "\n");
  const std::string text = write(s.loaded.document);
  EXPECT_NE(text.find(line), std::string::npos) << text;
  EXPECT_EQ(load_text(text, "x.bx").document, s.loaded.document);
}

}  // namespace
}  // namespace betwixt

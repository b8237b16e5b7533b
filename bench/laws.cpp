// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures films whose values need their past: tracks among obstacles, stepped procedures, and velocities that code
// computes. Each is played beside the same film without the law, in turns. The first look is at the end of the film,
// for which everything before it is computed. Values are compared with what they must be.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/language.h"
#include "betwixt/program.h"
#include "timing.h"

using namespace betwixt;

namespace {

constexpr int rounds = 5, balls = 100, frames = 241;

struct Law {
  const char* name;
  std::string with, without;
  bool (*right)(const Program&);  // whether the values at the end are right
};

Document read(const std::string& text) {
  const Loaded film = load_text(text, "bench.bx");
  insist(!has_errors(film.diagnostics), "the film has errors");
  return film.document;
}

double number(const Program& p, const char* target, double seconds) {
  const auto found = find_targets(target, p.document());
  return std::get<double>(p.read(found->front(), from_seconds(seconds)));
}

std::vector<Law> laws() {
  const std::string room =
      fmt::format("rate 24\nrange 1f {}f\ncreate b{{1..{}}} sphere radius=0.2 position=(i 6 0)\n", frames, balls) +
      "create wall{1..9} box size=(0.4 4 4) position=(12*i 20 0)\ncreate floor box size=(300 1 20) position=(50 -0.5 "
      "0)\n" +
      "at 1f fall b* ground=none for 10s\n";
  const std::string runners = fmt::format("rate 24\nrange 1f {}f\ncreate b{{1..{}}} sphere\n", frames, balls);
  return {
      {"obstacles", room + "alias walls = wall* floor\nset b*.obstacles (walls)\nset b*.collision bounce\n", room,
       [](const Program& p) { return number(p, "b7.position.y", 10) >= 0.2 - 1e-6; }},
      // A spring of semi-implicit steps, and its plain loop below.
      {"stepped procedures",
       runners +
           "procedure swing steps every 0.01s lua \"local s = state or {x = 1, v = 0} local v = s.v - 4 * s.x * dt "
           "return {x = s.x + v * dt, v = v}\"\nset b*.position.y = \"swing().x + i\"\n",
       runners + "set b*.position.y = \"cos(2 * t) + i\"\n",
       [](const Program& p) {
         double x = 1, v = 0;
         for (int k = 0; k <= 1000; ++k) v -= 4 * x * 0.01, x += v * 0.01;
         return std::abs(number(p, "b7.position.y", 10) - 7 - x) < 1e-9;
       }},
      {"velocities of code", runners + "at 1f b*.position.y.velocity = \"cos(t + i)\"\n",
       runners + "at 1f b*.position.y = \"sin(t + i)\"\n",
       [](const Program& p) {
         return std::abs(number(p, "b7.position.y", 10) - (std::sin(17.0) - std::sin(7.0))) < 1e-8;
       }},
  };
}

struct Times {
  double first = 0, frame = 0;
};
Times play(const Document& d) {
  Times t;
  const Time end = d.range().second;
  const Program late = Program::compile(d);
  t.first = milliseconds([&] { Evaluation(late).to(end); });
  const Program program = Program::compile(d);
  Evaluation e(program);
  t.frame = milliseconds([&] {
              for (int k = 0; k < frames; ++k) e.to(d.rate().frame(1 + k));
            }) /
            frames;
  return t;
}

double median(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  return all[all.size() / 2];
}

}  // namespace

int main() {
  std::printf("%d objects, %d frames; milliseconds, the minimum and the median of %d rounds\n", balls, frames, rounds);
  std::printf("%-20s %20s %20s %20s %10s\n", "", "first look at 10 s", "a frame forward", "without the law", "ratio");
  for (const Law& law : laws()) {
    const Document with = read(law.with), without = read(law.without);
    insist(law.right(Program::compile(with)), law.name);
    std::vector<double> first, frame, plain, ratio;
    for (int k = 0; k < rounds; ++k) {
      const Times a = play(with), b = play(without);
      first.push_back(a.first), frame.push_back(a.frame), plain.push_back(b.frame), ratio.push_back(a.frame / b.frame);
    }
    const auto both = [](const std::vector<double>& all) {
      return fmt::format("{:.3g} {:.3g}", *std::min_element(all.begin(), all.end()), median(all));
    };
    std::printf("%-20s %20s %20s %20s %10.1f\n", law.name, both(first).c_str(), both(frame).c_str(),
                both(plain).c_str(), median(ratio));
  }
}

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures a scatter of a million points: on axes at rest, on axes that zoom, on logarithmic ones, and while the data
// turn into other data. The places are compared with those that a plain loop computes.
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

constexpr int count = 1'000'000, frames = 49;

Vec3 datum(int i, double turn) { return {1 + 8 * std::abs(std::sin(i * 0.7391 + turn)), 1 + 8.0 * i / count, 0}; }

std::string data(double turn) {
  std::string out = "(";
  for (int i = 0; i < count; ++i) {
    const Vec3 p = datum(i, turn);
    out += fmt::format("({:.4f} {:.6f})", p.x, p.y);
  }
  return out + ")";
}

struct Case {
  const char* name;
  std::string axes, events;
};

void measure(const Case& one, const std::string& points) {
  const std::string text = "film flat\nrate 24\nrange 1f 49f\ncreate ax axes " + one.axes +
                           " size=(8 8) bare=on\ncreate s scatter on=ax of=" + points + " size=0.01\n" + one.events;
  const Loaded film = load_text(text, "bench.bx");
  insist(!has_errors(film.diagnostics), "the film has errors");
  const Program program = Program::compile(film.document);
  std::vector<double> times;
  for (int f = 0; f < frames; ++f) {
    Frame frame;
    times.push_back(milliseconds([&] { frame = program.frame(from_seconds(f / 24.0)); }));
    const auto at = std::find_if(frame.items.begin(), frame.items.end(),
                                 [](const Item& i) { return i.shape->kind == Kind::scatter; });
    insist(at != frame.items.end() && !at->shape->points->empty(), "points are there");
    if (f > 0) continue;
    insist(at->shape->points->size() == count, "all points are there");
    const Vec3 is = (*at->shape->points)[777'777], p = datum(777'777, 0);
    const bool log = one.axes.find("log") != std::string::npos;
    const Vec3 wanted = log ? Vec3{8 * std::log10(p.x) - 4, 0.8 * p.y - 4, 0} : Vec3{0.8 * p.x - 4, 0.8 * p.y - 4, 0};
    insist(std::abs(is.x - wanted.x) + std::abs(is.y - wanted.y) < 2e-3, "a point is where it must be");
  }
  std::sort(times.begin(), times.end());
  std::printf("%-8s %6.1f %6.1f %6.1f ms a frame (minimum, median, maximum): %.0f frames a second\n", one.name,
              times.front(), times[times.size() / 2], times.back(), 1000 / times[times.size() / 2]);
  report(one.name, times[times.size() / 2]);
}

}  // namespace

int main() {
  const std::string plain = "x=(0 10) y=(0 10)", first = data(0);
  const std::string zoom = "at 1f ax.x (0 10) linear\nat 49f ax.x (2 5)\n";
  measure({"rest", plain, ""}, first);
  measure({"zoom", plain, zoom}, first);
  measure({"log", "x=(1 10) y=(0 10) x-scale=log", "at 1f ax.y (0 10) linear\nat 49f ax.y (2 5)\n"}, first);
  measure({"data", plain, "at 1f s.points " + first + " linear\nat 49f s.points " + data(1) + "\n" + zoom}, first);
}

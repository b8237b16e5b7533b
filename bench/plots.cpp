// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures plots. A scatter of a million points: on axes at rest, on axes that zoom, on logarithmic ones, and while the
// data turn into other data; its places are compared with those that a plain loop computes. And what is computed anew
// for each frame by a formula: a surface, streamlines, a curve, a chart.
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

// Returns the times of all frames; `look` sees each.
template <class Look>
void measure(const char* name, const std::string& text, const Look& look) {
  const Loaded film = load_text(text, "bench.bx");
  insist(!has_errors(film.diagnostics), "the film has errors");
  const Program program = Program::compile(film.document);
  std::vector<double> times;
  for (int f = 0; f < frames; ++f) {
    Frame frame;
    times.push_back(milliseconds([&] { frame = program.frame(from_seconds(f / 24.0)); }));
    look(frame, f);
  }
  std::sort(times.begin(), times.end());
  std::printf("%-12s %6.1f %6.1f %6.1f ms a frame (minimum, median, maximum): %.0f frames a second\n", name,
              times.front(), times[times.size() / 2], times.back(), 1000 / times[times.size() / 2]);
  report(name, times[times.size() / 2]);
}

void measure_scatter(const Case& one, const std::string& points) {
  const bool log = one.axes.find("log") != std::string::npos;
  measure(one.name,
          "film flat\nrate 24\nrange 1f 49f\ncreate ax axes " + one.axes +
              " size=(8 8) bare=on\ncreate s scatter on=ax of=" + points + " size=0.01\n" + one.events,
          [&](const Frame& frame, int f) {
            const auto at = std::find_if(frame.items.begin(), frame.items.end(),
                                         [](const Item& i) { return i.shape->kind == Kind::scatter; });
            insist(at != frame.items.end() && !at->shape->points->empty(), "points are there");
            if (f > 0) return;
            insist(at->shape->points->size() == count, "all points are there");
            const Vec3 is = (*at->shape->points)[777'777], p = datum(777'777, 0);
            const double x = log ? 8 * std::log10(p.x) - 4 : 0.8 * p.x - 4, y = 0.8 * p.y - 4;
            insist(std::abs(is.x - x) + std::abs(is.y - y) < 2e-3, "a point is where it must be");
          });
}

// A film whose object `s` has so many points in each frame.
void measure_formula(const char* name, const std::string& text, Kind kind, std::size_t least) {
  measure(name, "rate 24\nrange 1f 49f\n" + text, [&](const Frame& frame, int) {
    const auto at =
        std::find_if(frame.items.begin(), frame.items.end(), [&](const Item& i) { return i.shape->kind == kind; });
    insist(at != frame.items.end() && at->shape->points->size() >= least, "all of it is there");
  });
}

}  // namespace

int main() {
  const std::string plain = "x=(0 10) y=(0 10)", first = data(0);
  const std::string zoom = "at 1f ax.x (0 10) linear\nat 49f ax.x (2 5)\n";
  measure_scatter({"rest", plain, ""}, first);
  measure_scatter({"zoom", plain, zoom}, first);
  measure_scatter({"log", "x=(1 10) y=(0 10) x-scale=log", "at 1f ax.y (0 10) linear\nat 49f ax.y (2 5)\n"}, first);
  measure_scatter({"data", plain, "at 1f s.points " + first + " linear\nat 49f s.points " + data(1) + "\n" + zoom},
                  first);
  const std::string axes = "create ax axes x=(-6 6) y=(-3 3) size=(12 6) bare=on\n";
  measure_formula("surface", "create ax axes size=(6 4 6) bare=on\ncreate s surface on=ax of=\"sin(x - t) * cos(y)\"\n",
                  Kind::surface, 65 * 65);
  measure_formula("streamlines", axes + "create s streamlines on=ax of=\"vec(y, -sin(x - t))\" density=20\n",
                  Kind::streamlines, 500);
  measure_formula("curve", axes + "create s plot on=ax of=\"sin(x^2 - t)\"\n", Kind::plot, 200);
  measure_formula(
      "chart",
      "create b columns of=(" +
          [] {
            std::string all;
            for (int i = 0; i < 40; ++i) all += fmt::format("{} ", 1 + i * 7 % 11);
            return all;
          }() +
          ")\nat 1f b/1.value 1 linear\nat 49f b/1.value 20\n",
      Kind::bar, 0);
}

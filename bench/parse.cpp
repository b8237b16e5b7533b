// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How fast a script of a million events is read, and how long until its first frame. Values are checked.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "betwixt/language.h"
#include "betwixt/program.h"

using namespace betwixt;

namespace {

constexpr int objects = 1000, events = 1000, repeats = 7;

// What the k-th object's position is at frame f: with few digits, as authors write.
Vec3 position(int k, int f) {
  const int wave = (k * 37 + f * 101) % 2001 - 1000;
  return {k * 0.25, wave * 0.01, (f % 50) * 0.5 - 12};
}

std::string script() {
  std::string text = "rate 24\n";
  auto out = std::back_inserter(text);
  for (int k = 0; k < objects; ++k) {
    fmt::format_to(out, "create ball{} sphere radius=0.5\nball{}.position\n", k, k);
    for (int f = 1; f <= events; ++f) {
      const Vec3 p = position(k, f);
      fmt::format_to(out, "  {}f ({} {:.2f} {}){}\n", f, p.x, p.y, p.z, f % 4 == 0 ? " linear" : "");
    }
  }
  return text;
}

void insist(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "wrong: %s\n", what);
  std::exit(1);
}

void check(const Loaded& loaded, const Program& program) {
  insist(!has_errors(loaded.diagnostics), "the script has errors");
  for (int k = 0; k < objects; k += 7)
    for (int f = 1; f <= events; f += 31) {
      const auto targets = find_targets(fmt::format("ball{}.position", k), loaded.document);
      insist(targets && targets->size() == 1, "a target is missing");
      const Vec3 is = std::get<Vec3>(program.read(targets->front(), loaded.document.rate().frame(f)));
      insist(length(is - position(k, f)) < 1e-9, "a value");
    }
}

template <class F>
double seconds(F&& work) {
  const auto begun = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

struct Spread {
  double least, median;
};
Spread spread(std::vector<double> all) {
  std::sort(all.begin(), all.end());
  return {all.front(), all[all.size() / 2]};
}

}  // namespace

int main() {
  const std::string text = script();
  const double megabytes = static_cast<double>(text.size()) / 1e6;
  const auto path = std::filesystem::temp_directory_path() / fmt::format("bench-{}.bx", std::random_device{}());
  std::ofstream(path, std::ios::binary) << text;

  std::vector<double> parsing, ready;
  for (int i = 0; i < repeats; ++i) {
    parsing.push_back(
        seconds([&] { insist(load_text(text, "bench.bx").document.names().size() == objects, "objects"); }));
    ready.push_back(seconds([&] {
      const Loaded loaded = load_file(path.string());
      const Program program = Program::compile(loaded.document);
      insist(program.frame(loaded.document.range().first).items.size() == objects, "items of the first frame");
    }));
  }
  const Loaded loaded = load_file(path.string());
  check(loaded, Program::compile(loaded.document));
  std::filesystem::remove(path);

  const Spread p = spread(parsing), r = spread(ready);
  fmt::print("{} events, {:.1f} MB, {} runs, values checked\n", objects * events, megabytes, repeats);
  fmt::print("load_text            best {:.3f} s ({:.0f} MB/s)   median {:.3f} s ({:.0f} MB/s)\n", p.least,
             megabytes / p.least, p.median, megabytes / p.median);
  fmt::print("file to first frame  best {:.3f} s              median {:.3f} s\n", r.least, r.median);
}

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how fast a script of a million events is read, and the time to its first frame. Checks the values. Compares
// with plain code that reads only these lines: it knows where the numbers are, and reports no errors.
//   bench_parse [ROUNDS]
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "scenes.h"
#include "timing.h"

using namespace betwixt;

namespace {

constexpr int object_count = 1000, events = 1000;

void check(const Loaded& loaded, const Program& program) {
  insist(!has_errors(loaded.diagnostics), "the script has errors");
  for (int k = 0; k < object_count; k += 7)
    for (int f = 1; f <= events; f += 31) {
      const auto targets = find_targets(fmt::format("ball{}.position", k), loaded.document);
      insist(targets && targets->size() == 1, "a target is missing");
      const Vec3 is = std::get<Vec3>(program.read(targets->front(), loaded.document.rate().frame(f)));
      insist(length(is - scenes::million_key(k, f)) < 1e-9, "a value");
    }
}

struct Key {
  double frame;
  Vec3 value;
};
std::vector<std::vector<Key>> plainly(const std::string& text) {
  std::vector<std::vector<Key>> tracks;
  const char *at = text.data(), *end = at + text.size();
  const auto number = [&] {
    double d = 0;
    at = std::from_chars(at, end, d).ptr;
    return d;
  };
  while (at < end) {
    if (*at == 'b') tracks.emplace_back();  // ball7.position
    if (*at == ' ') {                       //   12f (1 2 3)
      at += 2;
      Key key;
      key.frame = number(), at += 3;
      key.value.x = number(), ++at;
      key.value.y = number(), ++at;
      key.value.z = number();
      tracks.back().push_back(key);
    }
    while (at < end && *at++ != '\n') {
    }
  }
  return tracks;
}

}  // namespace

int main(int count, char** words) {
  const std::string text = scenes::million("position");
  const auto path = std::filesystem::temp_directory_path() / fmt::format("bench-{}.bx", std::random_device{}());
  std::ofstream(path, std::ios::binary) << text;
  const auto rate = [&](double ms) { return static_cast<double>(text.size()) / 1e3 / ms; };
  report("bytes", static_cast<double>(text.size()));
  for (int rounds = count > 1 ? std::atoi(words[1]) : 5; rounds > 0; --rounds) {
    report("betwixt", rate(milliseconds([&] {
             insist(load_text(text, "bench.bx").document.names().size() == object_count, "objects");
           })));
    report("plain", rate(milliseconds([&] {
             const auto tracks = plainly(text);
             insist(tracks.size() == object_count && tracks[7].size() == events && tracks[7][30].frame == 31 &&
                        length(tracks[7][30].value - scenes::million_key(7, 31)) < 1e-9,
                    "a value of the plain code");
           })));
    report("ready", milliseconds([&] {
             const Loaded loaded = load_file(path.string());
             const Program program = Program::compile(loaded.document);
             insist(program.frame(loaded.document.range().first).items.size() == object_count,
                    "items of the first frame");
           }));
  }
  const Loaded loaded = load_file(path.string());
  check(loaded, Program::compile(loaded.document));
  std::filesystem::remove(path);
}

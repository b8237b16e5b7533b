// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a frame costs: objects that move by keys, objects that rest, a tree whose root moves, one event edited among a
// million. Values are compared with those of a program that was never anywhere else.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/language.h"
#include "betwixt/session.h"
#include "timing.h"

using namespace betwixt;

namespace {

void insist(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "wrong: %s\n", what);
  std::exit(1);
}

struct Film {
  explicit Film(const std::string& text)
      : document(load_text(text, "bench.bx").document), program(Program::compile(document)) {}
  Document document;
  Program program;
};

// Position, rotation and scale of each of `objects`, 60 keys each over 600 frames.
std::string keyed(int objects, bool shared) {
  std::mt19937 random(7);
  const auto any = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  std::string text = "rate 60\nrange 1f 600f\n";
  auto out = std::back_inserter(text);
  for (int k = 0; k < objects; ++k) {
    fmt::format_to(out, "create b{} box\n", k);
    for (const char* function : {"position", "rotation", "scale"}) {
      fmt::format_to(out, "b{}.{}\n", k, function);
      for (int i = 0; i < 60; ++i) {
        const double frame = 1 + 10 * i + (shared || i == 0 || i == 59 ? 0 : any(80) / 10.0 - 4);
        if (function[0] == 'r')
          fmt::format_to(out, "  {}f ({}deg {}deg {}deg)\n", frame, any(360), any(360), any(360));
        else
          fmt::format_to(out, "  {}f ({} {} {})\n", frame, any(900) / 100.0, any(900) / 100.0, 1 + any(900) / 100.0);
      }
    }
  }
  return text;
}

std::string boxes(int count, int moving) {
  std::string text = fmt::format("rate 60\nrange 1f 600f\ncreate b{{1..{}}} box\n", count);
  auto out = std::back_inserter(text);
  for (int k = 1; k <= moving; ++k)
    fmt::format_to(out, "b{}.position\n  1f ({} 0 0)\n  300f ({} 5 0)\n  600f (0 0 1)\n", k * (count / moving), k, k);
  return text;
}

// A tree of ten children each, the root of which moves.
std::string tree(int count) {
  std::string text = "rate 60\nrange 1f 600f\ncreate n0 box\n";
  auto out = std::back_inserter(text);
  for (int k = 1; k < count; ++k)
    fmt::format_to(out, "create n{} box position=(1 0.5 0)\ncouple n{} to n{}\n", k, k, (k - 1) / 10);
  return text + "n0.position\n  1f (0 0 0)\n  300f (1 5 0)\n  600f (0 0 1)\n";
}

// The worlds at some times are those of an evaluation that was never anywhere else.
void check(const Film& film, Evaluation& e, const std::vector<Time>& times) {
  for (std::size_t k = 0; k < times.size(); k += times.size() / 3) {
    e.to(times[k]);
    Evaluation alone(film.program);
    alone.to(times[k]);
    insist(e.worlds().size() == alone.worlds().size() &&
               std::memcmp(e.worlds().data(), alone.worlds().data(), e.worlds().size_bytes()) == 0,
           "a world");
  }
}

void print(const char* what, std::vector<double> all, const char* unit) {
  std::sort(all.begin(), all.end());
  fmt::print("{:44} {:12.1f} {:12.1f}  {}\n", what, all.front(), all[all.size() / 2], unit);
}

void row(const char* what, const Film& film, const std::vector<Time>& times, double per, const char* unit) {
  Evaluation e(film.program);
  check(film, e, times);
  std::vector<double> all;
  for (int round = 0; round < 9; ++round) {
    e.to(times[0]);
    all.push_back(1e6 * milliseconds([&] {
                    for (std::size_t k = 1; k < times.size(); ++k) e.to(times[k]);
                  }) /
                  (per * static_cast<double>(times.size() - 1)));
  }
  print(what, all, unit);
}

// One event changed in a document of a million: the command (kept in a file before it is answered), the program, the
// frame.
void edits() {
  std::string text = "rate 24\nrange 1f 1000f\n";
  auto out = std::back_inserter(text);
  for (int k = 0; k < 1000; ++k) {
    fmt::format_to(out, "create ball{} sphere radius=0.5\nball{}.position\n", k, k);
    for (int f = 1; f <= 1000; ++f)
      fmt::format_to(out, "  {}f ({} {:.2f} {})\n", f, k * 0.25, (k * 37 + f * 101) % 2001 * 0.01, (f % 50) * 0.5);
  }
  const auto path = std::filesystem::temp_directory_path() / fmt::format("bench-{}.bx", std::random_device{}());
  std::ofstream(path, std::ios::binary) << text;
  Session session;
  session.open(path.string());
  Program program = Program::compile(session.document());
  Evaluation e(program);
  const Time t = session.document().rate().frame(500);
  e.to(t);
  std::vector<double> command, compiling, frame, together;
  for (int k = 0; k < 15; ++k) {
    const std::string line = fmt::format("at 500f ball{}.position (1 {} 3)", 60 * k, k);
    command.push_back(milliseconds([&] { insist(session.enter(line).done, "a command"); }));
    compiling.push_back(milliseconds([&] { program = Program::compile(session.document(), program); }));
    frame.push_back(milliseconds([&] {
      e.use(program);
      e.to(t);
    }));
    together.push_back(command.back() + compiling.back() + frame.back());
    insist(e.changed().size() == 1 && translation_of(e.worlds()[e.changed()[0]]) == Vec3{1, 1.0 * k, 3},
           "what was edited");
  }
  session.enter("quit");
  session = Session();
  for (const auto& entry : std::filesystem::directory_iterator(path.parent_path()))
    if (entry.path().filename().string().find(path.stem().string()) != std::string::npos)
      std::filesystem::remove(entry.path());
  print("one event of a million changed: command", command, "ms");
  print("  program", compiling, "ms");
  print("  frame", frame, "ms");
  print("  together", together, "ms");
}

std::vector<Time> forward(int count) {
  std::vector<Time> out;
  for (int k = 0; k < count; ++k) out.push_back(Rate{60, 1}.frame(2 + k));
  return out;
}
std::vector<Time> anywhere(int count) {
  std::mt19937_64 random(3);
  std::vector<Time> out;
  for (int k = 0; k < count; ++k) out.push_back(Rate{60, 1}.frame(1 + static_cast<double>(random() % 5990) / 10));
  return out;
}

}  // namespace

int main() {
  fmt::print("{:44} {:>12} {:>12}\n", "", "minimum", "median");
  {
    const Film hand(keyed(1000, false)), shared(keyed(1000, true));
    row("position, rotation, scale: forward", hand, forward(500), 1000, "ns an object");
    row("position, rotation, scale: any time", hand, anywhere(500), 1000, "ns an object");
    row("the same, keys at shared times: forward", shared, forward(500), 1000, "ns an object");
  }
  row("100,000 boxes rest", Film(boxes(100'000, 1)), forward(50), 1e6, "ms a frame, one of them moves");
  row("100,000 boxes, 1,000 move", Film(boxes(100'000, 1000)), forward(50), 1e6, "ms a frame");
  row("a tree of 100,000, its root moves", Film(tree(100'000)), forward(20), 1e5, "ns a node");
  edits();
}

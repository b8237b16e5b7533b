// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the time of a frame, in turns with plain code for the same work:
//   bench_frames ROW [ROUNDS]   keys, random, shared, rest, move, tree, edit
// Compares values with those of the plain code, and bit by bit with those of a new evaluation.
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/language.h"
#include "edits.h"
#include "plain.h"
#include "scenes.h"
#include "timing.h"

using namespace betwixt;

namespace {

Time time_of(double frame) { return Rate{60, 1}.frame(frame); }

struct Film {
  explicit Film(const std::string& text)
      : document(load_text(text, "bench.bx").document), program(Program::compile(document)), now(program) {}
  Document document;
  Program program;
  Evaluation now;
};

bool near(const Mat4& a, const Mat4& b) {
  for (std::size_t i = 0; i < 16; ++i)
    if (!(std::abs(a.m[i] - b.m[i]) < 1e-9 * (1 + std::abs(b.m[i])))) return false;
  return true;
}

// The checks that run at some frames.
void check(const Film& film, const std::vector<Mat4>& plain) {
  Evaluation alone(film.program);
  alone.to(film.now.time());
  const auto worlds = film.now.worlds();
  insist(worlds.size() == plain.size(), "as many worlds");
  insist(std::memcmp(worlds.data(), alone.worlds().data(), worlds.size_bytes()) == 0,
         "a world that is asked for alone");
  for (std::size_t i = 0; i < plain.size(); ++i) insist(near(worlds[i], plain[i]), "a world of the plain code");
}

// Runs through the frames with Betwixt and with plain code. Prints the time of one frame in units of `unit`
// nanoseconds.
void play(int rounds, Film& film, const std::vector<double>& frames, double unit, const std::function<void()>& begin,
          const std::function<void(double)>& plain, const std::vector<Mat4>& worlds) {
  std::vector<Time> times;
  for (const double f : frames) times.push_back(time_of(f));
  const double steps = static_cast<double>(frames.size() - 1);
  for (int round = 0; round < rounds; ++round) {
    film.now.to(times[0]);
    const double ours = milliseconds([&] {
      for (std::size_t k = 1; k < times.size(); ++k) film.now.to(times[k]);
    });
    begin();
    plain(frames[0]);
    const double theirs = milliseconds([&] {
      for (std::size_t k = 1; k < frames.size(); ++k) plain(frames[k]);
    });
    check(film, worlds);
    report("betwixt", 1e6 * ours / steps / unit);
    report("plain", 1e6 * theirs / steps / unit);
  }
}

// ---- Position, rotation and scale of 1,000 objects by keys

void keyed(int rounds, scenes::Times times, bool forward) {
  constexpr int count = 1000;
  Film film(scenes::keyed(count, times, scenes::Blend::smooth));
  std::vector<plain::Object> objects(count);
  for (int k = 0; k < count; ++k)
    for (int f = 0; f < scenes::functions; ++f) {
      plain::Track& track = objects[static_cast<std::size_t>(k)].tracks[static_cast<std::size_t>(f)];
      for (int i = 0; i < scenes::keys; ++i)
        track.add(scenes::frame_of(times, k, f, i), (f == 1 ? pi / 180 : 1.0) * scenes::value_of(k, f, i));
      track.compile();
    }
  std::vector<Mat4> worlds(count);
  const auto begin = [&] {
    for (auto& o : objects)
      for (auto& t : o.tracks) t.rewind();
  };
  const auto go = [&](double frame) {
    for (std::size_t k = 0; k < count; ++k) worlds[k] = forward ? objects[k].forward(frame) : objects[k].seek(frame);
  };
  play(rounds, film, forward ? scenes::forward_frames() : scenes::random_frames(), count, begin, go, worlds);
}

// ---- Boxes, some of which move

void boxes(int rounds, int count, int moving) {
  constexpr double milliseconds = 1e6;
  Film film(scenes::boxes(count, moving));
  plain::Nodes nodes;
  nodes.parent.assign(static_cast<std::size_t>(count), -1);
  nodes.own.resize(nodes.parent.size()), nodes.world.resize(nodes.parent.size()),
      nodes.moved.resize(nodes.parent.size());
  std::vector<plain::Track> tracks(static_cast<std::size_t>(moving));
  for (int k = 1; k <= moving; ++k)
    for (int i = 0; i < 3; ++i)
      tracks[static_cast<std::size_t>(k - 1)].add(i == 0 ? 1 : 300 * i, scenes::box_key(k, i));
  for (auto& t : tracks) t.compile();
  const auto begin = [&] {
    for (auto& t : tracks) t.rewind();
  };
  const auto go = [&](double frame) {
    for (std::size_t k = 0; k < tracks.size(); ++k) {
      const std::size_t node = (k + 1) * static_cast<std::size_t>(count / moving) - 1;
      nodes.own[node] = translation(tracks[k].forward(frame));
      nodes.moved[node] = 1;
    }
    nodes.update();
  };
  auto frames = scenes::forward_frames();
  frames.resize(50);
  play(rounds, film, frames, milliseconds, begin, go, nodes.world);
}

// ---- A tree whose root moves

void tree(int rounds) {
  constexpr std::size_t count = 100'000;
  Film film(scenes::tree(count));
  plain::Nodes nodes;
  nodes.parent.resize(count), nodes.world.resize(count), nodes.moved.resize(count);
  for (std::size_t k = 0; k < count; ++k) nodes.parent[k] = k == 0 ? -1 : static_cast<int>((k - 1) / 10);
  nodes.own.assign(count, translation({1, 0.5, 0}));
  plain::Track root;
  for (int i = 0; i < 3; ++i) root.add(i == 0 ? 1 : 300 * i, scenes::box_key(1, i));
  root.compile();
  const auto go = [&](double frame) {
    nodes.own[0] = translation(root.forward(frame));
    nodes.moved[0] = 1;
    nodes.update();
  };
  auto frames = scenes::forward_frames();
  frames.resize(20);
  play(
      rounds, film, frames, count, [&] { root.rewind(); }, go, nodes.world);
}

}  // namespace

int main(int count, char** words) {
  using scenes::Times;
  const std::map<std::string, std::function<void(int)>> rows{
      {"keys", [](int n) { keyed(n, Times::by_hand, true); }},
      {"random", [](int n) { keyed(n, Times::by_hand, false); }},
      {"shared", [](int n) { keyed(n, Times::shared, true); }},
      {"rest", [](int n) { boxes(n, 100'000, 0); }},
      {"move", [](int n) { boxes(n, 100'000, 1000); }},
      {"move-fewer", [](int n) { boxes(n, 10'000, 1000); }},
      {"tree", tree},
      {"edit", edits},
  };
  const auto row = rows.find(count > 1 ? words[1] : "");
  if (row == rows.end()) {
    std::fputs("usage: bench_frames ROW [ROUNDS], a ROW being one of:", stderr);
    for (const auto& r : rows) std::fprintf(stderr, " %s", r.first.c_str());
    std::fputs("\n", stderr);
    return 2;
  }
  row->second(count > 2 ? std::atoi(words[2]) : 5);
}

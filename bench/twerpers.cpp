// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures a frame of 1,000 objects whose position, rotation and scale have 60 keys each in 600 frames, for each
// twerper, with evenly and unevenly spaced keys, forward and at random times:
//   bench_twerpers [ROUNDS] [ROW…]
// Prints nanoseconds an object, in turns with plain code for the same work. Values are compared with those of the
// plain code, which finds the factor of a Bezier curve by bisection, and bit by bit with those of a new evaluation.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "betwixt/evaluation.h"
#include "betwixt/language.h"
#include "plain.h"
#include "scenes.h"
#include "timing.h"

using namespace betwixt;

namespace {

constexpr int objects = 1000;
using Factor = double (*)(double s);

double bezier(double u, double x1, double y1, double x2, double y2) {
  const auto at = [](double p, double q, double s) {
    return 3 * (1 - s) * (1 - s) * s * p + 3 * (1 - s) * s * s * q + s * s * s;
  };
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (at(x1, x2, middle) < u ? low : high) = middle;
  }
  return at(y1, y2, low);
}

struct Blend {
  const char* name;
  const char* written;
  Factor factor;  // nullptr: smooth
};
constexpr Blend blends[] = {
    {"linear", "linear", [](double s) { return s; }},
    {"smooth", "smooth", nullptr},
    {"hold", "hold", [](double) { return 0.0; }},
    {"bezier", "bezier(0.3 0.1 0.2 0.9)", [](double s) { return bezier(s, 0.3, 0.1, 0.2, 0.9); }},
    {"ease-in-out", "ease-in-out", [](double s) { return bezier(s, 0.42, 0, 0.58, 1); }},
    {"cubic-in-out", "cubic-in-out",
     [](double s) { return s < 0.5 ? 4 * s * s * s : 1 - 4 * (1 - s) * (1 - s) * (1 - s); }},
    {"sine-in-out", "sine-in-out", [](double s) { return (1 - std::cos(s * pi)) / 2; }},
    {"expo-out", "expo-out", [](double s) { return s >= 1 ? 1 : 1 - std::exp2(-10 * s); }},
};
constexpr int mixture = std::size(blends);

const Blend& blend_of(int which, int object, int function, int key) {
  if (which < mixture) return blends[which];
  const auto n = scenes::hash(static_cast<std::uint32_t>((object * 3 + function) * scenes::keys + key + 7'000'000));
  const Blend* const other[] = {&blends[0], &blends[2], &blends[3], &blends[4]};
  return *other[n % 4];
}

// Uneven keys: the lengths of the segments differ by up to 16 times.
std::vector<double> frames_of(bool even, int object, int function) {
  std::vector<double> out{1};
  double sum = 0;
  for (int k = 1; k < scenes::keys; ++k) {
    const auto n = scenes::hash(static_cast<std::uint32_t>((object * 3 + function) * scenes::keys + k));
    sum += even ? 1 : std::exp2(n % 1000 / 250.0);
    out.push_back(sum);
  }
  for (std::size_t k = 1; k < out.size(); ++k) out[k] = 1 + std::round(out[k] / sum * 599 * 1000) / 1000;
  return out;
}

struct Segment {
  double from, per_frame;
  std::array<std::array<double, 4>, 3> cubic;
  Factor factor;
};

// A track of the plain code.
struct Track {
  std::vector<double> frames;
  std::vector<Segment> segments;
  std::size_t now = 0;
  Vec3 at(const Segment& s, double frame) const {
    double u = (frame - s.from) * s.per_frame;
    if (s.factor) u = s.factor(u);
    const auto number = [&](std::size_t i) {
      const auto& c = s.cubic[i];
      return c[0] + u * (c[1] + u * (c[2] + u * c[3]));
    };
    return {number(0), number(1), number(2)};
  }
  Vec3 forward(double frame) {
    while (now + 1 < segments.size() && frames[now + 1] <= frame) ++now;
    return at(segments[now], frame);
  }
  Vec3 seek(double frame) const {
    const auto after = std::upper_bound(frames.begin() + 1, frames.end() - 1, frame);
    return at(segments[static_cast<std::size_t>(after - frames.begin()) - 1], frame);
  }
};

Track track_of(int which, bool even, int object, int function) {
  Track track;
  track.frames = frames_of(even, object, function);
  const double unit = function == 1 ? pi / 180 : 1;
  const auto value = [&](std::size_t k) {
    const Vec3 v = unit * scenes::value_of(object, function, static_cast<int>(k));
    return std::array{v.x, v.y, v.z};
  };
  for (std::size_t k = 0; k + 1 < track.frames.size(); ++k) {
    const double h = track.frames[k + 1] - track.frames[k];
    const bool first = k == 0, last = k + 2 == track.frames.size();
    const Blend& blend = blend_of(which, object, function, static_cast<int>(k));
    Segment s{track.frames[k], 1 / h, {}, blend.factor};
    const double h0 = first ? h : track.frames[k] - track.frames[k - 1],
                 h2 = last ? h : track.frames[k + 2] - track.frames[k + 1];
    for (std::size_t i = 0; i < 3; ++i) {
      const double b = value(k)[i], e = value(k + 1)[i];
      if (blend.factor) {
        s.cubic[i] = {b, e - b, 0, 0};
        continue;
      }
      const double a = first ? 2 * b - e : value(k - 1)[i], d = last ? 2 * e - b : value(k + 2)[i];
      const double m1 = ((b - a) / h0 * h * h + (e - b) * h0) / (h0 + h),
                   m2 = ((e - b) * h2 + (d - e) / h2 * h * h) / (h + h2);
      s.cubic[i] = {b, m1, 3 * (e - b) - 2 * m1 - m2, m1 + m2 - 2 * (e - b)};
    }
    track.segments.push_back(s);
  }
  return track;
}

std::string script_of(int which, bool even) {
  std::string text = fmt::format("rate 60\nrange 1f 600f\ncreate b{{0..{}}} box\n", objects - 1);
  auto out = std::back_inserter(text);
  for (int k = 0; k < objects; ++k)
    for (int f = 0; f < scenes::functions; ++f) {
      const char* const names[] = {"position", "rotation", "scale"};
      const char* const unit = f == 1 ? "deg" : "";
      fmt::format_to(out, "b{}.{}\n", k, names[f]);
      const auto frames = frames_of(even, k, f);
      for (int i = 0; i < scenes::keys; ++i) {
        const Vec3 v = scenes::value_of(k, f, i);
        fmt::format_to(out, "  {:.3f}f ({}{} {}{} {}{}) {}\n", frames[static_cast<std::size_t>(i)], v.x, unit, v.y,
                       unit, v.z, unit, blend_of(which, k, f, i).written);
      }
    }
  return text;
}

bool near(const Mat4& a, const Mat4& b) {
  for (std::size_t i = 0; i < 16; ++i)
    if (!(std::abs(a.m[i] - b.m[i]) < 1e-7 * (1 + std::abs(b.m[i])))) return false;
  return true;
}

void row(int which, bool even, int rounds) {
  const std::string name =
      fmt::format("{}-{}", which < mixture ? blends[which].name : "mixture", even ? "even" : "uneven");
  const Loaded loaded = load_text(script_of(which, even), "bench.bx");
  insist(!has_errors(loaded.diagnostics), "the script");
  const Program program = Program::compile(loaded.document);
  std::vector<std::array<Track, 3>> plain(objects);
  for (int k = 0; k < objects; ++k)
    for (int f = 0; f < 3; ++f)
      plain[static_cast<std::size_t>(k)][static_cast<std::size_t>(f)] = track_of(which, even, k, f);
  for (const bool forward : {true, false}) {
    std::vector<double> ours, theirs;
    const auto frames = forward ? scenes::forward_frames() : scenes::random_frames();
    std::vector<Time> times;
    for (const double f : frames) times.push_back(Rate{60, 1}.frame(f));
    std::vector<Mat4> worlds(objects);
    const auto seek = [&](double f) {
      for (std::size_t k = 0; k < worlds.size(); ++k) {
        auto& t = plain[k];
        worlds[k] = forward ? plain::placed(t[0].forward(f), t[1].forward(f), t[2].forward(f))
                            : plain::placed(t[0].seek(f), t[1].seek(f), t[2].seek(f));
      }
    };
    Evaluation now(program);
    for (int round = 0; round < rounds; ++round) {
      now.to(times[0]);
      ours.push_back(milliseconds([&] {
        for (std::size_t k = 1; k < times.size(); ++k) now.to(times[k]);
      }));
      for (auto& t : plain)
        for (Track& one : t) one.now = 0;
      seek(frames[0]);
      theirs.push_back(milliseconds([&] {
        for (std::size_t k = 1; k < frames.size(); ++k) seek(frames[k]);
      }));
      Evaluation alone(program);
      alone.to(now.time());
      insist(std::memcmp(now.worlds().data(), alone.worlds().data(), alone.worlds().size_bytes()) == 0,
             "the bits of a world that is asked for alone");
      for (std::size_t k = 0; k < worlds.size(); ++k)
        insist(near(now.worlds()[k], worlds[k]), "a world of the plain code");
    }
    const double all = static_cast<double>(frames.size() - 1) * objects;
    const auto say = [&](std::vector<double>& of) {
      std::sort(of.begin(), of.end());
      return std::pair(1e6 * of.front() / all, 1e6 * of[of.size() / 2] / all);
    };
    const auto [least, median] = say(ours);
    const auto [plain_least, plain_median] = say(theirs);
    fmt::print("{:20}{:9}{:8.0f} {:6.0f} {:8.0f} {:6.0f}\n", name, forward ? "forward" : "random", least, median,
               plain_least, plain_median);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** words) {
  const int rounds = count > 1 ? std::atoi(words[1]) : 5;
  const std::vector<std::string> wanted(words + std::min(count, 2), words + count);
  fmt::print("{:29}{:>15} {:>15}\n{:29}{:>8} {:>6} {:>8} {:>6}\n", "nanoseconds an object", "betwixt", "plain code", "",
             "least", "median", "least", "median");
  for (int which = 0; which <= mixture; ++which)
    for (const bool even : {true, false}) {
      const std::string name = which < mixture ? blends[which].name : "mixture";
      if (wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end()) row(which, even, rounds);
    }
}

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scenes.h"

#include <fmt/format.h>

#include <iterator>

using betwixt::Vec3;

namespace scenes {
namespace {

constexpr int frames = 500;

std::uint32_t any(int object, int function, int key, int which) {
  return hash(static_cast<std::uint32_t>(((object * functions + function) * keys + key) * 4 + which));
}

}  // namespace

double frame_of(Times times, int object, int function, int key) {
  const double even = 1 + 10 * key;
  if (times == Times::shared || key == 0 || key == keys - 1) return even;
  return even + any(object, function, key, 3) % 80 / 10.0 - 4;
}

Vec3 value_of(int object, int function, int key) {
  const auto number = [&](int which, std::uint32_t below) { return any(object, function, key, which) % below; };
  if (function == 1) return {1.0 * number(0, 360), 1.0 * number(1, 360), 1.0 * number(2, 360)};
  return {number(0, 900) / 100.0, number(1, 900) / 100.0, 1 + number(2, 900) / 100.0};
}

std::vector<double> forward_frames() {
  std::vector<double> out;
  for (int k = 0; k < frames; ++k) out.push_back(2 + k);
  return out;
}

std::vector<double> random_frames() {
  std::vector<double> out;
  for (std::uint32_t k = 0; k < frames; ++k) out.push_back(1 + hash(1'000'000 + k) % 5990 / 10.0);
  return out;
}

std::string keyed(int objects, Times times, Blend blend) {
  std::string text = fmt::format("rate 60\nrange 1f 600f\ncreate b{{0..{}}} box\n", objects - 1);
  auto out = std::back_inserter(text);
  const char* const after = blend == Blend::linear ? " linear" : "";
  for (int k = 0; k < objects; ++k)
    for (int f = 0; f < functions; ++f) {
      const char* const names[] = {"position", "rotation", "scale"};
      const char* const unit = f == 1 ? "deg" : "";
      fmt::format_to(out, "b{}.{}\n", k, names[f]);
      for (int i = 0; i < keys; ++i) {
        const Vec3 v = value_of(k, f, i);
        fmt::format_to(out, "  {}f ({}{} {}{} {}{}){}\n", frame_of(times, k, f, i), v.x, unit, v.y, unit, v.z, unit,
                       after);
      }
    }
  return text;
}

Vec3 box_key(int which, int key) {
  const double x = which;
  return key == 0 ? Vec3{x, 0, 0} : key == 1 ? Vec3{x, 5, 0} : Vec3{0, 0, 1};
}

std::string boxes(int count, int moving) {
  std::string text = fmt::format("rate 60\nrange 1f 600f\ncreate b{{1..{}}} box\n", count);
  auto out = std::back_inserter(text);
  for (int k = 1; k <= moving; ++k)
    fmt::format_to(out, "b{}.position\n  1f ({} 0 0)\n  300f ({} 5 0)\n  600f (0 0 1)\n", k * (count / moving), k, k);
  return text;
}

std::string tree(int count) {
  std::string text = "rate 60\nrange 1f 600f\ncreate n0 box\n";
  auto out = std::back_inserter(text);
  for (int k = 1; k < count; ++k)
    fmt::format_to(out, "create n{} box position=(1 0.5 0)\ncouple n{} to n{}\n", k, k, (k - 1) / 10);
  return text + "n0.position\n  1f (1 0 0)\n  300f (1 5 0)\n  600f (0 0 1)\n";
}

Vec3 million_key(int object, int frame) {
  return {object * 0.25, (object * 37 + frame * 101) % 2001 * 0.01, frame % 50 * 0.5};
}

std::string million(const std::string& function) {
  std::string text = "rate 24\nrange 1f 1000f\ncreate ball{0..999} sphere radius=0.5\n";
  auto out = std::back_inserter(text);
  for (int k = 0; k < 1000; ++k) {
    fmt::format_to(out, "ball{}.{}\n", k, function);
    for (int f = 1; f <= 1000; ++f) {
      const Vec3 v = million_key(k, f);
      if (function == "position")
        fmt::format_to(out, "  {}f ({} {:.2f} {})\n", f, v.x, v.y, v.z);
      else
        fmt::format_to(out, "  {}f {:.2f}\n", f, v.y);
    }
  }
  return text;
}

}  // namespace scenes

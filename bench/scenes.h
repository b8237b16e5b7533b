// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The scenes of the benchmarks: numbers that look random but depend only on their indices, and scripts with them. Peers
// in other languages compute the same numbers (peers/scene.mjs, peers/scene.py).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "betwixt/math.h"

namespace scenes {

// The finaliser "lowbias32" of Wellons' search for integer hashes.
constexpr std::uint32_t hash(std::uint32_t n) {
  n ^= n >> 16, n *= 0x7feb352dU;
  n ^= n >> 15, n *= 0x846ca68bU;
  return n ^ n >> 16;
}

// Position, rotation (degrees) and scale of objects: 60 keys each over 600 frames of 1/60 s.
inline constexpr int functions = 3, keys = 60;
enum class Times : std::uint8_t { by_hand, shared };
double frame_of(Times, int object, int function, int key);
betwixt::Vec3 value_of(int object, int function, int key);
std::vector<double> forward_frames(), random_frames();  // 500 each

enum class Blend : std::uint8_t { smooth, linear };
std::string keyed(int objects, Times, Blend);
// `count` boxes, of which `moving` move along x and back.
std::string boxes(int count, int moving);
betwixt::Vec3 box_key(int which, int key);  // at frames 1, 300, 600
// A tree in which each node has ten children, one metre beside and half a metre above it. The root moves like a box.
std::string tree(int count);
// 1,000 balls. One display function of each has 1,000 events.
std::string million(const std::string& function);
betwixt::Vec3 million_key(int object, int frame);

}  // namespace scenes

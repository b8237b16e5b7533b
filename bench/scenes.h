// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the benchmarks play: numbers that look random and follow from their place alone, so that peers in other
// languages make the same ones (peers/scene.mjs, peers/scene.py), and scripts of them.
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

// Of an object's position, rotation (degrees) and scale, 60 keys each over 600 frames of a sixtieth of a second.
inline constexpr int functions = 3, keys = 60;
enum class Times : std::uint8_t { by_hand, shared };
double frame_of(Times, int object, int function, int key);
betwixt::Vec3 value_of(int object, int function, int key);
std::vector<double> forward_frames(), random_frames();  // 500 each

enum class Blend : std::uint8_t { smooth, linear };
std::string keyed(int objects, Times, Blend);
// `moving` of `count` boxes move along x and back.
std::string boxes(int count, int moving);
betwixt::Vec3 box_key(int which, int key);  // at frames 1, 300, 600
// Ten children each, one metre beside and half a metre above what they are coupled to; the root moves as a box does.
std::string tree(int count);
// One function of 1,000 balls has 1,000 events.
std::string million(const std::string& function);
betwixt::Vec3 million_key(int object, int frame);

}  // namespace scenes

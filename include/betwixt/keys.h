// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How things move, as keys that any other program can play: pieces of time in which a number is held, goes straight or
// along a cubic, each within a tolerance of what the film says.
//
// A piece ends where the next one begins, in time; where something jumps, not in value. At a time that two pieces
// share, the later one counts. Values are as a player counts them: metres, quaternions (x y z w), factors, colours as
// linear light.
//
// Room: export
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "betwixt/program.h"

namespace betwixt {

enum class KeyStyle : std::uint8_t {
  cubic,   // as few pieces as the tolerance allows, of all shapes
  linear,  // none of them cubic, and none turns by more than 12 degrees: for players that know no tangents
  baked    // a straight piece from each frame to the next
};

struct KeyOptions {
  KeyStyle style = KeyStyle::cubic;
  double metres = 1e-4;   // how far off a place may be, and a scale as a factor
  double radians = 1e-4;  // … a turn, and all other numbers
  // Turns that go straight keep to the shortest arc at an even pace (slerp). Else none goes straight: for players that
  // blend quaternions number by number.
  bool arcs = true;
  // Times are those that a float can hold, in seconds since the beginning: for files that keep them so.
  bool in_floats = false;
  // Told after each object how much is done, 0 to 1; false: stop there.
  std::function<bool(double)> go_on;
};

struct KeyPiece {
  // leap: from one time that a float can hold to the next one, from one value to another; only where KeyOptions ask for
  // floats, elsewhere the next piece begins at once.
  enum Shape : std::uint8_t { held, straight, cubic, leap } shape = held;
  Time from, until;
  std::array<double, 4> begin{}, end{};         // the values at both ends; held: equal
  std::array<double, 4> leaving{}, arriving{};  // cubic: how fast it is there, per second (Hermite)
};

// One thing that varies. Turns: quaternions that a player makes of length 1 again after it has blended them.
struct Channel {
  std::size_t width = 3;  // numbers of a value, 4 at most
  bool turn = false;
  std::vector<KeyPiece> pieces;  // by time, without gaps; at least one
  bool constant() const;
  bool steps() const;                          // it is held, and leaps
  bool jumps_behind(std::size_t piece) const;  // into the next one
  std::size_t keys() const;                    // that a file needs for it; 1: it is constant
};
// What a player makes of it.
std::array<double, 4> value_at(const Channel&, Time);

// An object: its matrix is that of its parent times translation, rotation and scale, and, where it is sheared, times
// `inner`, a further rotation (a matrix is a turn, a stretch and another turn: singular values).
struct ObjectKeys {
  ObjectId id;
  ObjectId parent;  // what it hangs on all the time, where that makes fewer keys; none: its keys are in the world
  bool sheared = false;
  Channel translation, rotation, scale, inner;
};

// Of all objects that are somewhere, in the order of their creation; parents may come later.
std::vector<ObjectKeys> motion_keys(const Program&, Time from, Time until, const KeyOptions& = {});
// Of one display function (or component) that is made of numbers, four at most; colours as linear light, times
// `scale`. No pieces: it is not made of such.
Channel value_keys(const Program&, const Target&, Time from, Time until, const KeyOptions& = {});

}  // namespace betwixt

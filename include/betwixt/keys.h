// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion as keys that any other program can play. A channel is a sequence of pieces in time; in each piece the number
// is constant, linear or cubic, within a tolerance of the film.
//
// A piece ends at the time at which the next one begins. At a jump their values differ, and the later piece counts.
// Values are in the units that players use: metres, quaternions (x y z w), factors, colours as linear light.
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
  cubic,   // as few pieces of any shape as the tolerance allows
  linear,  // no cubic pieces, and none that turns by more than 12 degrees: for players without tangents
  baked    // one linear piece from each frame to the next
};

struct KeyOptions {
  KeyStyle style = KeyStyle::cubic;
  double metres = 1e-4;   // tolerance of positions, and of scales as a factor
  double radians = 1e-4;  // tolerance of rotations and of all other numbers
  // true: linear pieces of rotations follow the shortest arc at constant speed (slerp). false: rotations have no linear
  // pieces, for players that blend quaternions number by number.
  bool arcs = true;
  // Rounds times to seconds that a float can hold, counted from the beginning, for files that store floats.
  bool in_floats = false;
  // Called after each object with the share that is done, 0 to 1. Return false to stop there.
  std::function<bool(double)> go_on;
};

struct KeyPiece {
  // leap: a jump in value within the time from one float to the next. Only with KeyOptions::in_floats; otherwise the
  // next piece begins at once.
  enum Shape : std::uint8_t { held, straight, cubic, leap } shape = held;
  Time from, until;
  std::array<double, 4> begin{}, end{};         // the values at both ends; equal if held
  std::array<double, 4> leaving{}, arriving{};  // cubic: the derivatives at both ends, per second (Hermite)
};

// One quantity over time. If `turn` is true the values are quaternions; a player normalises them after blending.
struct Channel {
  std::size_t width = 3;  // numbers in a value, at most 4
  bool turn = false;
  std::vector<KeyPiece> pieces;  // in order of time, without gaps; at least one
  bool constant() const;
  bool steps() const;                          // whether all pieces are held or leaps
  bool jumps_behind(std::size_t piece) const;  // whether the value jumps between this piece and the next
  std::size_t keys() const;                    // the keys that a file needs for it; 1 if it is constant
};
// Returns the value that a player computes from the channel.
std::array<double, 4> value_at(const Channel&, Time);

// The motion of an object. Its matrix is that of its parent * translation * rotation * scale. If the object is sheared,
// a further rotation `inner` follows (any matrix is a rotation, a scale and another rotation: singular values).
struct ObjectKeys {
  ObjectId id;
  ObjectId parent;  // its parent all the time, if that makes fewer keys; without it, keys are in world space
  bool sheared = false;
  Channel translation, rotation, scale, inner;
};

// Returns the keys of all objects that have a position, in order of creation. A parent may come after its children.
std::vector<ObjectKeys> motion_keys(const Program&, Time from, Time until, const KeyOptions& = {});
// Returns the keys of one display function, or of one component. It must consist of at most four numbers; for any other
// the channel has no pieces. Colours are linear light.
Channel value_keys(const Program&, const Target&, Time from, Time until, const KeyOptions& = {});

}  // namespace betwixt

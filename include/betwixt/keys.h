// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion as keys that any other program can play. A channel is a sequence of pieces in time. In each piece the value is
// constant, linear or cubic, and within a tolerance of the film.
//
// A piece ends at the time at which the next one begins. At a jump the values of the two differ at this time, and the
// later piece has priority. Positions are in metres, rotations are quaternions (x y z w), scales are factors, and
// colours are linear light.
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
  double metres = 1e-4;   // tolerance of positions in metres, and of scales as a factor
  double radians = 1e-4;  // tolerance of rotations and of all other numbers
  // true: linear pieces of rotations follow the shortest arc at constant speed (slerp). false: rotations have no linear
  // pieces, for players that blend quaternions number by number.
  bool arcs = true;
  // Rounds times so that a float can hold their seconds since the beginning, for files that store floats.
  bool in_floats = false;
  // Called after each object with the share of the work that is done, 0 to 1. Return false to stop.
  std::function<bool(double)> go_on;
};

struct KeyPiece {
  // leap: a jump between two times that are neighbours as floats. Only with KeyOptions::in_floats; without it, no piece
  // separates the two sides of a jump.
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

// The motion of an object. Its matrix is: matrix of its parent * translation * rotation * scale. If the object is
// sheared, this is multiplied from the right by another rotation, `inner` (singular value decomposition).
struct ObjectKeys {
  ObjectId id;
  ObjectId parent;  // the parent, if it never changes and this makes fewer keys; empty: keys are in world space
  bool sheared = false;
  Channel translation, rotation, scale, inner;
};

// Returns the keys of all objects that have a position, in order of creation. A parent may come after its children.
std::vector<ObjectKeys> motion_keys(const Program&, Time from, Time until, const KeyOptions& = {});
// Returns the keys of one display function (animatable property), or of one component. Returns a channel without pieces
// if its values do not consist of one to four numbers. Colours are linear light.
Channel value_keys(const Program&, const Target&, Time from, Time until, const KeyOptions& = {});

}  // namespace betwixt

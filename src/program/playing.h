// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The hot loops of an evaluator: curves at a time, own matrices from numbers, world matrices from parents. Each gives
// the same bits as its plain form (CurveSet::evaluate, own_place, hang) on every machine.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "betwixt/math.h"
#include "track/activity.h"
#include "track/cubic.h"

namespace betwixt::playing {

// A set of dirty elements, with flags for each.
class Marks {
 public:
  explicit Marks(std::size_t many) : how_(many), which_(many) {}
  void add(std::uint32_t one, std::uint8_t how) {
    if (how_[one] == 0 && how != 0) which_[count_++] = one;
    how_[one] |= how;
  }
  std::uint8_t operator[](std::uint32_t one) const { return how_[one]; }
  std::span<const std::uint32_t> all() const { return {which_.data(), count_}; }  // in the order they were added
  // Lists those below `end`, sorted.
  void in_order(std::uint32_t end, std::vector<std::uint32_t>& out) const;
  void take_back(std::uint32_t one);
  void clear() {
    for (const std::uint32_t one : all()) how_[one] = 0;
    count_ = 0;
  }

 private:
  std::vector<std::uint8_t> how_;
  std::vector<std::uint32_t> which_;
  std::size_t count_ = 0;
};

// A curve's present segment, as cubics, and where its numbers go.
struct alignas(64) Segment : CubicSegment {
  std::uint8_t channels = 0, affects = 0;
  bool bounded : 1 = false;  // must be clamped, so play() skips it
  bool listed : 1 = false;   // in the list of changing curves
  std::uint32_t offset = 0, node = 0;
  Activity active;  // the activity found last
};
static_assert(sizeof(Segment) <= 192, "three cache lines");

// Writes the numbers at `t` of those curves of `which` whose segment contains `t`. Returns how many it skipped; `left`
// gets their indices in `which`. Needs four spare numbers at the end of the array.
std::size_t play(const Segment*, std::span<const std::uint32_t> which, std::int64_t t, double* numbers, Marks&,
                 std::uint32_t* left);

// The offsets of an object's numbers; the rotation has four of them if it is a quaternion.
struct Offsets {
  std::uint32_t position = 0, rotation = 0, scale = 0, pivot = 0;
  bool orientation = false;
};
// The columns of an affine matrix, and its rotation.
struct Own {
  double m[12];
  Quat turn;
};
// Computes the matrices of `nodes`, at most `block`, from position, rotation, scale and pivot. Either all rotations are
// quaternions or none is.
inline constexpr std::size_t block = 64;
void place(const Offsets*, std::span<const std::uint32_t> nodes, const double* numbers, Own* out);

// A node and its parent. The matrix of a `plain` link is the parent's times the own one, moved by the attach position.
struct Link {
  std::uint32_t node = 0, parent = 0, attach = 0;  // attach: an offset
  bool plain = false;
};
// Updates the worlds of plain links, sorted parents first. Marks those that change.
void follow(std::span<const Link>, const double* numbers, const Own*, Mat4* worlds, Marks&);

}  // namespace betwixt::playing

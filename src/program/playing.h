// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The loops of an evaluator that most of a frame is spent in: curves at a time, matrices from what curves say, matrices
// from those that things hang on. Each gives the bits that its plain form gives (CurveSet::evaluate, own_place, hang),
// on every kind of machine.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "betwixt/math.h"
#include "track/activity.h"
#include "track/cubic.h"

namespace betwixt::playing {

// Which of many are dirty, and how.
class Marks {
 public:
  explicit Marks(std::size_t many) : how_(many), which_(many) {}
  void add(std::uint32_t one, std::uint8_t how) {
    if (how_[one] == 0 && how != 0) which_[count_++] = one;
    how_[one] |= how;
  }
  std::uint8_t operator[](std::uint32_t one) const { return how_[one]; }
  std::span<const std::uint32_t> all() const { return {which_.data(), count_}; }  // in the order of their coming
  // Those below `end`, in order.
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

// A curve where it is: the cubics of the segment that it is in, and what becomes of their numbers.
struct Segment : CubicSegment {
  Activity active;  // the last one it was found in
  std::uint32_t offset = 0, node = 0;
  std::uint8_t channels = 0, affects = 0;
  bool bounded = false;  // it is to stay within bounds, and is left to others
  bool listed = false;   // among those that go on changing
};

// The numbers at `t` of those segments (`which`) that it is in. Returns how many are left, their places in `which` in
// `left`. Numbers have four more behind them.
std::size_t play(const Segment*, std::span<const std::uint32_t> which, std::int64_t t, double* numbers, Marks&,
                 std::uint32_t* left);

// Where an object's numbers are, and whether its rotation is four of them: an orientation.
struct Offsets {
  std::uint32_t position = 0, rotation = 0, scale = 0, pivot = 0;
  bool orientation = false;
};
// Columns of an affine matrix, one behind the other, and how it turns.
struct Own {
  double m[12];
  Quat turn;
};
// Of `nodes`, at most `block`, by position, rotation, scale and pivot alone. All or none are orientations.
inline constexpr std::size_t block = 64;
void place(const Offsets*, std::span<const std::uint32_t> nodes, const double* numbers, Own* out);

// What a node hangs on; a `plain` one's matrix is the other's times its own, moved by what it is attached with.
struct Link {
  std::uint32_t node = 0, parent = 0, attach = 0;  // attach: an offset
  bool plain = false;
};
// Of links all of which are plain, parents before children: worlds that differ from those there are marked.
void follow(std::span<const Link>, const double* numbers, const Own*, Mat4* worlds, Marks&);

}  // namespace betwixt::playing

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A program: a document compiled to flat arrays. Ask it for any time, in any order, from any thread.
//
// Room: program
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "betwixt/contacts.h"
#include "betwixt/document.h"
#include "betwixt/frame.h"

namespace betwixt {

// The motion of an object in world space at a time.
struct Kinematics {
  // Of the object's origin: metres, and metres a second. At a jump, the velocity from just before the jump.
  Vec3 position, velocity;
  // The linear part, without translation: takes a difference of two values of the position track to world space.
  Mat4 track_to_world;
};

class Program {
 public:
  // Compiles a document. Cannot fail.
  static Program compile(const Document&);
  // Compiles an edited document. Shares with `before` whatever the edit did not touch; `before` may be the program of
  // any document.
  static Program compile(const Document&, const Program& before);

  // Returns the frame at a time. Pure: the same time gives the same bits, whatever was evaluated before.
  Frame frame(Time) const;
  // Returns the value of a target at a time; that of `world` is a matrix, colours are sRGB. Returns the number 0 if the
  // object does not exist.
  Value read(const Target&, Time) const;
  // Returns the value of each target, evaluating what they share once. The objects must exist. `problems` receives a
  // message for each procedure that gave no value.
  std::vector<Value> read(const std::vector<Target>&, Time, std::vector<std::string>* problems = nullptr) const;
  // Returns the same, for threads that must not wait. Returns std::nullopt if the values take more than `steps` steps
  // (docs/guide/grammar.md#limits) or need code, if there are more than 16 targets, if one of them is Query::touching
  // or Query::in_view, or if the film has traces.
  std::optional<std::vector<Value>> read_within(std::uint64_t steps, const std::vector<Target>&, Time,
                                                std::vector<std::string>* problems = nullptr) const;
  // Returns the targets that procedures read to compute this value, in the order in which they are first read. The
  // object must exist.
  std::vector<Target> reads(const Target&, Time) const;

  // Returns how an object moves in the world. Returns Kinematics{} if it does not exist.
  Kinematics kinematics(ObjectId, Time) const;
  // Returns the motions of an object in order of time, none if it does not exist. A centre that is an object is
  // replaced by the position that the object has when the motion begins.
  std::vector<Motion> motions(ObjectId) const;
  // Returns the first time after `t` at which a frame may differ from that at `t`: until then you need not evaluate or
  // draw. Returns `t` itself while something moves, and std::nullopt if nothing will ever change.
  std::optional<Time> next_change(Time t) const;
  // Returns the times at which values may jump, in order, from just after `after` up to `until`, which is included.
  // Jumps of values that code computes are not among them, nor ticks of environments after the first million.
  std::vector<Time> discontinuities(Time after, Time until) const;

  // Returns betwixt::contacts of the frame, without evaluating all of it.
  Contacts contacts(Time, const ContactOptions& = {}) const;

  const Document& document() const;

  struct Compiled;  // src/program/compiled.h
  const Compiled& compiled() const { return *code_; }

 private:
  std::shared_ptr<const Compiled> code_;
};

// Returns the numbers of a value, for plots: 1 of a scalar or a boolean (which is 0 or 1), 3 of a vector, a pair, a
// color or angles, 4 of a quaternion (w x y z), 16 of a matrix, row by row. Returns an empty list if the value has no
// numbers.
std::vector<double> numbers(const Value&);

}  // namespace betwixt

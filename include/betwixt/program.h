// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A program: a document compiled to flat arrays. You can evaluate it at any time, in any order and from any thread.
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
  // Position and velocity of the object's origin, in metres and metres per second. If the position jumps at this time,
  // the velocity is the one just before the jump.
  Vec3 position, velocity;
  // Converts a difference between two values of the position track to world space. It has no translation.
  Mat4 track_to_world;
};

class Program {
 public:
  // Compiles a document. Cannot fail.
  static Program compile(const Document&);
  // Compiles an edited document. `before` is the program of the document before the edit. The result shares with it
  // what the edit did not change. `before` may also be the program of any other document; then they share less or
  // nothing.
  static Program compile(const Document&, const Program& before);

  // Returns the frame at a time. Pure: the same time gives the same bits, whatever was evaluated before.
  Frame frame(Time) const;
  // Returns the value of a target (a function of an object, such as ball.position) at a time. The value of the function
  // `world` is a matrix, and colours are sRGB. Returns the number 0 if the object does not exist.
  Value read(const Target&, Time) const;
  // Returns the value of each target. A value on which several of them depend is evaluated only once. The objects must
  // exist; otherwise the behaviour is undefined. `problems` receives a message for each procedure that gave no value.
  std::vector<Value> read(const std::vector<Target>&, Time, std::vector<std::string>* problems = nullptr) const;
  // Returns the same values as `read`, for threads that must not wait. Returns std::nullopt in these cases: the values
  // take more than `steps` steps (docs/guide/grammar.md#limits), they need the author's code, there are more than 16
  // targets, a target is Query::touching or Query::in_view, or the document has objects of the kind trace.
  std::optional<std::vector<Value>> read_within(std::uint64_t steps, const std::vector<Target>&, Time,
                                                std::vector<std::string>* problems = nullptr) const;
  // Returns the targets that procedures read to compute this value, in the order in which they are first read. The
  // object must exist.
  std::vector<Target> reads(const Target&, Time) const;

  // Returns how an object moves in the world. Returns Kinematics{} if it does not exist.
  Kinematics kinematics(ObjectId, Time) const;
  // Returns the motions of an object (its sequences of translations, rotations and scalings), in order of time. Returns
  // an empty list if the object does not exist. The centre of a motion may be another object. The result then has a
  // point as the centre: the position of that object when the motion begins.
  std::vector<Motion> motions(ObjectId) const;
  // Returns the first time after `t` at which a frame may differ from that at `t`: until then you need not evaluate or
  // draw. Returns `t` itself while something moves, and std::nullopt if nothing will ever change.
  std::optional<Time> next_change(Time t) const;
  // Returns, in order, the times t at which values may jump, after < t <= until. Omits jumps of values that code
  // computes, and ticks of an environment after its first 1,000,000.
  std::vector<Time> discontinuities(Time after, Time until) const;

  // Returns the contacts at a time: those of betwixt::contacts(frame(t)), without evaluating the whole frame.
  Contacts contacts(Time, const ContactOptions& = {}) const;

  const Document& document() const;

  struct Compiled;  // src/program/compiled.h
  const Compiled& compiled() const { return *code_; }

 private:
  std::shared_ptr<const Compiled> code_;
};

// Returns the numbers of a value, for plots. A scalar gives 1 number, and so does a boolean (0 or 1). A vector, a pair
// (its third number is 0), a color or angles give 3. A quaternion gives 4 (w x y z). A matrix gives 16, row by row.
// Returns an empty list if the value has no numbers.
std::vector<double> numbers(const Value&);

}  // namespace betwixt

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
  // Of the object's origin. The velocity is per second; at a jump it is that from before.
  Vec3 position, velocity;
  Mat4 to_world;  // linear part of the map from the values of its position track to the world
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
  // Returns the value of a target at a time; that of `world` is a matrix, colours are sRGB. A target whose object does
  // not exist yields the number 0. For such an object, kinematics and motions are empty.
  Value read(const Target&, Time) const;
  // Returns the value of each target, evaluating what they share once. `problems` receives a message for each procedure
  // that gave no value.
  std::vector<Value> read(const std::vector<Target>&, Time, std::vector<std::string>* problems = nullptr) const;
  // The same with a limit. Returns std::nullopt unless the values are few, take at most this many steps and need no
  // code.
  std::optional<std::vector<Value>> read_within(std::uint64_t steps, const std::vector<Target>&, Time,
                                                std::vector<std::string>* problems = nullptr) const;
  // Returns the targets that procedures read to compute this value, in order.
  std::vector<Target> reads(const Target&, Time) const;

  Kinematics kinematics(ObjectId, Time) const;
  // Returns the motions of an object in order of time. Centres that are objects are replaced by their positions.
  std::vector<Motion> motions(ObjectId) const;
  // Returns the first time after `t` at which a frame may differ from that at `t`, or `t` itself while something moves.
  // Returns std::nullopt if nothing will ever change. Until then you need not evaluate or draw.
  std::optional<Time> next_change(Time t) const;
  // Returns the times after `after` and up to `until` at which anything but code may jump, in order.
  std::vector<Time> breaks(Time after, Time until) const;

  // Returns betwixt::contacts of the frame, without evaluating all of it.
  Contacts contacts(Time, const ContactOptions& = {}) const;

  const Document& document() const;

  struct Compiled;  // src/program/compiled.h
  const Compiled& compiled() const { return *code_; }

 private:
  std::shared_ptr<const Compiled> code_;
};

// Returns the numbers of a value, for plots: a scalar gives one, a vector three, true gives 1, a matrix sixteen, row by
// row. Returns an empty list if the value has no numbers.
std::vector<double> numbers(const Value&);

}  // namespace betwixt

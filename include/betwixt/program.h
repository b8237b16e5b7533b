// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A program: a document compiled to flat arrays, ready to be asked for any time, in any order, from any thread.
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

// How an object goes through the world at a time.
struct Kinematics {
  // Of its origin, in the world; the velocity per second, coming from before where there is a break.
  Vec3 position, velocity;
  Mat4 to_world;  // the linear part of what takes values of its position track to the world
};

class Program {
 public:
  static Program compile(const Document&);
  // The same, of an edited document: what the edit did not touch is shared with the program before, of whichever
  // document.
  static Program compile(const Document&, const Program& before);

  // Pure: the same time gives the same bits, whatever was asked before.
  Frame frame(Time) const;
  // The value of one display function (or component) at a time, a world as a matrix; colours as the author writes them.
  // Of an object that is not there it is the number 0; kinematics and motions are nothing.
  Value read(const Target&, Time) const;
  // Many at once: what they share is evaluated once. `problems`: procedures that gave no value, in words.
  std::vector<Value> read(const std::vector<Target>&, Time, std::vector<std::string>* problems = nullptr) const;
  // The same, where it is a few values that take at most so many steps and need no code; none: it may take longer.
  std::optional<std::vector<Value>> read_within(std::uint64_t steps, const std::vector<Target>&, Time,
                                                std::vector<std::string>* problems = nullptr) const;
  // What procedures looked at to give this value, in the order they looked.
  std::vector<Target> reads(const Target&, Time) const;

  Kinematics kinematics(ObjectId, Time) const;
  // The motions of an object in the order of time, their centres as places.
  std::vector<Motion> motions(ObjectId) const;
  // The first time after `t` at which a frame may differ from the one at `t`: `t` itself while something goes on
  // moving, none if nothing ever will. Until then nothing need be evaluated or drawn.
  std::optional<Time> next_change(Time t) const;
  // Every time behind the first and up to the other at which something that is not code may jump, in order.
  std::vector<Time> breaks(Time after, Time until) const;

  // What touches and what is in view: betwixt::contacts of the frame, without making all of it.
  Contacts contacts(Time, const ContactOptions& = {}) const;

  const Document& document() const;

  struct Compiled;  // src/program/compiled.h
  const Compiled& compiled() const { return *code_; }

 private:
  std::shared_ptr<const Compiled> code_;
};

// The numbers of a value, for plots: a scalar gives one, a vector three, true 1, a matrix sixteen, row by row; empty
// for what is not made of numbers.
std::vector<double> numbers(const Value&);

}  // namespace betwixt

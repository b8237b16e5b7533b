// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/compiled.h"

namespace betwixt {

// Converts the result of code to the type of its track; a rate of change becomes plain numbers. Errors: why it cannot
// be used, in plain words.
Result<Value> usable(const Scene&, FunctionId, Type, const Value&, bool rate = false);

// Evaluates the tracks of one function of one object, without filters and layers: procedures, places on lines, and
// velocities in force.
struct LiveParts {
  const Program::Compiled& c;
  const Live& live;
  Asking& asking;
  const Scene& scene = c.document.scene();

  std::string name(int component) const { return c.document.name(Target{{live.object}, live.function, component}); }
  Value part_value(const LivePart&, Time) const;
  // Runs the code. Returns nullopt on an error, which is added to `problems`.
  std::optional<Value> run(const Procedure&, const LivePart&, Time) const;
  // Runs a tween between the events before and after index `after`.
  std::optional<Value> run_tween(const Routine&, const LivePart&, const std::vector<const Event*>& near,
                                 std::size_t after, Time) const;
  // Returns the last value at or before t that is not a procedure.
  Value settled(const LivePart&, Time t) const;
  // Returns the default of a function that only has code.
  Value at_rest(const LivePart&) const;

 private:
  // Asks the code by `call`, and checks its answer.
  template <class Call>
  std::optional<Value> answer(const Routine&, const LivePart&, Time, Call&& call) const;
  bool by_definition(const Routine&) const;
  Value kept_value(const Event&, const LivePart&) const;
  Value named(Value) const;
  Value event_value(const Value&, const LivePart&, Time t, Time at) const;
  std::optional<Value> along_line(const Track&, const std::vector<const Event*>& near, std::size_t after, Time t) const;
  Value scripted(const LivePart&, Time) const;
  Value as_written(const LivePart&, double* numbers, bool orientation) const;
  Value piece_value(const LivePart&, std::size_t piece, Time) const;
};

}  // namespace betwixt

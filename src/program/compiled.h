// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The result of compiling a document: its data, and the values of display functions at any time, which may need others.
// Other questions are in placing.h, along.h, contacts.h, traces.h and stage.h; evaluator.h evaluates everything.
#pragma once

#include <functional>

#include "program/asking.h"
#include "program/caches.h"
#include "program/compiled_film.h"
#include "program/held_values.h"

namespace betwixt {

// What a text is turning into, and how far.
struct TextTurn {
  FunctionId function = 0;
  Value to;
  double share = 0;
};
// Returns the shape of a text with the text that it turns into.
std::shared_ptr<const Shape> turned_text(const Shape& from, const TextTurn&, const Scene&);

struct Program::Compiled : CompiledFilm {
  explicit Compiled(Document d);
  ~Compiled();

  mutable std::vector<Frozen> frozen;  // thawed while compiling: all done after it
  mutable Caches caches;

  // Evaluates the numbers of one binding.
  void evaluate(const Binding& b, Time t, Asking&, double* out) const;
  // Returns a value in the author's units. With `component`, returns that number alone, if parted() allows.
  Value live_value(std::int32_t live, Time t, Asking&, int component = -1) const;
  // Returns the value of a position with obstacles without these.
  Value free_position(const Live&, Time t, Asking&) const;
  // Returns the rate of change per second, in the author's units, or nullopt for types without one. The rate is the one
  // after t, or before t with `coming`.
  std::optional<Value> velocity(std::uint32_t object, FunctionId f, Time t, Asking&, bool coming = false) const;
  Value read(const Target&, Time t, Asking&) const;
  Value value(const Binding& b, Time t, Asking&) const;  // at t; points may be in transition
  Between between(const Binding& b, Time t, Asking&) const;
  // `place`: returns a node's world position.
  std::optional<Vec3> aim(std::uint32_t object, FunctionId, Time t, const double* numbers,
                          const std::function<Vec3(std::uint32_t)>& place, Asking&) const;
  // Returns a function's value as a shape uses it. Points in transition lie between two of the author's. `numbers`: the
  // array for the time, or null to evaluate.
  Value shape_part(const Binding& b, Time t, const double* numbers, Asking&) const;
  Shape shape(std::uint32_t object, Time t, const double* numbers, Asking&) const;
  void show_parts(Shape&, std::uint32_t object) const;
  std::optional<TextTurn> text_turn(std::uint32_t object, Time t, Asking&) const;
  // Returns the shape that the drawable has by itself.
  std::shared_ptr<const Shape> drawn_shape(std::uint32_t drawable, Time t, Asking&) const;
  // Returns the deformed mesh of a skin.
  std::shared_ptr<const Mesh> posed(std::int32_t skin, Time t, Asking&) const;
};

}  // namespace betwixt

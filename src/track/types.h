// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The types of values, a row each. Whatever follows from a type alone is said in its row, and asked of it there.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "track/event.h"

namespace betwixt {

// How its values become others.
enum class Changes : std::uint8_t {
  in_steps,    // at events only
  gradually,   // there are others between any two
  by_turning,  // so, as slerp and squad know how
};

struct TypeRow {
  Type type = Type::scalar;
  std::string_view word = {};        // in scripts (define) and plug-ins; empty: no function of an author's has the type
  std::string_view phrase = {};      // in the author's words
  Value (*example)() = nullptr;      // one that says nothing: what a function is where its author says no more
  std::string_view components = {};  // their letters; empty: it is written as a whole only
  Type component = Type::scalar;     // the type of each
  int channels = 0;                  // numbers in a program's array, at most; 0: it is not made of numbers
  Twerper twerper = Twerper::hold;   // what `unset` stands for (turns, orientations: slerp)
  Changes changes = Changes::in_steps;
  std::optional<Type> rate = {};  // its rate of change, number by number; none: it has no velocity
  bool angles = false;            // its numbers are radians
  bool light = false;             // its numbers are sRGB; what is blended is the light that they stand for
  bool tangents = false;          // hermite may be told them
  bool computed = false;          // code can give a value
  bool dials = false;             // live input and plug-ins can
  bool rotates = false;           // it can be turned about an axis
};
const TypeRow& row_of(Type);
const TypeRow* find_type(std::string_view word);
std::vector<std::string_view> type_words();  // of all types that have one

// Components: x y z, or r g b of colours. How many the type can be written by: 3 of rotations too (their angles), 0 of
// what has none.
int component_count(Type);
std::string_view component_name(Type, int component);
int find_component(Type, std::string_view name);  // -1: there is no such component
Type component_type(Type);
// The type of a component's track: a colour's blend as colours do, in light.
Type component_track_type(Type);

// Whether `twerper` means anything for values of the type; the reason if not.
bool fits(Twerper, Type, std::string* why = nullptr);

// A value's numbers: scalars and on or off 1, vectors, colours (as written) and angles 3, orientations 4 (w x y z);
// all else has none.
bool numeric(const Value&);
int to_numbers(const Value&, double* out);
double component_of(const Value&, int component);
// The value with other numbers; those from `count` on stay what they are. An aim at an object becomes one at a point.
Value with_numbers(Value, const double* numbers, int count = 4);
Value with_component(Value, int component, double number);

// How many numbers make a value of the type, and the value. `orientation`: four numbers are an orientation, where the
// type has angles too.
int number_count(Type);
Value value_of_numbers(Type, const double* numbers, bool orientation = false);
// The value as one of the type, where that needs no more to be known: a vector as a colour or as angles, a number as a
// text.
std::optional<Value> fitted(const Value&, Type);

}  // namespace betwixt

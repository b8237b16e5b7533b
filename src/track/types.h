// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The types of values, a row each. Everything that follows from a type alone is in its row.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "track/event.h"

namespace betwixt {

// How values of a type change over time.
enum class Changes : std::uint8_t {
  in_steps,    // at events only
  gradually,   // with values in between
  by_turning,  // by rotation, as slerp and squad do
};

struct TypeRow {
  Type type = Type::scalar;
  std::string_view word = {};        // in scripts (define) and plug-ins; "": authors cannot define such functions
  std::string_view phrase = {};      // in the author's words
  Value (*example)() = nullptr;      // a neutral value: the default of a function whose author gives none
  std::string_view components = {};  // their letters; "": it can be written as a whole only
  Type component = Type::scalar;     // the type of each
  int channels = 0;                  // numbers in a program's array, at most; 0: it does not consist of numbers
  Twerper twerper = Twerper::hold;   // the meaning of `unset` (of rotations, for orientations: slerp)
  Changes changes = Changes::in_steps;
  std::optional<Type> rate = {};  // the type of its derivative; nullopt: it has no velocity
  bool angles = false;            // its numbers are radians
  bool light = false;             // its numbers are sRGB, and are blended in linear light
  bool tangents = false;          // takes tangents of hermite
  bool computed = false;          // code can give a value
  bool dials = false;             // live input and plug-ins can give a value
  bool rotates = false;           // can be rotated about an axis
};
const TypeRow& row_of(Type);
const TypeRow* find_type(std::string_view word);
std::vector<std::string_view> type_words();  // of all types that have one

// Returns the number of components with names, x y z or r g b: 3 for rotations too (their angles), 0 if the type has
// none.
int component_count(Type);
std::string_view component_name(Type, int component);
int find_component(Type, std::string_view name);  // -1 if there is none
Type component_type(Type);
// Returns the type of a component's track. That of a colour blends in light, as colours do.
Type component_track_type(Type);

// Returns whether the twerper has a meaning for values of the type; sets `why` to the reason if not.
bool fits(Twerper, Type, std::string* why = nullptr);

// Returns whether a value consists of numbers: a number or boolean of 1; vectors, colours (sRGB) and angles of 3;
// orientations of 4 (w x y z).
bool numeric(const Value&);
int to_numbers(const Value&, double* out);
double component_of(const Value&, int component);
// Returns the value with other numbers; those from `count` on stay. An aim at an object becomes an aim at a point.
Value with_numbers(Value, const double* numbers, int count = 4);
Value with_component(Value, int component, double number);

// Returns how many numbers a value of the type has, and the value of such numbers. `orientation`: for a type that has
// angles too, four numbers are an orientation.
int number_count(Type);
Value value_of_numbers(Type, const double* numbers, bool orientation = false);
// Converts a value to the type if that needs no further knowledge: a vector to a colour or to angles, a number to a
// text. Returns nullopt otherwise.
std::optional<Value> fitted(const Value&, Type);

}  // namespace betwixt

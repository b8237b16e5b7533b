// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Display functions: what can vary about an object. The kinds' parameters are display functions like all others.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/object.h"
#include "track/types.h"

namespace betwixt {

using FunctionId = std::uint16_t;
constexpr std::uint32_t bit(Kind k) { return 1u << static_cast<unsigned>(k); }

constexpr std::uint32_t all_kinds = 0xffffffff;

// Of a function that need not have a color: `none`.
inline constexpr Color no_color{-1, -1, -1};

struct FunctionSpec {
  std::string name = {};
  Type type = Type::scalar;
  Value rest = {};                  // the value where nobody says otherwise
  std::uint32_t kinds = all_kinds;  // bit per Kind; of a built-in one, all: those that are placed
  Unit unit = Unit::none;
  std::string words = {};             // for texts that are one of a few words: "point|sun"
  double low = -1e300, high = 1e300;  // numbers outside mean nothing
  // Puts its value at a time into a shape: numbers come as they are held, a double or a Vec3. None: it is no part of
  // one.
  void (*shape)(Shape&, const Value&, const Scene&) = nullptr;
  bool place = false;  // whether it says where things are, or what of them is seen
  std::string_view sentence = {}, written = {}, example = {};  // for help; one row speaks for all of its name
  // Whether what touches what can depend on it.
  bool matters_to_contacts() const { return place || shape != nullptr; }
  friend bool operator==(const FunctionSpec&, const FunctionSpec&) = default;
};

// The words of a text that is one of a few.
std::vector<std::string_view> choices(const FunctionSpec&);

// The built-in ones, in the order of their ids; those of `fn` first.
std::span<const FunctionSpec> built_in_functions();
std::optional<FunctionId> find_built_in(Kind kind, std::string_view name);

// Ids of those that the program needs by name.
namespace fn {
enum : FunctionId {
  position,
  rotation,
  scale,
  pivot,
  attach_position,
  color,
  shininess,
  transparency,
  geometry,
  display,
  material,
  texture,
  radius,
  box_size,
  plane_size,
  text_size,
  point_size,
  height,
  tube,
  points,
  width,
  text,
  font,
  depth,
  file,
  range,
  intensity,
  shines,
  lens,
  fov,
  camera_height,
  look_at,
  attachment,
  weight,
  mode,
  environments,
  drive,
  transform,
  motion,
  front,
  roll,
  look_offset,
  trace_of,
  trace_within,
  trace_point,
  trace_from,
  trace_until,
  trace_last,
  casts,
  casting,
  reach,
  reach_share,
  reach_pole,
  reach_chain,
  sound_file,
  sound_at,
  sound_from,
  sound_until,
  gain,
  fade_in,
  fade_out,
  shutter,
  f_stop,
  focus,
  joints,
  count
};
}

}  // namespace betwixt

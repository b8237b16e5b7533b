// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Display functions: the properties of objects that can be animated. Parameters of kinds are display functions too.
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
using KindBits = std::uint64_t;
constexpr KindBits bit(Kind k) { return KindBits{1} << static_cast<unsigned>(k); }

constexpr KindBits all_kinds = ~KindBits{0};

// The value `none` of an optional colour.
inline constexpr Color no_color{-1, -1, -1};

// A word of other programs for a value, and what does the same here.
struct OtherWord {
  std::string_view word, leads;
  friend bool operator==(const OtherWord&, const OtherWord&) = default;
};

struct FunctionSpec {
  std::string name = {};
  Type type = Type::scalar;
  Value rest = {};             // the default
  KindBits kinds = all_kinds;  // a bit per Kind; all: those that have a place
  Unit unit = Unit::none;
  std::string words = {};               // the valid words of a text: "point|sun"
  std::vector<OtherWord> instead = {};  // of other words: hints of errors
  double low = -1e300, high = 1e300;    // the range of valid numbers
  // Puts a value into a shape: numbers as they are held, a double or a Vec3. Null if it is not part of a shape.
  void (*shape)(Shape&, const Value&, const Scene&) = nullptr;
  bool by_script = false;                                      // read once, with the script: code cannot compute it
  bool place = false;                                          // whether it affects the place or visibility of objects
  bool open = false;                                           // of a vector: its third number may be left out
  std::string_view sentence = {}, written = {}, example = {};  // for help; each row has its own sentence
  // Returns whether contacts can depend on it.
  bool matters_to_contacts() const { return place || shape != nullptr; }
  friend bool operator==(const FunctionSpec&, const FunctionSpec&) = default;
};

// Returns the valid words of a text.
std::vector<std::string_view> choices(const FunctionSpec&);

// The built-in ones, in the order of their ids, those of `fn` first.
std::span<const FunctionSpec> built_in_functions();
std::optional<FunctionId> find_built_in(Kind kind, std::string_view name);

// Returns whether objects of the kind have a list of points, which axes place instead of the position. (The points of a
// star are a number.)
inline bool has_points(Kind kind) {
  const auto f = find_built_in(kind, "points");
  return f && built_in_functions()[*f].type == Type::points;
}

// Ids of functions that the program needs by name.
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
  sound_words,
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
  obstacles,
  collision,
  bounciness,
  velocity_space,
  on_axes,
  placed,
  bare,
  metalness,  // the finish, up to texture_turn
  roughness,
  emission,
  emission_strength,
  clearcoat,
  clearcoat_roughness,
  sheen,
  sheen_roughness,
  transmission,
  ior,
  thickness,
  normal_strength,
  normal_map,
  roughness_map,
  metalness_map,
  occlusion_map,
  emission_map,
  texture_projection,
  texture_tile,
  texture_move,
  texture_turn,
  light_shape,
  light_size,
  cone,
  cone_edge,
  light_picture,
  opacity,  // of groups that are drawn as a whole, up to shadow_opacity
  layer_blend,
  layer_mask,
  layer_blur,
  glow,
  glow_size,
  drop_shadow,
  shadow_color,
  shadow_opacity,
  gradient,  // of what is filled, up to gradient_spread; then the same of strokes
  gradient_color,
  gradient_stops,
  gradient_turn,
  gradient_move,
  gradient_size,
  gradient_spread,
  stroke_gradient,
  stroke_gradient_color,
  stroke_gradient_stops,
  stroke_gradient_turn,
  stroke_gradient_move,
  stroke_gradient_size,
  stroke_gradient_spread,
  video_file,
  video_at,  // of videos, up to video_time; and in the same order of videos as textures
  video_from,
  video_until,
  video_speed,
  video_loop,
  video_time,
  texture_at,
  texture_from,
  texture_until,
  texture_speed,
  texture_loop,
  texture_time,
  count
};
}

// The functions that make a finish.
inline bool is_of_finish(FunctionId f) { return f >= fn::metalness && f <= fn::texture_turn; }
// The functions that make a layer of a group.
inline bool is_of_layer(FunctionId f) { return f >= fn::opacity && f <= fn::shadow_opacity; }
// The functions that make gradients.
inline bool is_of_gradient(FunctionId f) { return f >= fn::gradient && f <= fn::stroke_gradient_spread; }
// Those whose value is the file of a picture.
inline bool is_picture(FunctionId f) {
  return f == fn::texture || (f >= fn::normal_map && f <= fn::emission_map) || f == fn::light_picture;
}

}  // namespace betwixt

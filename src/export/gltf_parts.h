// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a glTF file: numbers in one buffer, and the accessors and animations that refer to them.
// Source: glTF 2.0, sections 3.6 (binary data) and 3.11 (animations).
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "betwixt/export.h"
#include "export/json.h"

namespace betwixt::gltf {

class Buffer {
 public:
  enum Use { plain = 0, vertices = 34962, indices = 34963 };
  // Returns the number of an accessor. `bounds`: writes the minimum and maximum of each number. Equal data is stored
  // once.
  std::size_t floats(const std::vector<float>& all, std::size_t width, Use use, bool bounds);
  std::size_t whole(const std::vector<std::uint32_t>& all);  // indices of triangles
  // Four numbers for each vertex; joints without weight are 0.
  std::size_t joints(const std::vector<std::array<std::uint16_t, 4>>&,
                     const std::vector<std::array<float, 4>>& weights);
  std::size_t picture(std::string_view png);  // returns the number of the buffer view

  Json views = Json::array(), accessors = Json::array();
  std::string bytes;

 private:
  std::size_t view(std::string_view data, Use use);
  std::map<std::pair<std::string, std::size_t>, std::size_t> known_;  // by bytes, width and use
};

// A channel as glTF plays it: STEP, LINEAR or CUBICSPLINE, `width` numbers in a key.
struct Sampled {
  std::string way;
  std::vector<float> times, values;  // CUBICSPLINE: three values in a key: in-tangent, value, out-tangent
};
// `steps`: held pieces are STEP. Otherwise they are two LINEAR keys, since assimp reads STEP as LINEAR.
Sampled sampled(const Channel&, Time beginning, bool steps);

// The animation of a file.
struct Timeline {
  Time beginning;
  std::size_t frames = 1;  // of the film
  bool steps = true;       // whether STEP is used
  Exported& made;          // counts its keys
  Buffer buffer;
  Json channels = Json::array(), samplers = Json::array();
  std::vector<std::string> used = {};  // extensions

  void animate(const Channel&, Json target);
  void animate(const Sampled&, std::size_t width, Json target);
  // Animates a property through KHR_animation_pointer: "/materials/0/…".
  void point(const std::string& pointer, const Channel&);
  void use(const char* extension);
};

Json numbers(const std::array<double, 4>&, std::size_t width);
std::array<double, 4> within_one(std::array<double, 4>);
// Returns the times at which pieces of the channels begin, and both ends.
std::vector<Time> keys_of(std::initializer_list<const Channel*>, Time from, Time until);

}  // namespace betwixt::gltf

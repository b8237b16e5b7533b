// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a glTF file: numbers in one buffer, and what speaks of them.
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
  // `bounds`: the file says the least and the most of each number. Equal numbers are kept once. The accessor's number.
  std::size_t floats(const std::vector<float>& all, std::size_t width, Use use, bool bounds);
  std::size_t whole(const std::vector<std::uint32_t>& all);  // of triangles
  // Of vertices: four numbers each; one that counts for nothing is 0.
  std::size_t joints(const std::vector<std::array<std::uint16_t, 4>>&,
                     const std::vector<std::array<float, 4>>& weights);
  std::size_t picture(std::string_view png);  // the view's number

  Json views = Json::array(), accessors = Json::array();
  std::string bytes;

 private:
  std::size_t view(std::string_view data, Use use);
  std::map<std::pair<std::string, std::size_t>, std::size_t> known_;  // by bytes, width and use
};

// A channel as glTF plays it: STEP, LINEAR or CUBICSPLINE, `width` numbers a key.
struct Sampled {
  std::string way;
  std::vector<float> times, values;  // CUBICSPLINE: three values a key: how it comes, what it is, how it goes
};
// `steps`: what is held has STEP. Else two LINEAR keys: assimp takes STEP for LINEAR.
Sampled sampled(const Channel&, Time beginning, bool steps);

// What varies of a file, and the numbers of all of it.
struct Timeline {
  Time beginning;
  std::size_t frames = 1;  // of the film
  bool steps = true;       // whether STEP is written
  Exported& made;          // counts its keys
  Buffer buffer;
  Json channels = Json::array(), samplers = Json::array();
  std::vector<std::string> used = {};  // extensions

  void animate(const Channel&, Json target);
  void animate(const Sampled&, std::size_t width, Json target);
  // By KHR_animation_pointer: "/materials/0/…".
  void point(const std::string& pointer, const Channel&);
  void use(const char* extension);
};

Json numbers(const std::array<double, 4>&, std::size_t width);
std::array<double, 4> within_one(std::array<double, 4>);
// Where channels have something new, and both ends.
std::vector<Time> keys_of(std::initializer_list<const Channel*>, Time from, Time until);

}  // namespace betwixt::gltf

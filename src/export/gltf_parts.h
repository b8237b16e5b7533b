// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a glTF file: numbers in one buffer, and what speaks of them.
// Source: glTF 2.0, sections 3.6 (binary data) and 3.11 (animations).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "betwixt/keys.h"
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
  std::size_t picture(std::string_view png);                 // the view's number

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
Sampled sampled(const Channel&, Time beginning);

}  // namespace betwixt::gltf

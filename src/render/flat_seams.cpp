// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/flat_seams.h"

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

constexpr float long_enough = 4, same_place = 0.01F;  // pixels
constexpr std::size_t most_edges = 8;

}  // namespace

void LongEdges::add(float x0, float y0, float x1, float y1) {
  const float length = std::abs(x1 - x0) + std::abs(y1 - y0);
  if (length < long_enough || (edges_.size() == most_edges && length <= shortest_)) return;
  const auto length_of = [](const auto& e) { return std::abs(e[2] - e[0]) + std::abs(e[3] - e[1]); };
  const auto shorter = [&](const auto& a, const auto& b) { return length_of(a) < length_of(b); };
  if (edges_.size() < most_edges)
    edges_.push_back({x0, y0, x1, y1});
  else
    *std::min_element(edges_.begin(), edges_.end(), shorter) = {x0, y0, x1, y1};
  shortest_ = length_of(*std::min_element(edges_.begin(), edges_.end(), shorter));
}

std::vector<std::vector<std::uint32_t>> sharing_edges(const std::vector<const LongEdges*>& of_objects) {
  std::vector<std::vector<std::uint32_t>> beside(of_objects.size());
  struct One {
    float sum;  // of the coordinates, which is nearly the same for the same edge
    std::uint32_t object;
    const std::array<float, 4>* edge;
  };
  std::vector<One> all;
  for (std::uint32_t i = 0; i < of_objects.size(); ++i)
    for (const auto& e : of_objects[i]->get()) all.push_back({e[0] + e[1] + e[2] + e[3], i, &e});
  std::sort(all.begin(), all.end(), [](const One& a, const One& b) { return a.sum < b.sum; });
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t j = k + 1; j < all.size() && all[j].sum - all[k].sum < 4 * same_place; ++j) {
      const std::uint32_t a = all[k].object, b = all[j].object;
      const auto near = [&](std::size_t i, std::size_t x) {
        return std::abs((*all[k].edge)[i] - (*all[j].edge)[x]) < same_place;
      };
      // Areas on both sides of an edge go along it in opposite directions.
      if (a != b && near(0, 2) && near(1, 3) && near(2, 0) && near(3, 1))
        beside[a].push_back(b), beside[b].push_back(a);
    }
  return beside;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Objects of flat pictures that share an edge, such as the slices of a pie: each covers a share of the pixels there,
// and the shares add up. If one were laid over the other, what is behind both would show between them as a hairline.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace betwixt {

// The edges of an object that it may share with another: the longest ones. Corners in pixels, in the order of the
// outline.
class LongEdges {
 public:
  void add(float x0, float y0, float x1, float y1);
  void clear() { edges_.clear(); }
  const std::vector<std::array<float, 4>>& get() const { return edges_; }

 private:
  std::vector<std::array<float, 4>> edges_;
  float shortest_ = 0;
};

// Returns for each object the others that have an edge of it too.
std::vector<std::vector<std::uint32_t>> sharing_edges(const std::vector<const LongEdges*>& of_objects);

}  // namespace betwixt

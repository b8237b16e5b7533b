// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The share of each pixel that an area covers, exactly (analytic antialiasing). An edge adds to the row that it crosses
// the change of coverage that it makes from one pixel to the next. The sum from the left is the coverage.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace betwixt {

// An area by its edges, in pixels from the top left of the picture. Add polygons of one orientation; where they
// overlap, the coverage is limited to 1.
class Area {
 public:
  Area() = default;
  Area(int width, int height)
      : width_(static_cast<float>(width)), height_(static_cast<float>(height)), left_(width_), top_(height) {}
  void add(float x0, float y0, float x1, float y1);
  // Sorts the edges; call it once, after the last edge.
  void finish();
  bool empty() const { return edges_.empty(); }
  int top() const { return top_; }        // the first row
  int bottom() const { return bottom_; }  // the row after the last one
  float left() const { return left_; }
  float right() const { return right_; }

 private:
  friend class CoverageRows;
  struct Edge {
    float x, top, bottom, slope;  // x at the top; pixels to the right for each row
    float sign;
  };
  void add_inside(float x0, float y0, float x1, float y1, float sign);
  std::vector<Edge> edges_;
  float width_ = 0, height_ = 0, left_ = 0, right_ = 0;
  int top_ = 0, bottom_ = 0;
};

// A part of a row: the coverage of the pixels from `first` on.
struct RowCoverage {
  int first = 0;
  std::span<const float> of;
};

// Reads an area from its top row to its bottom row.
class CoverageRows {
 public:
  explicit CoverageRows(const Area& area) : area_(&area) {}
  // Returns the coverage of the next row. `sums` has two more places than the picture has pixels in a row, all of them
  // 0, before and after the call; `room` has as many.
  RowCoverage next(int row, std::span<float> sums, std::span<float> room);

 private:
  const Area* area_;
  std::size_t begun_ = 0;
  std::vector<std::uint32_t> active_;
};

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The line that a shape is, or that goes round it: what things go along, and measures by its length.
#pragma once

#include <vector>

#include "betwixt/shape.h"

namespace betwixt {

// Points in object space; closed: from the last one on to the first. Empty: the shape has no line.
//   polyline, trace its points             curve    through its points, smooth or straight
//   arc      its middle             arrow    from its position to its tip; line as well
//   polygon, disc, and the other flat shapes: their (outer) contour, anticlockwise from where it begins
struct Line {
  std::vector<Vec3> points;
  bool closed = false;
};
Line line_of(const Shape&);
bool has_line(Kind);

// A line by its length.
class MeasuredLine {
 public:
  explicit MeasuredLine(Line line);
  bool empty() const { return points_.empty(); }
  double length() const { return reached_.empty() ? 0 : reached_.back(); }
  // At a share of the length: 0 its beginning, 1 its end. Beyond these a closed line goes round again, an open one on
  // straight.
  struct Place {
    Vec3 point, direction;  // the direction has length 1; it is (1 0 0) where the line has no length
  };
  Place at(double share) const;

 private:
  std::vector<Vec3> points_;  // of a closed line the first one again behind the last
  std::vector<double> reached_;
  bool closed_;
};

// Smooth through points: Catmull-Rom, each segment as many straight pieces as it needs to be a curve to the eye.
std::vector<Vec3> through(const std::vector<Vec3>& points, bool closed);

}  // namespace betwixt

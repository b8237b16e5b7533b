// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The line of a shape, or around it, by its length: objects move along it.
#pragma once

#include <vector>

#include "betwixt/shape.h"

namespace betwixt {

// Points in object space; closed: from the last one to the first. Empty: the shape has no line.
//   polyline, trace, plot, tangent: its points        curve    through its points, smooth or straight
//   arc      its middle             arrow    from its position to its tip; line as well
//   polygon, disc, and the other flat shapes: their (outer) contour, anticlockwise from where it begins
struct Line {
  std::vector<Vec3> points;
  bool closed = false;
};
Line line_of(const Shape&);
// Returns the pieces of a line that has a break (see Shape): one for most shapes.
std::vector<Line> lines_of(const Shape&);
bool has_line(Kind);

// A line with its length.
class MeasuredLine {
 public:
  explicit MeasuredLine(Line line);
  bool empty() const { return points_.empty(); }
  double length() const { return reached_.empty() ? 0 : reached_.back(); }
  // A place by its share of the length: 0 is the beginning, 1 the end. Beyond these a closed line goes round again and
  // an open one straight on.
  struct Place {
    Vec3 point, direction;  // of length 1; (1 0 0) if the line has no length
  };
  Place at(double share) const;

 private:
  std::vector<Vec3> points_;  // of a closed line, the first one again at the end
  std::vector<double> reached_;
  bool closed_;
};

// Returns a smooth curve through points: Catmull-Rom, each segment with as many straight pieces as the eye needs.
std::vector<Vec3> through(const std::vector<Vec3>& points, bool closed);

}  // namespace betwixt

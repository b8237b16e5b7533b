// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts the curves of outlines to straight lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "scene/outline.h"

namespace betwixt {

inline constexpr double fineness = 0.0015;  // em: the largest error of a flattened curve

class Flattener {
 public:
  explicit Flattener(double stray) : stray_(stray) {}

  // One polyline of any length.
  struct Run {
    Contour points;
    bool closed = false;
  };

  void move(Vec3 to) { runs_.push_back({{to}, false}); }
  // Later lines need another `move`.
  void line(Vec3 to) { runs_.back().points.push_back(to); }
  void close() { runs_.back().closed = true; }
  void conic(Vec3 b, Vec3 c) {
    const Vec3 a = here();
    const int n = steps(2 * length(a - 2 * b + c));
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n, u = 1 - t;
      line(u * u * a + 2 * u * t * b + t * t * c);
    }
  }
  void cubic(Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 a = here();
    const int n = steps(6 * std::max(length(a - 2 * b + c), length(b - 2 * c + d)));
    for (int i = 1; i <= n; ++i) {
      const double t = static_cast<double>(i) / n, u = 1 - t;
      line(u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d);
    }
  }
  bool begun() const { return !runs_.empty(); }
  Vec3 here() const { return runs_.back().points.back(); }

  // Returns all lines, without repeated points; a closed line has its common end only once.
  std::vector<Run> take_runs() {
    for (auto& [points, closed] : runs_) {
      points.erase(std::unique(points.begin(), points.end()), points.end());
      if (closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
    }
    return std::exchange(runs_, {});
  }
  // Returns the lines that enclose an area, closed or not.
  std::vector<Contour> take() {
    std::vector<Contour> out;
    for (auto& [points, closed] : take_runs()) {
      if (points.size() > 1 && points.front() == points.back()) points.pop_back();
      if (points.size() > 2) out.push_back(std::move(points));
    }
    return out;
  }

 private:
  // Returns the number of lines that keep the error small. `bend`: the curve's second differences.
  int steps(double bend) const {
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8 * stray_))), 1.0, 128.0));
  }

  std::vector<Run> runs_;
  double stray_;
};

}  // namespace betwixt

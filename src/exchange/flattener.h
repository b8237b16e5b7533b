// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Curves of outlines become straight lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "scene/outline.h"

namespace betwixt {

inline constexpr double fineness = 0.0015;  // em: how far a flattened curve may stray

class Flattener {
 public:
  explicit Flattener(double stray) : stray_(stray) {}

  // One line, of whatever length.
  struct Run {
    Contour points;
    bool closed = false;
  };

  void move(Vec3 to) { runs_.push_back({{to}, false}); }
  // Those that follow need a `move` before them.
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

  // All lines, no point twice in a row, and where they are closed each end once.
  std::vector<Run> take_runs() {
    for (auto& [points, closed] : runs_) {
      points.erase(std::unique(points.begin(), points.end()), points.end());
      if (closed && points.size() > 1 && points.front() == points.back()) points.pop_back();
    }
    return std::exchange(runs_, {});
  }
  // What encloses something, closed or not.
  std::vector<Contour> take() {
    std::vector<Contour> out;
    for (auto& [points, closed] : take_runs()) {
      if (points.size() > 1 && points.front() == points.back()) points.pop_back();
      if (points.size() > 2) out.push_back(std::move(points));
    }
    return out;
  }

 private:
  // As many as keep the lines near the curve, whose second differences are `bend`.
  int steps(double bend) const {
    return static_cast<int>(std::clamp(std::ceil(std::sqrt(bend / (8 * stray_))), 1.0, 128.0));
  }

  std::vector<Run> runs_;
  double stray_;
};

}  // namespace betwixt

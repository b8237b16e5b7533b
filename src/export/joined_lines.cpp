// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/joined_lines.h"

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

// Joins the lines of several looks, which have their inner points in common.
class JoinedLines {
 public:
  explicit JoinedLines(const PlanarLooks& looks) : looks_(looks) {}

  std::optional<DrawnOn> one_line(double tolerance) {
    std::size_t fewest = SIZE_MAX, most = 0;
    for (const SeenThen& l : looks_) {
      if (!l.drawn) continue;
      const PlanarDrawn& d = *l.drawn;
      if (!d.filled.empty() || !d.bordered.empty() || d.stroked.size() > 1 || d.from > 0 || d.to < 1 || d.toward)
        return std::nullopt;
      if (d.stroked.empty()) continue;
      if (d.stroked[0].closed) return std::nullopt;
      fewest = std::min(fewest, d.stroked[0].points.size()), most = std::max(most, d.stroked[0].points.size());
    }
    if (most < 3 || fewest == most) return std::nullopt;
    for (const SeenThen& l : looks_)
      if (!join(points_of(l))) return std::nullopt;
    if (!tip_.empty()) core_.push_back(tip_.back());
    at_ = {0};
    for (std::size_t i = 1; i < core_.size(); ++i) at_.push_back(at_.back() + length(core_[i] - core_[i - 1]));
    if (!(at_.back() > 0)) return std::nullopt;
    DrawnOn out{core_, {}};
    for (std::size_t i = 0; i < looks_.size(); ++i) {
      const auto points = points_of(looks_[i]);
      if (points.size() < 2) {
        const double there = out.shares.empty() ? 0 : out.shares.back().second;
        out.shares.emplace_back(there, there);
        continue;
      }
      const auto from = place(points.front(), firsts_[i] == 0 ? 0 : firsts_[i] - 1, tolerance);
      const auto to = place(points.back(), firsts_[i] + points.size() - 3, tolerance);
      if (!from || !to) return std::nullopt;
      out.shares.emplace_back(*from / at_.back(), std::max(*from, *to) / at_.back());
    }
    return out;
  }

 private:
  static std::vector<Vec3> points_of(const SeenThen& l) {
    return l.drawn && !l.drawn->stroked.empty() ? l.drawn->stroked[0].points : std::vector<Vec3>{};
  }
  static bool near(Vec3 a, Vec3 b) { return length(a - b) <= 1e-9 * (1 + length(a)); }

  // The inner points must be some of the known ones, and may continue beyond them.
  bool join(const std::vector<Vec3>& points) {
    if (points.size() < 2) {
      firsts_.push_back(1);
      return true;
    }
    if (core_.empty()) core_.push_back(points[0]), first_ = 1;
    const std::size_t inner = points.size() - 2;
    if (inner > 0) {
      std::size_t at = first_;
      while (at < core_.size() && !near(core_[at], points[1])) ++at;
      first_ = at;
      for (std::size_t k = 0; k < inner; ++k) {
        if (at + k == core_.size())
          core_.push_back(points[k + 1]);
        else if (!near(core_[at + k], points[k + 1]))
          return false;
      }
      if (at + inner != core_.size()) return false;  // it has become shorter at its tip
    } else if (first_ != core_.size()) {
      first_ = core_.size();
    }
    firsts_.push_back(first_);
    tip_ = {points.back()};
    return true;
  }
  // Returns the position along the line of a point on the side that begins at `side`.
  std::optional<double> place(Vec3 p, std::size_t side, double tolerance) const {
    side = std::min(side, core_.size() - 2);
    double best = INFINITY, where = 0;
    for (std::size_t i = side; i < std::min(side + 2, core_.size() - 1); ++i) {
      const Vec3 a = core_[i], way = core_[i + 1] - a;
      const double s = dot(way, way) > 0 ? std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0) : 0;
      if (const double off = length(a + s * way - p); off < best) best = off, where = at_[i] + s * length(way);
    }
    return best <= tolerance ? std::optional(where) : std::nullopt;
  }

  const PlanarLooks& looks_;
  std::vector<Vec3> core_, tip_;
  std::vector<std::size_t> firsts_;  // for each look: the index in the core of its second point
  std::size_t first_ = 1;
  std::vector<double> at_;
};

}  // namespace

std::optional<DrawnOn> joined_lines(const PlanarLooks& looks, double tolerance) {
  return JoinedLines(looks).one_line(tolerance);
}

}  // namespace betwixt

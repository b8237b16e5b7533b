// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/curve_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace betwixt {
namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr Vec3 no_place{no_number, no_number, no_number};
constexpr int deepest_halving = 12, deepest_search = 48;

bool is_place(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// Returns how far a point is from the chord between two others.
double off_chord(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 way = b - a;
  const double whole = dot(way, way), share = whole > 0 ? std::clamp(dot(p - a, way) / whole, 0.0, 1.0) : 0;
  return length(p - (a + share * way));
}

class Sampler {
 public:
  explicit Sampler(const CurveSampling& s) : s_(s), left_(s.most) {}

  std::vector<CurvePoint> all() {
    CurvePoint last = look(s_.from);
    if (!last.breaks()) out_.push_back(last);
    for (int i = 1; i <= s_.pieces; ++i) {
      // Not even: a wave as long as a piece would look straight.
      const double u = static_cast<double>(i) / s_.pieces,
                   uneven = i < s_.pieces ? 0.3 / s_.pieces * std::sin(12.9898 * i) : 0;
      const CurvePoint next = look(s_.from + (u + uneven) * (s_.to - s_.from));
      between(last, next, 0);
      last = next;
    }
    return std::move(out_);
  }

 private:
  CurvePoint look(double at) {
    --left_;
    const Vec3 p = s_.place(at);
    return {at, is_place(p) ? p : no_place};
  }
  CurvePoint middle(const CurvePoint& a, const CurvePoint& b) { return look(a.at + (b.at - a.at) / 2); }

  // Returns whether both points are beyond the same side of the box, and far from it.
  bool outside(const CurvePoint& a, const CurvePoint& b) const {
    for (int i = 0; i < 2; ++i)
      if ((a.place[i] > s_.half[i] && b.place[i] > s_.half[i]) ||
          (a.place[i] < -s_.half[i] && b.place[i] < -s_.half[i]))
        return true;
    return false;
  }

  void pen_up() {
    if (!out_.empty() && !out_.back().breaks()) out_.push_back({out_.back().at, no_place});
  }

  // Adds what comes after `a`, up to `b`.
  void between(const CurvePoint& a, const CurvePoint& b, int depth) {
    if (a.breaks() && b.breaks() && depth >= 3) return;
    if (left_ <= 0) {
      if (!b.breaks()) out_.push_back(b);
      return;
    }
    if (a.breaks() != b.breaks()) return edge(a, b);
    const CurvePoint m = middle(a, b);
    if (a.breaks()) return between(a, m, depth + 1), between(m, b, depth + 1);
    if (m.breaks()) return between(a, m, depth + 1), between(m, b, depth + 1);
    const bool hidden = depth >= 2 && outside(a, m) && outside(m, b);
    if (hidden) return out_.push_back(b);
    const CurvePoint q = look(a.at + 0.27 * (b.at - a.at));
    // At a jump the middle is near one of the ends, however straight that looks.
    const double aside = length(m.place - 0.5 * (a.place + b.place));
    const bool even = aside < s_.tolerance + 0.3 * length(b.place - a.place);
    bool straight = even && !q.breaks() && off_chord(m.place, a.place, b.place) < s_.tolerance &&
                    off_chord(q.place, a.place, b.place) < s_.tolerance;
    // A wave may cross the chord at two of these places.
    if (straight && depth > 0) {
      const CurvePoint r = look(a.at + 0.81 * (b.at - a.at));
      straight = !r.breaks() && off_chord(r.place, a.place, b.place) < s_.tolerance;
    }
    if (straight && depth > 0) return out_.push_back(m), out_.push_back(b);
    if (depth < deepest_halving) return between(a, m, depth + 1), between(m, b, depth + 1);
    if (jumps(a, b)) pen_up();
    out_.push_back(b);
  }

  // Halves towards the larger difference. At a jump it stays, however near the two points are.
  bool jumps(CurvePoint a, CurvePoint b) {
    const double first = length(b.place - a.place);
    if (first < 4 * s_.tolerance) return false;
    for (int i = 0; i < deepest_search; ++i) {
      const CurvePoint m = middle(a, b);
      if (m.breaks() || m.at == a.at || m.at == b.at) return true;
      const double left = length(m.place - a.place), right = length(b.place - m.place);
      if (std::max(left, right) < s_.tolerance) return false;
      (left > right ? b : a) = m;
    }
    return true;
  }

  // One of the points is outside the domain: finds its end.
  void edge(CurvePoint a, CurvePoint b) {
    const bool enters = a.breaks();
    const CurvePoint first = a, last = b;
    for (int i = 0; i < deepest_search; ++i) {
      const CurvePoint m = middle(a, b);
      if (m.at == a.at || m.at == b.at) break;
      (m.breaks() == a.breaks() ? a : b) = m;
    }
    if (enters) {
      pen_up();
      out_.push_back(b);
      if (b.at != last.at) between(b, last, 1);
    } else {
      if (a.at != first.at) between(first, a, 1);
      pen_up();
    }
  }

  const CurveSampling& s_;
  int left_;
  std::vector<CurvePoint> out_;
};

// Cuts a segment to the box; false if none of it is inside.
bool cut(Vec3 a, Vec3 b, Vec3 half, double& from, double& to) {
  from = 0, to = 1;
  for (int i = 0; i < 2; ++i) {
    const double d = b[i] - a[i];
    for (const double side : {-half[i], half[i]}) {
      const double beyond = side > 0 ? a[i] - side : side - a[i], way = side > 0 ? d : -d;
      if (way == 0 && beyond > 0) return false;
      if (way > 0) to = std::min(to, -beyond / way);
      if (way < 0) from = std::max(from, -beyond / way);
    }
  }
  return from < to || (from == to && a.x == b.x && a.y == b.y);
}

CurvePoint mixed(const CurvePoint& a, const CurvePoint& b, double u) {
  return {a.at + u * (b.at - a.at), (1 - u) * a.place + u * b.place};
}

}  // namespace

bool CurvePoint::breaks() const { return !is_place(place); }

std::vector<CurvePoint> sampled(const CurveSampling& s) {
  if (!(std::isfinite(s.from) && std::isfinite(s.to)) || s.from == s.to) return {};
  return Sampler(s).all();
}

std::vector<CurvePoint> clipped(const std::vector<CurvePoint>& all, Vec3 half) {
  std::vector<CurvePoint> out;
  const auto pen_up = [&](double at) {
    if (!out.empty() && !out.back().breaks()) out.push_back({at, no_place});
  };
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    const CurvePoint &a = all[i], &b = all[i + 1];
    double from = 0, to = 1;
    if (a.breaks() || b.breaks() || !cut(a.place, b.place, half, from, to)) {
      pen_up(a.at);
      continue;
    }
    const CurvePoint first = from > 0 ? mixed(a, b, from) : a;
    if (from > 0) pen_up(a.at);
    if (out.empty() || out.back().breaks()) out.push_back(first);
    out.push_back(to < 1 ? mixed(a, b, to) : b);
    if (to < 1) pen_up(b.at);
  }
  if (!out.empty() && out.back().breaks()) out.pop_back();
  return out;
}

std::vector<CurvePoint> level_lines(const std::function<double(double, double)>& at, int columns, int rows,
                                    const std::function<Vec3(double, double)>& place) {
  const auto wide = static_cast<std::size_t>(columns + 1);
  std::vector<double> values(wide * static_cast<std::size_t>(rows + 1));
  const auto value = [&](int i, int j) -> double& {
    return values[static_cast<std::size_t>(j) * wide + static_cast<std::size_t>(i)];
  };
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      value(i, j) = at(static_cast<double>(i) / columns, static_cast<double>(j) / rows);
  // Returns the crossing on a side, or a break if it is a pole.
  const auto crossing = [&](double x0, double y0, double v0, double x1, double y1) {
    const double begin_x = x0, begin_y = y0, end_x = x1, end_y = y1;
    double low = 0, high = 1, v_low = v0;
    for (int k = 0; k < 24; ++k) {
      const double m = (low + high) / 2, v = at(begin_x + m * (end_x - begin_x), begin_y + m * (end_y - begin_y));
      if ((v < 0) == (v_low < 0))
        low = m, v_low = v;
      else
        high = m;
    }
    if (std::abs(v_low) > 1e3 * std::abs(v0) + 1e3) return no_place;
    return place(begin_x + low * (end_x - begin_x), begin_y + low * (end_y - begin_y));
  };
  std::vector<CurvePoint> out;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::array<std::array<int, 2>, 4> corner{{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
      std::vector<Vec3> found;
      bool defined = true;
      for (std::size_t k = 0; k < 4; ++k) defined = defined && std::isfinite(value(corner[k][0], corner[k][1]));
      for (std::size_t k = 0; k < 4 && defined; ++k) {
        const auto &a = corner[k], &b = corner[(k + 1) % 4];
        const double va = value(a[0], a[1]), vb = value(b[0], b[1]);
        if ((va < 0) == (vb < 0)) continue;
        const Vec3 p = crossing(static_cast<double>(a[0]) / columns, static_cast<double>(a[1]) / rows, va,
                                static_cast<double>(b[0]) / columns, static_cast<double>(b[1]) / rows);
        if (is_place(p)) found.push_back(p);
      }
      for (std::size_t k = 0; k + 1 < found.size(); k += 2) {
        if (!out.empty()) out.push_back({0, no_place});
        out.push_back({0, found[k]}), out.push_back({0, found[k + 1]});
      }
    }
  return out;
}

}  // namespace betwixt

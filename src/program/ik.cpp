// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "program/ik.h"

#include <algorithm>
#include <cmath>

#include "track/turns.h"

namespace betwixt {
namespace {

Vec3 across(Vec3 v, Vec3 along) { return v - dot(v, along) * along; }

// Returns a unit vector perpendicular to `along`, nearest to `wanted`, or to a fixed axis if `wanted` is parallel.
Vec3 sideways(Vec3 along, Vec3 wanted) {
  for (const Vec3 v : {wanted, Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}})
    if (const Vec3 side = across(v, along); length(side) > 1e-6 * length(v)) return normalize(side);
  return {};
}

class Chain {
 public:
  explicit Chain(std::vector<Vec3> points) : at(std::move(points)) {
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
      bones_.push_back(length(at[i + 1] - at[i]));
      total_ += bones_.back();
    }
    longest_ = static_cast<std::size_t>(std::max_element(bones_.begin(), bones_.end()) - bones_.begin());
  }

  double total() const { return total_; }
  // The smallest distance from the root to the end.
  double nearest() const { return std::max(0.0, 2 * bones_[longest_] - total_); }
  Vec3 span() const { return at.back() - at.front(); }

  void turn(Quat q, std::size_t first, std::size_t last) {  // about the joint before `first`
    const Mat4 m = rotation(q);
    const Vec3 centre = at[first - 1];
    for (std::size_t i = first; i <= last; ++i) at[i] = centre + transform_vector(m, at[i] - centre);
  }
  void turn(Quat q) { turn(q, 1, at.size() - 1); }

  // Returns the direction of the chain's bend, or zero if it is straight.
  Vec3 bend(Vec3 along) const {
    Vec3 sum;
    for (std::size_t i = 1; i + 1 < at.size(); ++i) sum = sum + across(at[i] - at.front(), along);
    return length(sum) > 1e-9 * total_ ? normalize(sum) : Vec3{};
  }

  void two_bones(Vec3 along, double far, Vec3 side) {
    const double a = bones_[0], b = bones_[1];
    const double x = far > 0 ? std::clamp((a * a - b * b + far * far) / (2 * far), -a, a) : 0;
    at[1] = at[0] + x * along + std::sqrt(std::max(0.0, a * a - x * x)) * side;
    at[2] = at[0] + far * along;
  }

  // Bends a straight chain into an arc.
  void bow(Vec3 along, Vec3 side) {
    const auto n = static_cast<double>(bones_.size());
    for (std::size_t i = 0; i < bones_.size(); ++i) {
      const double angle = 0.5 * (1 - (2 * static_cast<double>(i) + 1) / n);
      at[i + 1] = at[i] + bones_[i] * (std::cos(angle) * along + std::sin(angle) * side);
    }
    turn(shortest_turn(span(), along));
  }

  void fabrik(Vec3 goal) {
    constexpr int most = 256;
    const Vec3 start = at.front();
    const std::size_t n = bones_.size();
    for (int i = 0; i < most && length(at.back() - goal) > 1e-13 * total_; ++i) {
      at.back() = goal;
      for (std::size_t k = n; k-- > 0;) at[k] = at[k + 1] + bones_[k] * normalize(at[k] - at[k + 1]);
      at.front() = start;
      for (std::size_t k = 0; k < n; ++k) at[k + 1] = at[k] + bones_[k] * normalize(at[k + 1] - at[k]);
    }
  }

  // Moves the end to a distance in a direction: all bones turn by one fraction towards directions that lengthen or
  // shorten the chain. Finds the fraction by bisection.
  void opened(Vec3 along, double far, bool folded) {
    std::vector<Vec3> before;
    std::vector<Quat> turns;
    for (std::size_t i = 0; i < bones_.size(); ++i) {
      before.push_back(at[i + 1] - at[i]);
      turns.push_back(shortest_turn(before[i], folded && i != longest_ ? -along : along));
    }
    const auto by = [&](double s) {
      for (std::size_t i = 0; i < bones_.size(); ++i)
        at[i + 1] = at[i] + transform_vector(rotation(power(turns[i], s)), before[i]);
      return length(span());
    };
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double s = (low + high) / 2;
      ((by(s) < far) != folded ? low : high) = s;
    }
    by(high);
    turn(shortest_turn(span(), along));
  }

  // The same by bending one joint, as a triangle. Returns false if no joint can.
  bool bent_once(Vec3 along, double far, Vec3 side) {
    std::size_t best = 0;
    double room = 0;
    for (std::size_t k = 1; k < bones_.size(); ++k) {
      const double a = length(at[k] - at.front()), b = length(at.back() - at[k]);
      const double spare = std::min(far - std::abs(a - b), a + b - far);
      if (spare > room) room = spare, best = k;
    }
    if (best == 0) return false;
    Chain outline({at.front(), at[best], at.back()});
    const Vec3 off = across(at[best] - at.front(), along);
    outline.two_bones(along, far, length(off) > 1e-9 * total_ ? normalize(off) : side);
    turn(shortest_turn(at[best] - at.front(), outline.at[1] - outline.at[0]));
    turn(shortest_turn(at.back() - at[best], outline.at[2] - outline.at[1]), best + 1, at.size() - 1);
    return true;
  }

  void many_bones(Vec3 along, double far, Vec3 side) {
    const double slight = 1e-13 * total_;
    if (length(span()) > far + slight && bend(along) == Vec3{}) bow(along, side);
    if (length(span()) > far + slight) fabrik(at.front() + far * along);
    if (length(span()) < far - slight)
      opened(along, far, false);
    else if (length(span()) > far + slight && !bent_once(along, far, side) && nearest() > 0)
      opened(along, far, true);
    turn(shortest_turn(span(), along));
  }

  std::vector<Vec3> at;

 private:
  std::vector<double> bones_;
  double total_ = 0;
  std::size_t longest_ = 0;
};

}  // namespace

Quat shortest_turn(Vec3 from, Vec3 to) {
  const double a = length(from), b = length(to);
  if (!(a > 0) || !(b > 0)) return {};
  const Vec3 u = (1 / a) * from, v = (1 / b) * to;
  if (const double d = dot(u, v); d > -1 + 1e-12) {
    const Vec3 axis = cross(u, v);
    return normalize(Quat{1 + d, axis.x, axis.y, axis.z});
  }
  const Vec3 axis = sideways(u, {0, 0, 1});
  return {0, axis.x, axis.y, axis.z};
}

std::vector<Vec3> solve_ik(std::vector<Vec3> points, const IkGoal& r) {
  if (points.size() < 2) return points;
  Chain chain(std::move(points));
  const Vec3 start = chain.at.front(), end = chain.at.back();
  const Vec3 was = end - start, way = was + r.share * (r.goal - end);
  const double slight = 1e-12 * chain.total();
  if (!(chain.total() > 0)) return chain.at;
  const Vec3 along = normalize(length(way) > slight ? way : length(was) > slight ? was : chain.at[1] - start);
  const double far = std::clamp(length(way), chain.nearest(), chain.total());
  if (length(was) > slight) chain.turn(shortest_turn(was, along));
  Vec3 side = chain.bend(along);
  if (side == Vec3{}) side = sideways(along, r.bend);
  if (chain.at.size() == 3) chain.two_bones(along, far, side);
  if (chain.at.size() > 3) chain.many_bones(along, far, side);
  if (!r.pole || chain.at.size() < 3) return chain.at;
  const Vec3 bent = chain.bend(along), wanted = across(*r.pole - start, along);
  if (bent == Vec3{} || !(length(wanted) > slight)) return chain.at;
  const double angle = std::atan2(dot(along, cross(bent, wanted)), dot(bent, wanted));
  chain.turn(axis_angle(along, r.share * angle));
  return chain.at;
}

}  // namespace betwixt

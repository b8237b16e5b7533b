// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Plain code to compare with: what a programmer would write for only these scenes, one number after the other. Tracks
// have precomputed cubics and a cursor that moves forward; other times are found by bisection. The matrices have the
// conventions of Betwixt, so that values can be compared.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "betwixt/math.h"

namespace plain {

using betwixt::Mat4;
using betwixt::Vec3;

class Track {
 public:
  void add(double frame, Vec3 value) {
    frames_.push_back(frame);
    values_.push_back({value.x, value.y, value.z});
  }
  // Interpolates smoothly: each tangent is that of the parabola through a key and its neighbours.
  void compile() {
    segments_.resize(frames_.size() - 1);
    for (std::size_t k = 0; k < segments_.size(); ++k) compile(k);
  }
  void change(std::size_t key, Vec3 value) {
    values_[key] = {value.x, value.y, value.z};
    for (std::size_t k = key < 2 ? 0 : key - 2; k < std::min(key + 2, segments_.size()); ++k) compile(k);
  }
  // `frame` must be between the first and the last key, and not before the frame of the last call.
  Vec3 forward(double frame) {
    while (now_ + 1 < segments_.size() && frames_[now_ + 1] <= frame) ++now_;
    return at(now_, frame);
  }
  Vec3 seek(double frame) const {
    const auto after = std::upper_bound(frames_.begin() + 1, frames_.end() - 1, frame);
    return at(static_cast<std::size_t>(after - frames_.begin()) - 1, frame);
  }
  void rewind() { now_ = 0; }

 private:
  using Numbers = std::array<double, 3>;
  struct Segment {
    double per_frame = 1;
    std::array<std::array<double, 4>, 3> cubic;
  };
  void compile(std::size_t k) {
    const bool first = k == 0, last = k + 2 == frames_.size();
    const double h = frames_[k + 1] - frames_[k], h0 = first ? h : frames_[k] - frames_[k - 1],
                 h2 = last ? h : frames_[k + 2] - frames_[k + 1];
    segments_[k].per_frame = 1 / h;
    for (std::size_t i = 0; i < 3; ++i) {
      const double b = values_[k][i], e = values_[k + 1][i], a = first ? 2 * b - e : values_[k - 1][i],
                   d = last ? 2 * e - b : values_[k + 2][i];
      const double m1 = ((b - a) / h0 * h * h + (e - b) * h0) / (h0 + h),
                   m2 = ((e - b) * h2 + (d - e) / h2 * h * h) / (h + h2);
      segments_[k].cubic[i] = {b, m1, 3 * (e - b) - 2 * m1 - m2, m1 + m2 - 2 * (e - b)};
    }
  }
  Vec3 at(std::size_t k, double frame) const {
    const Segment& s = segments_[k];
    const double u = (frame - frames_[k]) * s.per_frame;
    const auto number = [&](std::size_t i) {
      const auto& c = s.cubic[i];
      return c[0] + u * (c[1] + u * (c[2] + u * c[3]));
    };
    return {number(0), number(1), number(2)};
  }

  std::vector<double> frames_;
  std::vector<Numbers> values_;
  std::vector<Segment> segments_;
  std::size_t now_ = 0;
};

// Rotations about the object's own x axis, then y, then z, in radians.
inline Mat4 placed(Vec3 position, Vec3 angles, Vec3 scale) {
  const double sx = std::sin(angles.x), cx = std::cos(angles.x), sy = std::sin(angles.y), cy = std::cos(angles.y),
               sz = std::sin(angles.z), cz = std::cos(angles.z);
  Mat4 m;
  m.m = {cy * cz * scale.x,
         (cx * sz + sx * sy * cz) * scale.x,
         (sx * sz - cx * sy * cz) * scale.x,
         0,
         -cy * sz * scale.y,
         (cx * cz - sx * sy * sz) * scale.y,
         (sx * cz + cx * sy * sz) * scale.y,
         0,
         sy * scale.z,
         -sx * cy * scale.z,
         cx * cy * scale.z,
         0,
         position.x,
         position.y,
         position.z,
         1};
  return m;
}

struct Object {
  std::array<Track, 3> tracks;  // position, rotation, scale
  Mat4 forward(double frame) {
    return placed(tracks[0].forward(frame), tracks[1].forward(frame), tracks[2].forward(frame));
  }
  Mat4 seek(double frame) const { return placed(tracks[0].seek(frame), tracks[1].seek(frame), tracks[2].seek(frame)); }
};

// Returns the product of two affine matrices.
inline Mat4 product(const Mat4& a, const Mat4& b) {
  Mat4 r = linear_product(a, b);
  const Vec3 at = transform_point(a, translation_of(b));
  r.m[12] = at.x, r.m[13] = at.y, r.m[14] = at.z;
  return r;
}

// A tree of nodes in which each parent comes before its children. Updates the world matrices of nodes that moved, and
// of all nodes below them.
struct Nodes {
  std::vector<int> parent;  // -1 for no parent
  std::vector<Mat4> own, world;
  std::vector<char> moved;
  void update() {
    for (std::size_t i = 0; i < own.size(); ++i) {
      const int above = parent[i];
      if (above >= 0 && moved[static_cast<std::size_t>(above)]) moved[i] = 1;
      if (moved[i]) world[i] = above < 0 ? own[i] : product(world[static_cast<std::size_t>(above)], own[i]);
    }
    std::fill(moved.begin(), moved.end(), 0);
  }
};

}  // namespace plain

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "export/parts.h"

#include <algorithm>

#include "algebra/matrix_parts.h"

namespace betwixt {
namespace {

void put_column(Mat4& m, int c, Vec3 v) { m(0, c) = v.x, m(1, c) = v.y, m(2, c) = v.z; }

// Returns a direction perpendicular to a unit vector.
Vec3 across(Vec3 v) { return normalize(cross(v, std::abs(v.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})); }

// Completes the columns to a rotation: columns without length become perpendicular to the others.
void complete(Mat4& m, const bool (&known)[3]) {
  const int count = known[0] + known[1] + known[2];
  if (count == 0) return put_column(m, 0, {1, 0, 0}), put_column(m, 1, {0, 1, 0}), put_column(m, 2, {0, 0, 1});
  bool have[3] = {known[0], known[1], known[2]};
  if (count == 1) {
    const int one = known[0] ? 0 : known[1] ? 1 : 2, next = (one + 1) % 3;
    put_column(m, next, across(column(m, one)));
    have[next] = true;
  }
  for (int c = 0; c < 3; ++c)
    if (!have[c]) put_column(m, c, normalize(cross(column(m, (c + 1) % 3), column(m, (c + 2) % 3))));
}

// Returns the axes of a symmetric matrix, as columns of a rotation (Jacobi).
Mat4 axes_of(Mat4 a) {
  Mat4 axes;
  for (int round = 0; round < 24; ++round)
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        if (std::abs(a(p, q)) < 1e-300) continue;
        const double angle = 0.5 * std::atan2(2 * a(p, q), a(q, q) - a(p, p)), c = std::cos(angle), s = std::sin(angle);
        Mat4 turn;
        turn(p, p) = c, turn(p, q) = s, turn(q, p) = -s, turn(q, q) = c;
        Mat4 back = turn;
        back(p, q) = -s, back(q, p) = s;
        a = back * a * turn;
        axes = axes * turn;
      }
  return axes;
}

}  // namespace

Parts parts_of(const Mat4& m) {
  Parts p;
  p.way = translation_of(m);
  Mat4 turn;
  bool known[3];
  for (int c = 0; c < 3; ++c) {
    p.growth[c] = length(column(m, c));
    known[c] = p.growth[c] > 1e-12;
    put_column(turn, c, normalize(column(m, c)));
  }
  if (determinant(m) < 0) p.growth.x = -p.growth.x, put_column(turn, 0, -column(turn, 0));
  complete(turn, known);
  p.turn = from_matrix(turn);
  return p;
}

bool is_sheared(const Mat4& m) {
  for (int c = 0; c < 3; ++c) {
    const Vec3 a = column(m, c), b = column(m, (c + 1) % 3);
    if (std::abs(dot(a, b)) > 1e-6 * length(a) * length(b)) return true;
  }
  return false;
}

TurnedParts turned_parts(const Mat4& m, const TurnedParts& near) {
  Mat4 squared;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) squared(i, k) = dot(column(m, i), column(m, k));
  const Mat4 axes = axes_of(squared), wanted = rotation(conjugate(near.inner));
  // Of the six orders and the signs of the axes, take the nearest.
  static constexpr int orders[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  double best = -1;
  Mat4 chosen;
  for (const auto& order : orders) {
    double sum = 0;
    Mat4 tried;
    for (int c = 0; c < 3; ++c) {
      const Vec3 axis = column(axes, order[c]);
      const double along = dot(axis, column(wanted, c));
      sum += std::abs(along);
      put_column(tried, c, along < 0 ? -axis : axis);
    }
    if (determinant(tried) > 0 && sum > best) best = sum, chosen = tried;
  }
  if (best < 0) chosen = axes;
  TurnedParts p;
  p.way = translation_of(m);
  Mat4 outer;
  bool known[3];
  for (int c = 0; c < 3; ++c) {
    const Vec3 stretched = transform_vector(m, column(chosen, c));
    p.growth[c] = length(stretched);
    known[c] = p.growth[c] > 1e-12;
    put_column(outer, c, normalize(stretched));
  }
  if (determinant(m) < 0) p.growth.x = -p.growth.x, put_column(outer, 0, -column(outer, 0));
  complete(outer, known);
  p.outer = from_matrix(outer);
  p.inner = conjugate(from_matrix(chosen));
  if (dot(p.outer, near.outer) < 0) p.outer = -p.outer;
  if (dot(p.inner, near.inner) < 0) p.inner = -p.inner;
  return p;
}

TurnedParts blended(const TurnedParts& a, const TurnedParts& b, double t) {
  return {algebra::mix(a.way, b.way, t), algebra::mix(a.growth, b.growth, t), algebra::short_way(a.outer, b.outer, t),
          algebra::short_way(a.inner, b.inner, t)};
}

Mat4 put_together(const TurnedParts& p) {
  return translation(p.way) * rotation(p.outer) * scaling(p.growth) * rotation(p.inner);
}

double apart(const Mat4& a, const Mat4& b) {
  double most = 0;
  for (std::size_t i = 0; i < 16; ++i) most = std::max(most, std::abs(a.m[i] - b.m[i]));
  return most;
}

}  // namespace betwixt

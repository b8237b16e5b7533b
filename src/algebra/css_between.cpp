// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Computes what a browser shows between two lists of CSS transforms, and the sum of two lists.
#include <algorithm>

#include "algebra/matrix_parts.h"
#include "algebra/rotation.h"
#include "algebra/text.h"
#include "betwixt/css.h"

namespace betwixt {
namespace {

using CssKind = CssFunction::Kind;
using algebra::Turns;

CssFunction of_kind(CssKind kind) {
  CssFunction f;
  f.kind = kind;
  return f;
}
CssFunction of_matrix(const Mat4& m) {
  CssFunction f = of_kind(CssKind::matrix);
  f.matrix = m;
  return f;
}
// Returns the function of the same kind that does nothing.
CssFunction idle(const CssFunction& like) {
  CssFunction f = of_kind(like.kind);
  if (like.kind == CssKind::scale) f.by = {1, 1, 1};
  return f;
}

Turns turns_of(const CssFunction& f) { return algebra::turns_of(f.angle, f.angle_rest); }

Mat4 matrix_of(const CssFunction& f) {
  Mat4 m;
  switch (f.kind) {
    case CssKind::translate:
      return translation(f.by);
    case CssKind::scale:
      return scaling(f.by);
    case CssKind::rotate:
      return algebra::rotated(algebra::turn(turns_of(f).part), f.axis);
    case CssKind::skew:
    case CssKind::skew_x:
    case CssKind::skew_y:
      m(0, 1) = std::tan(f.by.x), m(1, 0) = std::tan(f.by.y);
      return m;
    case CssKind::perspective:
      m(3, 2) = -f.nearness;
      return m;
    case CssKind::matrix:
      break;
  }
  return f.matrix;
}
Mat4 product_from(const CssList& list, std::size_t first) {
  Mat4 m;
  for (std::size_t i = first; i < list.size(); ++i) m = m * matrix_of(list[i]);
  return m;
}

// Returns the axis of both rotations, or nullopt if they have two. A rotation by zero takes the axis of the other.
std::optional<Vec3> common_axis(const CssFunction& a, const CssFunction& b) {
  if (b.angle == 0) return a.axis;
  if (a.angle == 0 || length(normalize(a.axis) - normalize(b.axis)) <= 1e-12) return b.axis;
  return std::nullopt;
}
Quat quaternion(const CssFunction& f) {
  const algebra::Turn half = algebra::turn(turns_of(f).part / 2);
  const Vec3 a = half.sine * normalize(f.axis);
  return {half.cosine, a.x, a.y, a.z};
}

// Returns nullopt if one of them is singular.
std::optional<Mat4> mixed_matrices(const Mat4& a, const Mat4& b, double t) {
  const bool plane = algebra::in_plane(a) && algebra::in_plane(b);
  const auto from = algebra::taken_apart(a, plane), to = algebra::taken_apart(b, plane);
  if (!from || !to) return std::nullopt;
  return algebra::put_together(algebra::mixed(*from, *to, t, plane));
}

// Interpolates two functions of one kind.
std::optional<Mat4> pair_between(const CssFunction& a, const CssFunction& b, double t) {
  if (a.kind == CssKind::matrix) return mixed_matrices(a.matrix, b.matrix, t);
  CssFunction now = of_kind(a.kind);
  now.by = algebra::mix(a.by, b.by, t);
  now.nearness = std::max(0.0, std::lerp(a.nearness, b.nearness, t));  // the eye has no negative distance
  if (a.kind != CssKind::rotate) return matrix_of(now);
  const auto axis = common_axis(a, b);
  if (!axis) return rotation(algebra::short_way(quaternion(a), quaternion(b), t));
  const Turns turns = turns_of(a) + algebra::scaled(turns_of(b) - turns_of(a), t);
  return algebra::rotated(algebra::turn(turns.part), *axis);
}

// Pairs the functions, padded with functions that do nothing, as long as both are of one kind. The rest of each list is
// a matrix.
struct Matched {
  std::vector<std::pair<CssFunction, CssFunction>> pairs;
  std::size_t mixed = 0;
};
Matched matched(const CssList& a, const CssList& b) {
  Matched m;
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const CssFunction one = i < a.size() ? a[i] : idle(b[i]), other = i < b.size() ? b[i] : idle(a[i]);
    if (one.kind != other.kind) {
      m.pairs.emplace_back(of_matrix(product_from(a, i)), of_matrix(product_from(b, i)));
      m.mixed = i + 1;
      break;
    }
    m.pairs.emplace_back(one, other);
  }
  return m;
}

CssFunction added_turns(const CssFunction& a, const CssFunction& b) {
  CssFunction both = a;
  if (const auto axis = common_axis(a, b)) {
    const algebra::Angle all = algebra::angle_of(turns_of(a) + turns_of(b));
    both.axis = *axis, both.angle = all.radians, both.angle_rest = all.rest;
    return both;
  }
  const Quat q = quaternion(a) * quaternion(b);
  const Vec3 v{q.x, q.y, q.z};
  both.axis = normalize(v), both.angle = 2 * std::atan2(length(v), q.w), both.angle_rest = 0;
  return both;
}

// Returns nullopt if one of them is singular.
std::optional<CssFunction> added(const CssFunction& a, const CssFunction& b) {
  CssFunction both = a;
  both.by = a.by + b.by;
  both.nearness = a.nearness + b.nearness;
  if (a.kind == CssKind::rotate) return added_turns(a, b);
  if (a.kind == CssKind::scale)
    for (int i = 0; i < 3; ++i) both.by[i] = algebra::added_growth(a.by[i], b.by[i]);
  if (a.kind != CssKind::matrix) return both;
  const bool plane = algebra::in_plane(a.matrix) && algebra::in_plane(b.matrix);
  const auto under = algebra::taken_apart(a.matrix, plane), over = algebra::taken_apart(b.matrix, plane);
  if (!under || !over) return std::nullopt;
  both.matrix = algebra::put_together(algebra::added(*under, *over));
  return both;
}

}  // namespace

Mat4 matrix_of(const CssList& list) { return product_from(list, 0); }

CssBetween css_between(const CssList& from, const CssList& to, double t) {
  CssBetween now;
  const Matched both = matched(from, to);
  now.mixed = both.mixed;
  for (std::size_t i = 0; i < both.pairs.size(); ++i) {
    const auto& [a, b] = both.pairs[i];
    if (a.kind == CssKind::rotate && now.short_way == 0 && !common_axis(a, b)) now.short_way = i + 1;
    const auto m = pair_between(a, b, t);
    if (!m) return {matrix_of(t < 0.5 ? from : to), 0, 0, true};
    now.matrix = now.matrix * *m;
  }
  return now;
}

CssList css_accumulated(const CssList& under, const CssList& over) {
  CssList list;
  for (const auto& [a, b] : matched(under, over).pairs) {
    const auto both = added(a, b);
    if (!both) return over;
    list.push_back(*both);
  }
  return list;
}

}  // namespace betwixt

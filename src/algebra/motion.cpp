// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "algebra/rotation.h"
#include "betwixt/algebra.h"

namespace betwixt {
namespace {

using Kind = Factor::Kind;
using Law = Factor::Law;

constexpr const char* axes[] = {"x", "y", "z"};
constexpr const char* letters[] = {"T", "R", "S"};

// Returns the scale at fraction t; exact at t = 1.
double scale_at(double total, Law law, double t) {
  return law == Law::linear ? std::lerp(1.0, total, t) : std::pow(total, t);
}
// Returns the same minus 1, exact even if that is tiny.
double growth_at(double total, Law law, double t) {
  if (law == Law::linear || t == 1) return (total - 1) * t;
  return std::expm1(t * std::log(total));
}
// Multiplies with 0 times infinity = 0.
double times(double a, double b) { return a == 0 || b == 0 ? 0 : a * b; }

Mat4 scaled(const Factor& f, double t) {
  Mat4 m;
  for (int c = 0; c < 3; ++c) {
    m(c, c) = scale_at(f.by[c], f.law, t);
    m(c, 3) = -times(growth_at(f.by[c], f.law, t), f.centre[c]);
  }
  return m;
}

algebra::Turns turns_of(const Factor& f) { return algebra::turns_of(f.angle, f.angle_rest); }
// Returns fraction t of a rotation. If the angle is not small, `phase` gives its end within a turn.
template <class Phase>
algebra::Turn turned(const Factor& f, double t, const Phase& phase) {
  const double angle = f.angle * t;
  return std::abs(angle) <= pi / 4 ? algebra::small_turn(angle) : algebra::turn(phase());
}

Mat4 matrix(const Factor& f, double t) {
  if (f.kind == Kind::translate) return translation(t * f.by);
  if (f.kind == Kind::scale) return scaled(f, t);
  return algebra::rotated(turned(f, t, [&] { return algebra::phase(turns_of(f), t); }), f.axis, f.centre);
}

// Returns an element of the product of affine matrices. An infinite element affects no other, and the result is
// infinite rather than NaN.
double entry(const Mat4& a, const Mat4& b, int row, int column) {
  const double own = column == 3 ? a(row, 3) : 0;
  const double sum = a(row, 0) * b(0, column) + a(row, 1) * b(1, column) + a(row, 2) * b(2, column) + own;
  if (std::isfinite(sum)) return sum;
  double kept = own;
  for (int i = 0; i < 3; ++i) kept += times(a(row, i), b(i, column));
  return std::isnan(kept) ? std::numeric_limits<double>::infinity() : kept;
}
Mat4 after(const Mat4& a, const Mat4& b) {
  Mat4 r;
  for (int i = 0; i < 3; ++i)
    for (int c = 0; c < 4; ++c) r(i, c) = entry(a, b, i, c);
  return r;
}

Error about_factor(const Motion& motion, std::size_t i, std::string_view what, std::string_view hint = {}) {
  const Factor& f = motion.factors[i];
  return fail(ErrorCode::range, fmt::format("factor {}, {}: {}", i + 1, letters[static_cast<int>(f.kind)], what),
              std::string(hint));
}

}  // namespace

Factor translate_by(Vec3 way) {
  Factor f;
  f.by = way;
  return f;
}

Factor rotate_by(double angle, Vec3 centre, Vec3 axis) {
  Factor f;
  f.kind = Kind::rotate, f.angle = angle, f.centre = centre, f.axis = axis;
  return f;
}

Factor scale_by(Vec3 factors, Vec3 centre, Law law) {
  Factor f;
  f.kind = Kind::scale, f.by = factors, f.centre = centre, f.law = law;
  return f;
}

Status check(const Motion& motion) {
  for (std::size_t i = 0; i < motion.factors.size(); ++i) {
    const Factor& f = motion.factors[i];
    const auto endless = [&](Vec3 v, std::string_view name) -> Status {
      for (int c = 0; c < 3; ++c)
        if (!std::isfinite(v[c])) return about_factor(motion, i, fmt::format("its {} {} is not finite", name, axes[c]));
      return Nothing{};
    };
    if (f.kind == Kind::translate) {
      if (auto bad = endless(f.by, "translation along"); !bad) return bad;
      continue;
    }
    if (auto bad = endless(f.centre, "centre's"); !bad) return bad;
    if (f.kind == Kind::rotate) {
      if (!std::isfinite(f.angle) || !std::isfinite(f.angle_rest))
        return about_factor(motion, i, "its angle is not finite");
      if (!(std::abs(f.angle) < 2 * pi * algebra::most_turns))
        return about_factor(motion, i, fmt::format("its angle has more than {} turns", algebra::most_turns));
      if (auto bad = endless(f.axis, "axis'"); !bad) return bad;
      if (length(f.axis) == 0) return about_factor(motion, i, "its axis has no direction");
      continue;
    }
    if (auto bad = endless(f.by, "factor along"); !bad) return bad;
    for (int c = 0; c < 3; ++c)
      if (f.law == Law::exponential && !(f.by[c] > 0))
        return about_factor(motion, i,
                            fmt::format("a scaling by {} along {} has no in-between values", f.by[c], axes[c]),
                            "use factors greater than 0, or the linear law: S(… linear)");
  }
  return Nothing{};
}

bool is_planar(const Motion& motion) {
  return std::all_of(motion.factors.begin(), motion.factors.end(), [](const Factor& f) {
    if (f.kind == Kind::translate) return f.by.z == 0;
    return f.kind == Kind::scale || (f.axis.x == 0 && f.axis.y == 0);
  });
}

Mat4 at(const Motion& motion, double t) {
  Mat4 product;
  for (const Factor& f : motion.factors) product = after(product, matrix(f, t));
  return product;
}

Result<Mat4> frame(const Motion& motion, std::int64_t k, std::int64_t steps) {
  if (steps < 1)
    return fail(ErrorCode::range, fmt::format("the number of steps must be at least 1, not {}", steps),
                "frame 0 is the start and frame 1 the end");
  // k / steps is rounded; the remainder matters for a motion of many turns.
  Mat4 product;
  const double t = static_cast<double>(k) / static_cast<double>(steps);
  for (const Factor& f : motion.factors) {
    if (f.kind != Kind::rotate) {
      product = after(product, matrix(f, t));
      continue;
    }
    const algebra::Turn part = turned(f, t, [&] { return algebra::phase(turns_of(f), k, steps); });
    product = after(product, algebra::rotated(part, f.axis, f.centre));
  }
  return product;
}

Result<Motion> inverse(const Motion& motion) {
  Motion back;
  for (std::size_t i = motion.factors.size(); i-- > 0;) {
    Factor f = motion.factors[i];
    if (f.kind == Kind::scale && f.law == Law::linear && f.by != Vec3{1, 1, 1})
      return about_factor(motion, i, "the inverse of a scaling by the linear law is not a motion",
                          "with the exponential law every motion has an inverse");
    if (f.kind == Kind::scale) f.by = {1 / f.by.x, 1 / f.by.y, 1 / f.by.z};
    if (f.kind == Kind::scale && !finite(f.by))
      return about_factor(motion, i, "the inverse of this scaling is not finite");
    if (f.kind == Kind::translate) f.by = -f.by;
    f.angle = -f.angle, f.angle_rest = -f.angle_rest;
    back.factors.push_back(std::move(f));
  }
  return back;
}

}  // namespace betwixt

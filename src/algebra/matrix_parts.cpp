// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// After CSS Transforms 2, "Interpolation of 3D matrices"; rotations take the short way, as in browsers. In the
// plane as in browsers: one skew and the scales that go with it.
#include "algebra/matrix_parts.h"

namespace betwixt::algebra {
namespace {

constexpr double flat = 1e-12;  // volume relative to that of a regular box

std::optional<MatrixParts> apart_in_plane(const Mat4& m) {
  const double a = m(0, 0), b = m(1, 0), c = m(0, 1), d = m(1, 1), det = a * d - b * c;
  MatrixParts p;
  p.way = translation_of(m);
  if (!(std::abs(det) > flat * std::hypot(a, b) * std::hypot(c, d))) return std::nullopt;
  // A reflection is along the axis that points away more.
  p.growth.x = det < 0 && a < d ? -std::hypot(a, b) : std::hypot(a, b);
  p.growth.y = det / p.growth.x;
  p.skew.x = (a * c + b * d) / det;
  p.turn = axis_angle({0, 0, 1}, std::atan2(b / p.growth.x, a / p.growth.x));
  return p;
}

// Returns the fourth row of the perspective that multiplies an affine matrix from the left.
std::optional<std::array<double, 4>> sight_of(const Mat4& m) {
  Mat4 affine = m;
  affine(3, 0) = affine(3, 1) = affine(3, 2) = 0, affine(3, 3) = 1;
  const auto back = inverse(affine);
  if (!back) return std::nullopt;
  std::array<double, 4> sight{};
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 4; ++i) sight[static_cast<std::size_t>(c)] += m(3, i) * (*back)(i, c);
  return sight;
}

std::optional<MatrixParts> apart_in_space(Mat4 m) {
  const double whole = m(3, 3);
  if (whole == 0 || !std::isfinite(whole)) return std::nullopt;
  for (double& x : m.m) x /= whole;
  const auto sight = sight_of(m);
  if (!sight) return std::nullopt;
  MatrixParts p;
  p.sight = *sight;
  p.way = translation_of(m);
  // Gram and Schmidt.
  Vec3 x = column(m, 0), y = column(m, 1), z = column(m, 2);
  p.growth.x = length(x), x = (1 / p.growth.x) * x;
  p.skew.x = dot(x, y), y = y - p.skew.x * x;
  p.growth.y = length(y), y = (1 / p.growth.y) * y;
  p.skew.y = dot(x, z), z = z - p.skew.y * x;
  p.skew.z = dot(y, z), z = z - p.skew.z * y;
  p.growth.z = length(z), z = (1 / p.growth.z) * z;
  p.skew.x /= p.growth.y, p.skew.y /= p.growth.z, p.skew.z /= p.growth.z;
  if (dot(x, cross(y, z)) < 0) p.growth = -p.growth, x = -x, y = -y, z = -z;
  Mat4 turn;
  for (int i = 0; i < 3; ++i) turn(i, 0) = x[i], turn(i, 1) = y[i], turn(i, 2) = z[i];
  p.turn = from_matrix(turn);
  return p;
}

}  // namespace

bool in_plane(const Mat4& m) {
  for (int i = 0; i < 4; ++i)
    if (m(2, i) != (i == 2) || m(i, 2) != (i == 2) || m(3, i) != (i == 3)) return false;
  return true;
}

std::optional<MatrixParts> taken_apart(const Mat4& m, bool plane) {
  return plane ? apart_in_plane(m) : apart_in_space(m);
}

Mat4 put_together(const MatrixParts& p) {
  Mat4 sight, skew;
  for (int c = 0; c < 4; ++c) sight(3, c) = p.sight[static_cast<std::size_t>(c)];
  skew(0, 1) = p.skew.x, skew(0, 2) = p.skew.y, skew(1, 2) = p.skew.z;
  return sight * translation(p.way) * rotation(p.turn) * skew * scaling(p.growth);
}

Quat short_way(Quat from, Quat to, double t) {
  const Quat by = conjugate(from) * to;
  return from * power(by.w < 0 ? -by : by, t);
}

Vec3 mix(Vec3 a, Vec3 b, double t) { return {std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t), std::lerp(a.z, b.z, t)}; }

double added_growth(double a, double b) { return a == 1 ? b : b == 1 ? a : a + b - 1; }

MatrixParts mixed(const MatrixParts& from, const MatrixParts& to, double t, bool plane) {
  MatrixParts a = from;
  // A reflection along x and one along y differ by half a turn.
  if (plane && ((a.growth.x < 0 && to.growth.y < 0) || (a.growth.y < 0 && to.growth.x < 0))) {
    a.growth.x = -a.growth.x, a.growth.y = -a.growth.y;
    a.turn = a.turn * Quat{0, 0, 0, 1};
  }
  MatrixParts p;
  p.way = mix(a.way, to.way, t), p.growth = mix(a.growth, to.growth, t), p.skew = mix(a.skew, to.skew, t);
  for (std::size_t i = 0; i < 4; ++i) p.sight[i] = std::lerp(a.sight[i], to.sight[i], t);
  p.turn = short_way(a.turn, to.turn, t);
  return p;
}

MatrixParts added(const MatrixParts& a, const MatrixParts& b) {
  MatrixParts p;
  p.way = a.way + b.way, p.skew = a.skew + b.skew;
  for (int i = 0; i < 3; ++i) p.growth[i] = added_growth(a.growth[i], b.growth[i]);
  for (std::size_t i = 0; i < 4; ++i)
    p.sight[i] = i == 3 ? added_growth(a.sight[i], b.sight[i]) : a.sight[i] + b.sight[i];
  p.turn = a.turn * b.turn;
  return p;
}

}  // namespace betwixt::algebra

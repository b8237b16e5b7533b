// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Vectors, quaternions and matrices in f64. Vectors are columns. Space is right-handed with y up; units are metres and
// radians.
//
// Room: base
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>

namespace betwixt {

inline constexpr double pi = std::numbers::pi;

struct Vec3 {
  double x = 0, y = 0, z = 0;
  constexpr double& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr Vec3 operator*(Vec3 a, double s) { return s * a; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec3 a) {  // cannot overflow. Avoids std::hypot, since libraries differ in its last bit
  const double x = std::abs(a.x), y = std::abs(a.y), z = std::abs(a.z), most = std::max({x, y, z});
  if (!(most > 0)) return x + y + z;
  return most * std::sqrt((x / most) * (x / most) + (y / most) * (y / most) + (z / most) * (z / most));
}
// Returns the unit vector along `a`, or `otherwise` if `a` has no direction.
inline Vec3 normalize(Vec3 a, Vec3 otherwise = {0, 0, 1}) {
  const double l = length(a);
  return l > 0 ? (1 / l) * a : otherwise;
}

// A box with its sides along the axes, empty at first.
struct Box {
  Vec3 low{1, 1, 1}, high{-1, -1, -1};  // empty if low > high
  constexpr bool empty() const { return low.x > high.x; }
  constexpr Vec3 middle() const { return 0.5 * low + 0.5 * high; }
  constexpr Vec3 half() const { return 0.5 * (high - low); }
  // Grows the box until it contains the point or the other box.
  constexpr void add(Vec3 p) {
    if (empty()) low = high = p;
    for (int i = 0; i < 3; ++i) low[i] = p[i] < low[i] ? p[i] : low[i], high[i] = p[i] > high[i] ? p[i] : high[i];
  }
  constexpr void add(const Box& b) {
    if (!b.empty()) add(b.low), add(b.high);
  }
};

// A unit quaternion w + xi + yj + zk, as an orientation.
struct Quat {
  double w = 1, x = 0, y = 0, z = 0;
  friend constexpr bool operator==(const Quat&, const Quat&) = default;
};

constexpr Quat operator*(Quat a, Quat b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
constexpr Quat operator-(Quat a) { return {-a.w, -a.x, -a.y, -a.z}; }
constexpr double dot(Quat a, Quat b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Quat conjugate(Quat a) { return {a.w, -a.x, -a.y, -a.z}; }
inline Quat normalize(Quat a) {
  const double l = std::sqrt(dot(a, a));
  return l > 0 ? Quat{a.w / l, a.x / l, a.y / l, a.z / l} : Quat{};
}
inline Quat axis_angle(Vec3 axis, double angle) {
  const Vec3 n = normalize(axis);
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), n.x * s, n.y * s, n.z * s};
}
// Returns the rotation q applied `s` times; `s` may be a fraction. The angle of q may be above half a turn: -q turns
// the other way around. For half of the shorter rotation use power(q.w < 0 ? -q : q, 0.5).
inline Quat power(Quat q, double s) {
  const double sine = length(Vec3{q.x, q.y, q.z});
  if (sine < 1e-300) return {};
  const double half_angle = s * std::atan2(sine, q.w), k = std::sin(half_angle) / sine;
  return {std::cos(half_angle), k * q.x, k * q.y, k * q.z};
}
// The sine and cosine of an angle in radians. The error is at most 2e-16, and the bits are the same on every machine.
// Beyond a million radians they come from the C library.
struct SineCosine {
  double sine = 0, cosine = 1;
};
inline SineCosine sine_cosine(double angle) {
  if (!(std::abs(angle) < 1e6)) return {std::sin(angle), std::cos(angle)};
  // Subtract whole quarter turns. A quarter turn is given in three parts; the first two have few bits, so that their
  // products are exact. The remainder is at most an eighth of a turn, which is the range of the two series.
  constexpr double quarters = 0.63661977236758134308, first = 1.57079632673412561417e+00,
                   second = 6.07710050630396597660e-11, third = 2.02226624879595063154e-21;
  constexpr double shift = 0x1.8p52;  // adding it rounds to whole numbers
  const double shifted = angle * quarters + shift, n = shifted - shift;
  const double x = ((angle - n * first) - n * second) - n * third, z = x * x;
  const double sine = x + x * z *
                              (-1.66666666666666324348e-01 +
                               z * (8.33333333332248946124e-03 +
                                    z * (-1.98412698298579493134e-04 +
                                         z * (2.75573137070700676789e-06 +
                                              z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
  const double cosine =
      1 - (0.5 * z - z * z *
                         (4.16666666666666019037e-02 +
                          z * (-1.38888888888741095749e-03 +
                               z * (2.48015872894767294178e-05 +
                                    z * (-2.75573143513906633035e-07 +
                                         z * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11))))));
  // Select sine or cosine, and the sign, by bits. A branch would be slow: processors cannot predict the order of
  // angles.
  const auto quarter = static_cast<std::uint64_t>(static_cast<std::int64_t>(n));
  const std::uint64_t s = std::bit_cast<std::uint64_t>(sine), c = std::bit_cast<std::uint64_t>(cosine);
  const std::uint64_t swapped = (s ^ c) & (0 - (quarter & 1));
  return {std::bit_cast<double>(s ^ swapped ^ (quarter & 2) << 62),
          std::bit_cast<double>(c ^ swapped ^ ((quarter + 1) & 2) << 62)};
}
// Returns the rotation by three angles in radians: about the object's own x axis, then its y axis, then its z axis.
inline Quat from_angles(Vec3 a) {
  const auto [sx, cx] = sine_cosine(a.x / 2);
  const auto [sy, cy] = sine_cosine(a.y / 2);
  const auto [sz, cz] = sine_cosine(a.z / 2);
  const Quat xy{cx * cy, sx * cy, cx * sy, sx * sy};
  return {xy.w * cz - xy.z * sz, xy.x * cz + xy.y * sz, xy.y * cz - xy.x * sz, xy.z * cz + xy.w * sz};
}

// A matrix in column-major memory: element (row, column), with the translation in the last column.
struct Mat4 {
  std::array<double, 16> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  constexpr double& operator()(int row, int column) { return m[static_cast<std::size_t>(column * 4 + row)]; }
  constexpr double operator()(int row, int column) const { return m[static_cast<std::size_t>(column * 4 + row)]; }
  friend constexpr bool operator==(const Mat4&, const Mat4&) = default;
};

constexpr Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 r;
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < 4; ++i) r(i, c) = a(i, 0) * b(0, c) + a(i, 1) * b(1, c) + a(i, 2) * b(2, c) + a(i, 3) * b(3, c);
  return r;
}
constexpr Vec3 transform_point(const Mat4& a, Vec3 p) {
  return {a(0, 0) * p.x + a(0, 1) * p.y + a(0, 2) * p.z + a(0, 3),
          a(1, 0) * p.x + a(1, 1) * p.y + a(1, 2) * p.z + a(1, 3),
          a(2, 0) * p.x + a(2, 1) * p.y + a(2, 2) * p.z + a(2, 3)};
}
constexpr Vec3 transform_vector(const Mat4& a, Vec3 v) {
  return {a(0, 0) * v.x + a(0, 1) * v.y + a(0, 2) * v.z, a(1, 0) * v.x + a(1, 1) * v.y + a(1, 2) * v.z,
          a(2, 0) * v.x + a(2, 1) * v.y + a(2, 2) * v.z};
}
// Returns the linear part of a b, for affine matrices. The other elements are those of the identity.
constexpr Mat4 linear_product(const Mat4& a, const Mat4& b) {
  Mat4 r;
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 3; ++i) r(i, c) = a(i, 0) * b(0, c) + a(i, 1) * b(1, c) + a(i, 2) * b(2, c);
  return r;
}
constexpr Vec3 column(const Mat4& a, int c) { return {a(0, c), a(1, c), a(2, c)}; }
constexpr Vec3 translation_of(const Mat4& a) { return column(a, 3); }
constexpr Mat4 translation(Vec3 t) {
  Mat4 r;
  r(0, 3) = t.x, r(1, 3) = t.y, r(2, 3) = t.z;
  return r;
}
constexpr Mat4 scaling(Vec3 s) {
  Mat4 r;
  r(0, 0) = s.x, r(1, 1) = s.y, r(2, 2) = s.z;
  return r;
}
constexpr Mat4 rotation(Quat q) {
  Mat4 r;
  r(0, 0) = 1 - 2 * (q.y * q.y + q.z * q.z), r(0, 1) = 2 * (q.x * q.y - q.w * q.z);
  r(0, 2) = 2 * (q.x * q.z + q.w * q.y), r(1, 0) = 2 * (q.x * q.y + q.w * q.z);
  r(1, 1) = 1 - 2 * (q.x * q.x + q.z * q.z), r(1, 2) = 2 * (q.y * q.z - q.w * q.x);
  r(2, 0) = 2 * (q.x * q.z - q.w * q.y), r(2, 1) = 2 * (q.y * q.z + q.w * q.x);
  r(2, 2) = 1 - 2 * (q.x * q.x + q.y * q.y);
  return r;
}

// Returns the determinant of the linear part of an affine matrix.
constexpr double determinant(const Mat4& a) { return dot(column(a, 0), cross(column(a, 1), column(a, 2))); }
// Returns the inverse of an affine matrix, or std::nullopt if it is singular.
inline std::optional<Mat4> inverse(const Mat4& affine) {
  const Vec3 a = column(affine, 0), b = column(affine, 1), c = column(affine, 2);
  const double det = determinant(affine);
  if (!(std::abs(det) > 1e-12 * length(a) * length(b) * length(c))) return std::nullopt;
  const Vec3 rows[] = {1 / det * cross(b, c), 1 / det * cross(c, a), 1 / det * cross(a, b)};
  Mat4 out;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) out(i, k) = rows[i][k];
  const Vec3 back = -transform_vector(out, translation_of(affine));
  out(0, 3) = back.x, out(1, 3) = back.y, out(2, 3) = back.z;
  return out;
}

// Returns whether all numbers are finite.
inline bool finite(std::span<const double> numbers) {
  for (const double x : numbers)
    if (!std::isfinite(x)) return false;
  return true;
}
inline bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
inline bool finite(const Mat4& a) { return finite(std::span(a.m)); }

// Returns the matrix that puts the origin at `eye` and turns the -z axis towards `target`, with y as far up as
// possible.
inline Mat4 look_at(Vec3 eye, Vec3 target) {
  const Vec3 back = normalize(eye - target);
  const Vec3 up = std::abs(back.y) > 1 - 1e-12 ? Vec3{0, 0, back.y > 0 ? -1.0 : 1.0} : Vec3{0, 1, 0};
  const Vec3 right = normalize(cross(up, back)), over = cross(back, right);
  Mat4 m = translation(eye);
  for (int i = 0; i < 3; ++i) m(i, 0) = right[i], m(i, 1) = over[i], m(i, 2) = back[i];
  return m;
}

// Returns the quaternion of a rotation matrix.
inline Quat from_matrix(const Mat4& m) {
  const double t[] = {m(0, 0) + m(1, 1) + m(2, 2), m(0, 0), m(1, 1), m(2, 2)};
  int k = 0;
  for (int i = 1; i < 4; ++i)
    if (t[i] > t[k]) k = i;
  if (k == 0) return normalize(Quat{1 + t[0], m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)});
  if (k == 1) return normalize(Quat{m(2, 1) - m(1, 2), 1 + t[1] - t[2] - t[3], m(0, 1) + m(1, 0), m(0, 2) + m(2, 0)});
  if (k == 2) return normalize(Quat{m(0, 2) - m(2, 0), m(0, 1) + m(1, 0), 1 + t[2] - t[1] - t[3], m(1, 2) + m(2, 1)});
  return normalize(Quat{m(1, 0) - m(0, 1), m(0, 2) + m(2, 0), m(1, 2) + m(2, 1), 1 + t[3] - t[1] - t[2]});
}

}  // namespace betwixt

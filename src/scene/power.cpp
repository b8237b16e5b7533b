// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/power.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

namespace betwixt {
namespace {

// M is analysed in long double, so that the result is as exact as the rounding of M allows; later evaluation is in f64.
using Real = long double;
using Block = std::array<std::array<Real, 3>, 3>;

constexpr Real exact = 1e-14L;     // more than the rounding of a few products in f64
constexpr Real product = 1e-12L;   // and of many
constexpr Real in_floats = 1e-7L;  // an element: f32 rounds by 6e-8
const double log_bound = std::log(Power::bound);

Block linear_part(const Mat4& m) {
  Block b;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) b[i][j] = m(i, j);
  return b;
}

Real determinant(const Block& b) {
  return b[0][0] * (b[1][1] * b[2][2] - b[1][2] * b[2][1]) - b[0][1] * (b[1][0] * b[2][2] - b[1][2] * b[2][0]) +
         b[0][2] * (b[1][0] * b[2][1] - b[1][1] * b[2][0]);
}

Block times_its_transpose(const Block& b) {
  Block r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r[i][j] = b[i][0] * b[j][0] + b[i][1] * b[j][1] + b[i][2] * b[j][2];
  return r;
}

// Returns the largest element of |B B' - k I|.
Real off_square(const Block& b, Real k) {
  const Block g = times_its_transpose(b);
  Real most = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(g[i][j] - (i == j ? k : 0)));
  return most;
}

// Returns the scale, if it is uniform.
Real size_of(const Block& b) {
  const Block square = times_its_transpose(b);
  return std::sqrt((square[0][0] + square[1][1] + square[2][2]) / 3);
}
bool has_size(Real size) { return size > 1e-100L && size < 1e100L; }

Block scaled(Block b, Real k) {
  for (auto& row : b)
    for (Real& e : row) e *= k;
  return b;
}

// Returns the nearest rotation to a matrix that is almost one: Newton's steps to the orthogonal polar factor.
Block straightened(Block b) {
  for (int step = 0; step < 3; ++step) {
    const Block g = times_its_transpose(b), old = b;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        b[i][j] = 1.5L * old[i][j] - 0.5L * (g[i][0] * old[0][j] + g[i][1] * old[1][j] + g[i][2] * old[2][j]);
  }
  return b;
}

struct Turning {
  Vec3 axis;
  Real turns;  // 0..0.5
};

// Like from_matrix(): divides by the largest of the four squares.
Turning turning(const Block& b) {
  const Real t[] = {b[0][0] + b[1][1] + b[2][2], b[0][0], b[1][1], b[2][2]};
  const int k = static_cast<int>(std::max_element(t, t + 4) - t);
  std::array<Real, 4> q;  // w x y z
  if (k == 0) {
    q = {1 + t[0], b[2][1] - b[1][2], b[0][2] - b[2][0], b[1][0] - b[0][1]};
  } else {
    const int i = k - 1, j = (i + 1) % 3, l = (i + 2) % 3;
    q[0] = b[l][j] - b[j][l];
    q[i + 1] = 1 + b[i][i] - b[j][j] - b[l][l];
    q[j + 1] = b[i][j] + b[j][i];
    q[l + 1] = b[i][l] + b[l][i];
  }
  if (q[0] < 0)
    for (Real& e : q) e = -e;
  const Real length = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (length == 0) return {{0, 0, 1}, 0};
  const auto part = [&](int i) { return static_cast<double>(q[i] / length); };
  return {{part(1), part(2), part(3)}, std::atan2(length, q[0]) / std::numbers::pi_v<Real>};
}

// p / q of a turn, p < q < 2^32.
std::uint64_t fraction(std::uint64_t p, std::uint64_t q) {
  const std::uint64_t high = (p << 32) / q, rest = (p << 32) % q;
  return (high << 32) + ((rest << 32) + q / 2) / q;
}

// Returns x (0..0.5) in 2^-64. If rounding cannot distinguish x from a simple fraction, returns that fraction. Down to
// thousandths of a degree the fractions are sparse, so hardly any other angle is next to one.
std::uint64_t in_turns(Real x) {
  constexpr std::uint64_t largest_part = 360'000;
  constexpr Real rounding = 2e-16L;
  std::uint64_t p0 = 0, q0 = 1, p = 1, q = 0;  // convergents of the continued fraction
  for (Real rest = x;;) {
    const Real whole = std::floor(rest);
    if (whole > static_cast<Real>(largest_part)) break;
    const auto a = static_cast<std::uint64_t>(whole);
    const std::uint64_t p1 = a * p + p0, q1 = a * q + q0;
    if (q1 > largest_part) break;
    p0 = p, q0 = q, p = p1, q = q1;
    // A small angle has a smaller rounding error.
    if (p > 0 && std::abs(x - static_cast<Real>(p) / static_cast<Real>(q)) <= rounding * std::min<Real>(1, 8 * x))
      return fraction(p, q);
    if (rest == whole) break;
    rest = 1 / (rest - whole);
  }
  return static_cast<std::uint64_t>(std::round(std::ldexp(x, 64)));
}

// Sine, cosine and 1 - cosine, which is exact for small angles.
struct Circle {
  double sine, cosine, versine;
};

Circle circle(std::uint64_t turns) {
  const std::uint64_t quarter = (turns + (std::uint64_t{1} << 61)) >> 62 & 3;
  const double rest = static_cast<double>(static_cast<std::int64_t>(turns - (quarter << 62)));
  const double angle = std::ldexp(rest, -63) * pi, s = std::sin(angle), c = std::cos(angle);
  const double half = std::sin(angle / 2);
  if (quarter == 0) return {s, c, 2 * half * half};
  if (quarter == 1) return {c, -s, 1 + s};
  if (quarter == 2) return {-s, -c, 1 + c};
  return {-c, s, 1 - s};
}

bool is_affine(const Mat4& m) { return m(3, 0) == 0 && m(3, 1) == 0 && m(3, 2) == 0 && m(3, 3) == 1; }

// Finds the point c across the axis with c = s e^(i turn) c + slide, i standing for the quarter turn about the axis.
void find_centre(Power::Similarity& f) {
  const Circle at = circle(f.turns);
  const double re = f.scale * at.versine - std::expm1(f.log_scale), im = -f.scale * at.sine;
  const double size = re * re + im * im;
  f.centred = size > 0;
  if (!f.centred) return;
  f.centre = (re / size) * f.slide - (im / size) * cross(f.axis, f.slide);
  f.side = cross(f.axis, f.centre);
}

// A rotation about an axis elsewhere, computed by products, rarely has an advance of exactly 0. An advance that
// rounding explains is dropped, since it would become a drift.
void drop_rounding(Power::Similarity& f, double shift) {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  const bool still = f.turns == 0 && f.scale == 1 && !f.mirrored;
  if (still) return;
  if (std::abs(f.advance) <= rounding * (shift + length(f.centre))) f.advance = 0;
  if (!f.centred && length(f.slide) <= rounding * shift) f.slide = {};
}

}  // namespace

Mat4 bounded(const Mat4& m, bool& clamped) {
  Mat4 r = m;
  for (double& e : r.m) {
    if (std::abs(e) < Power::bound) continue;
    e = std::copysign(Power::bound, e);
    clamped = true;
  }
  return r;
}

Power::Power(const Mat4& m) {
  if (classify(m)) return;
  kind_ = Kind::general;
  bool clamped = false;
  std::vector<Mat4> rungs{bounded(m, clamped)};
  while (rungs.size() < 63) {
    const Mat4 next = bounded(rungs.back() * rungs.back(), clamped);
    if (next == rungs.back()) break;
    rungs.push_back(next);
  }
  ladder_ = std::make_shared<const std::vector<Mat4>>(std::move(rungs));
}

std::optional<Unrounded> unrounded(const Mat4& m) {
  const Block b = linear_part(m);
  const Real size = size_of(b);
  if (!is_affine(m) || !has_size(size)) return std::nullopt;
  const Real off = off_square(scaled(b, 1 / size), 1);
  if (off < exact) return std::nullopt;
  Unrounded out{m, off >= product};
  const Block even = straightened(scaled(b, 1 / size));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (out.noticeable && !(std::abs(b[i][j] - even[i][j]) < in_floats)) return std::nullopt;
      out.matrix(i, j) = static_cast<double>(out.noticeable ? even[i][j] : size * even[i][j]);
    }
  return out;
}

// Returns false for a general matrix.
bool Power::classify(const Mat4& m) {
  Block b = linear_part(m);
  const Real size = size_of(b);
  if (!is_affine(m) || !has_size(size) || off_square(scaled(b, 1 / size), 1) >= exact) return false;

  Similarity& f = similarity_;
  const Real scale = std::abs(size - 1) > exact ? size : 1;
  f.scale = static_cast<double>(scale);
  f.log_scale = static_cast<double>(std::log(scale));
  f.mirrored = determinant(b) < 0;
  // A reflection is minus a rotation; minus the identity is half a turn across the axis and a reflection along it.
  b = straightened(scaled(b, (f.mirrored ? -1 : 1) / size));
  const auto [axis, turns] = turning(b);
  f.axis = axis;
  f.turns = in_turns(turns) + (f.mirrored ? std::uint64_t{1} << 63 : 0);

  const Vec3 shift = translation_of(m);
  const bool plain = f.turns == 0 && f.scale == 1 && !f.mirrored;
  f.advance = plain ? 0 : dot(f.axis, shift);
  f.slide = plain ? shift : shift - f.advance * f.axis;
  find_centre(f);
  drop_rounding(f, length(shift));
  kind_ = !plain ? Kind::similarity : shift == Vec3{} ? Kind::identity : Kind::translation;
  return true;
}

Mat4 Power::closed(double n, std::uint64_t turns, bool odd) const {
  const Similarity& f = similarity_;
  const double exponent = std::clamp(n * f.log_scale, -log_bound, log_bound);
  const double scale = std::exp(exponent), growth = std::expm1(exponent);
  const Circle at = circle(turns);
  const bool flip = f.mirrored && odd;
  // Linear part: scale * (cosine across the axis, sine about it, 1 or -1 along it).
  const Vec3 a = f.axis;
  const double along = flip ? -1 - at.cosine : at.versine;
  Mat4 r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r(i, j) = scale * (along * a[i] * a[j] + (i == j ? at.cosine : 0));
  const Vec3 s = (scale * at.sine) * a;
  r(0, 1) -= s.z, r(0, 2) += s.y, r(1, 0) += s.z, r(1, 2) -= s.x, r(2, 0) -= s.y, r(2, 1) += s.x;
  // Across the axis: (1 - scale e^(i angle)) centre, a sum that does not cancel however far away the centre is.
  const Vec3 across = f.centred ? (scale * at.versine - growth) * f.centre - (scale * at.sine) * f.side : n * f.slide;
  // Along it: the sum of the first n powers of the step there.
  const double steps = f.mirrored     ? (flip ? 2 + growth : -growth) / (1 + f.scale)
                       : f.scale != 1 ? growth / std::expm1(f.log_scale)  // scale - 1 has lost digits near 0
                                      : n;
  const Vec3 shift = across + (f.advance * steps) * a;
  r(0, 3) = shift.x, r(1, 3) = shift.y, r(2, 3) = shift.z;
  return r;
}

Mat4 Power::climb(std::int64_t n, bool& clamped) const {
  Mat4 r;
  const std::vector<Mat4>& rungs = *ladder_;
  for (std::size_t k = 0; n != 0; ++k, n >>= 1)
    if (n & 1) r = bounded(rungs[std::min(k, rungs.size() - 1)] * r, clamped);
  return r;
}

Mat4 Power::operator()(std::int64_t n) const {
  assert(n >= 0 && "powers below 0 are asked for");
  bool clamped = false;
  if (n == 0 || kind_ == Kind::identity) return {};
  if (kind_ == Kind::general) return climb(n, clamped);
  const auto steps = static_cast<double>(n);
  if (kind_ == Kind::translation) return bounded(translation(steps * similarity_.slide), clamped);
  return bounded(closed(steps, static_cast<std::uint64_t>(n) * similarity_.turns, (n & 1) != 0), clamped);
}

std::optional<Mat4> Power::real(double n) const {
  assert(n >= 0 && n < 9e18 && "powers below 0 or beyond 64 bits are asked for");
  if (kind_ == Kind::general || similarity_.mirrored) return std::nullopt;
  const double whole = std::floor(n);
  const auto between = static_cast<std::uint64_t>((n - whole) * static_cast<double>(similarity_.turns));
  bool clamped = false;
  return bounded(closed(n, static_cast<std::uint64_t>(whole) * similarity_.turns + between, false), clamped);
}

bool Power::clamped(std::int64_t n) const {
  bool clamped = false;
  if (kind_ == Kind::general)
    climb(n, clamped);
  else
    clamped = std::abs(static_cast<double>(n) * similarity_.log_scale) > log_bound;
  return clamped;
}

}  // namespace betwixt

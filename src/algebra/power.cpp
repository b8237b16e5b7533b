// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/power.h"

#include <cmath>
#include <complex>

namespace betwixt::algebra {
namespace {

using Complex = std::complex<double>;

struct Linear {
  double a = 1, b = 0, c = 0, d = 1;  // ((a b) (c d))
};

// Functions of the logarithm of an eigenvalue: l^t is exp(t log l), and its integral from 0 to t.
Complex grown(Complex log, double t) { return std::exp(t * log); }
Complex gathered(Complex log, double t) {
  const Complex z = t * log;
  if (std::abs(z) < 1e-4) return t * (1.0 + z * (0.5 + z * (1.0 / 6 + z / 24.0)));
  return (std::exp(z) - 1.0) / log;
}

// Computes functions of a matrix from its eigenvalues m + s and m - s: f(L) = p + q (L - m).
class Spectrum {
 public:
  static std::optional<Spectrum> of(const Linear& l) {
    Spectrum k;
    k.mean_ = (l.a + l.d) / 2;
    k.apart_ = {l.a - k.mean_, l.b, l.c, l.d - k.mean_};
    const double square = k.apart_.a * k.apart_.a + l.b * l.c, size = k.mean_ * k.mean_;
    const double skew = std::abs(l.b) + std::abs(l.c) + std::abs(k.apart_.a);
    if (k.mean_ < 0 && skew < 1e-9 * -k.mean_) {  // half a turn: either direction will do, this one is to the left
      k.apart_ = {0, -1, 1, 0};
      k.half_turn_ = true;
      return k;
    }
    if (square >= 0 && (k.mean_ <= 0 || square >= size)) return std::nullopt;  // an eigenvalue of 0 or less
    k.half_ = std::sqrt(Complex(square));
    // For a double eigenvalue, use the derivative by a small difference.
    if (std::abs(k.half_) < 1e-6 * std::abs(k.mean_)) k.half_ = 1e-6 * std::abs(k.mean_);
    return k;
  }
  template <class Function>
  Linear apply(Function f) const {
    double p = 0, q = 0;
    if (half_turn_) {
      const Complex v = f(Complex(std::log(-mean_), pi));
      p = v.real(), q = v.imag();
    } else {
      const Complex high = f(std::log(mean_ + half_)), low = f(std::log(mean_ - half_));
      p = ((high + low) / 2.0).real(), q = ((high - low) / (2.0 * half_)).real();
    }
    return {p + q * apart_.a, q * apart_.b, q * apart_.c, p + q * apart_.d};
  }

 private:
  double mean_ = 1;
  Complex half_;
  Linear apart_;
  bool half_turn_ = false;
};

}  // namespace

std::optional<Mat4> power(const Mat4& m, double t) {
  const auto spectrum = Spectrum::of({m(0, 0), m(0, 1), m(1, 0), m(1, 1)});
  if (!spectrum) return std::nullopt;
  const Linear l = spectrum->apply([t](Complex log) { return grown(log, t); });
  // The translation of M^t is the integral of a constant velocity v, rotated by L^s; v is chosen for M's translation.
  const Linear part = spectrum->apply([t](Complex log) { return gathered(log, t); });
  const Linear all = spectrum->apply([](Complex log) { return gathered(log, 1); });
  const double det = all.a * all.d - all.b * all.c;
  const double vx = (all.d * m(0, 3) - all.b * m(1, 3)) / det, vy = (all.a * m(1, 3) - all.c * m(0, 3)) / det;
  Mat4 r;
  r(0, 0) = l.a, r(0, 1) = l.b, r(1, 0) = l.c, r(1, 1) = l.d;
  r(0, 3) = part.a * vx + part.b * vy, r(1, 3) = part.c * vx + part.d * vy;
  return r;
}

}  // namespace betwixt::algebra

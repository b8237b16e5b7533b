// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Computes motions in quadruple precision: applies the factors to points one by one, with sines, logarithms and
// exponentials from their series. It shares only the definition of a factor with the library.
#pragma once

#include <algorithm>
#include <random>

#include "betwixt/algebra.h"

namespace betwixt::precise {

__extension__ using Real = __float128;

// Constants, each as the sum of three doubles.
inline constexpr Real pi = Real(3.141592653589793) + Real(1.2246467991473532e-16) + Real(-2.9947698097183397e-33);
inline constexpr Real ln2 = Real(0.6931471805599453) + Real(2.3190468138462996e-17) + Real(5.707708438416212e-34);

inline Real size(Real x) { return x < 0 ? -x : x; }

inline Real sine(Real x) {
  Real turns = x / (2 * pi);
  const auto whole = static_cast<long long>(turns);
  x -= static_cast<Real>(whole) * 2 * pi;
  x /= 16;  // the angle is doubled again four times below, by way of 1 - cos
  // sin and 1 - cos of a small angle
  Real s = 0, v = 0, term = 1;
  for (int n = 1; n < 40; ++n) {
    term *= x / n;
    const int sign = n / 2 % 2 == 0 ? 1 : -1;
    if (n % 2 == 1)
      s += sign * term;
    else
      v -= sign * term;
  }
  for (int i = 0; i < 4; ++i) {
    const Real twice = 2 * s * (1 - v);
    v = 2 * s * s;
    s = twice;
  }
  return s;
}
inline Real cosine(Real x) { return sine(x + pi / 2); }

inline Real exponential(Real x) {
  int doublings = 0;
  while (size(x) > Real(1) / 64) x /= 2, ++doublings;
  Real sum = 1, term = 1;
  for (int n = 1; n < 30; ++n) sum += term *= x / n;
  while (doublings-- > 0) sum *= sum;
  return sum;
}

inline Real logarithm(Real x) {
  int twos = 0;
  while (x > 1.5) x /= 2, ++twos;
  while (x < 0.75) x *= 2, --twos;
  const Real z = (x - 1) / (x + 1);
  Real sum = 0, power = z;
  for (int n = 1; n < 120; n += 2, power *= z * z) sum += power / n;
  return 2 * sum + twos * ln2;
}

struct Point {
  Real c[3];
  double largest = 1;  // the largest intermediate number, relative to the result: the rounding error grows with it
  double at(int i) const { return static_cast<double>(c[i]); }
};

inline Point moved(const Motion& motion, long long k, long long steps, Vec3 from) {
  Point p{{from.x, from.y, from.z}};
  const Real t = static_cast<Real>(k) / static_cast<Real>(steps);
  Real largest = 1;
  for (std::size_t i = motion.factors.size(); i-- > 0;) {
    const Factor& f = motion.factors[i];
    if (f.kind == Factor::Kind::translate) {
      for (int c = 0; c < 3; ++c) p.c[c] += t * static_cast<Real>(f.by[c]);
    } else {
      Real d[3];
      for (int c = 0; c < 3; ++c) d[c] = p.c[c] - static_cast<Real>(f.centre[c]);
      if (f.kind == Factor::Kind::scale) {
        for (int c = 0; c < 3; ++c) {
          const Real g = f.by[c];
          d[c] *= f.law == Factor::Law::linear ? 1 + (g - 1) * t : exponential(t * logarithm(g));
        }
      } else {  // Rodrigues' formula
        Real a[3] = {f.axis.x, f.axis.y, f.axis.z};
        Real square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2], root = static_cast<Real>(length(f.axis));
        for (int i = 0; i < 4; ++i) root = (root + square / root) / 2;
        for (Real& x : a) x /= root;
        const Real angle = t * static_cast<Real>(f.angle), s = sine(angle), c = cosine(angle);
        const Real along = a[0] * d[0] + a[1] * d[1] + a[2] * d[2];
        const Real cross[3] = {a[1] * d[2] - a[2] * d[1], a[2] * d[0] - a[0] * d[2], a[0] * d[1] - a[1] * d[0]};
        for (int i = 0; i < 3; ++i) d[i] = c * d[i] + s * cross[i] + (1 - c) * along * a[i];
      }
      for (int c = 0; c < 3; ++c) p.c[c] = d[c] + static_cast<Real>(f.centre[c]);
    }
    for (const Real c : p.c) largest = std::max(largest, size(c));
  }
  p.largest = static_cast<double>(largest);
  return p;
}

}  // namespace betwixt::precise

namespace betwixt {

// Returns random factors of every kind. They are small enough that numbers stay below some millions.
inline Motion random_motion(std::mt19937& random, int length, bool space) {
  const auto between = [&](double a, double b) {
    return a + (b - a) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  const auto place = [&] { return Vec3{between(-5, 5), between(-5, 5), space ? between(-5, 5) : 0}; };
  // Half of the time makes special cases: unit factors, inverses, quarter turns, equal centres.
  const auto special = [&] { return random() % 2 == 0; };
  const auto factor = [&] {
    constexpr double few[] = {1, 1, 0.5, 2};
    return special() ? few[random() % 4] : between(0.4, 2.5);
  };
  const auto centre = [&](const Motion& m) {
    if (special() && !m.factors.empty()) return m.factors.back().centre;
    Vec3 c = place();
    if (special()) c.x = 1;
    return c;
  };
  Motion motion;
  for (int i = 0; i < length; ++i) {
    const auto kind = random() % 3;
    if (kind == 0) {
      motion.factors.push_back(translate_by(place()));
    } else if (kind == 1) {
      const double angle = special() ? pi / 2 * (static_cast<double>(random() % 9) - 4) : between(-20, 20);
      motion.factors.push_back(rotate_by(angle, centre(motion), space ? place() : Vec3{0, 0, 1}));
    } else {
      const bool linear = random() % 3 == 0;
      const double x = factor(), y = random() % 3 == 0 ? x : factor();
      Factor f = scale_by({x, y,
                           space    ? factor()
                           : x == y ? x
                                    : 1},
                          centre(motion), linear ? Factor::Law::linear : Factor::Law::exponential);
      if (linear && random() % 2 == 0) f.by.x = -f.by.x;
      motion.factors.push_back(f);
    }
  }
  return motion;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The integral of a curve over time: exact for polynomials, otherwise adaptive.
#include <algorithm>
#include <cmath>
#include <vector>

#include "track/curve.h"

namespace betwixt {
namespace {

using Sums = std::array<double, 4>;

// The eases of a segment, as parts of it, and the inverse of the eased time.
struct Eases {
  double out = 0, in = 0;
  double time_of(double s) const {
    const double v = 1 / (1 - (out + in) / 2);
    if (s < v * out / 2) return std::sqrt(2 * out * s / v);
    if (1 - s < v * in / 2) return 1 - std::sqrt(2 * in * (1 - s) / v);
    return s / v + out / 2;
  }
};

Eases eases_of(const CurveDetail* from, const CurveDetail* to, double h) {
  Eases e{from ? from->ease_out / h : 0, to ? to->ease_in / h : 0};
  const double shrink = std::max(1.0, e.out + e.in);
  return {e.out / shrink, e.in / shrink};
}

// Returns the values of s at which one polynomial ends and the next begins: stops and steps.
std::vector<double> joints(Twerper t, const CurveDetail* from) {
  std::vector<double> out;
  if (from && from->arguments.stops)
    for (const Stop& stop : *from->arguments.stops) out.push_back(stop[0] / 100);
  if (!is_own(t) && row_of(t).steps && from)
    for (double i = 1; i < from->arguments[0]; ++i) out.push_back(i / from->arguments[0]);
  return out;
}

bool polynomials(Twerper t) { return !is_own(t) && (row_of(t).cubics || row_of(t).steps || !row_of(t).factor); }

// Gauss-Legendre with five points is exact to the ninth degree; a cubic of an ease has the sixth.
template <class F>
Sums by_five(const F& value, double from, double to) {
  static constexpr double at[] = {0.04691007703066800, 0.23076534494715845, 0.5, 0.76923465505284155,
                                  0.95308992296933200};
  static constexpr double weight[] = {0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                      0.23931433524968324, 0.11846344252809454};
  Sums sum{};
  for (std::size_t g = 0; g < 5; ++g) {
    const Sums n = value(from + at[g] * (to - from));
    for (std::size_t i = 0; i < 4; ++i) sum[i] += weight[g] * (to - from) * n[i];
  }
  return sum;
}

// An interval of time, its integral by Kronrod's fifteen points, and the error estimate by the seven of Gauss.
struct Stretch15 {
  double from = 0, to = 0, error = 0;
  Sums sum{};
};

template <class F>
Stretch15 by_fifteen(const F& value, double from, double to) {
  static constexpr double at[] = {0.0,
                                  0.20778495500789847,
                                  0.40584515137739717,
                                  0.58608723546769113,
                                  0.74153118559939444,
                                  0.86486442335976907,
                                  0.94910791234275852,
                                  0.99145537112081264};
  static constexpr double weight[] = {0.20948214108472783, 0.20443294007529889, 0.19035057806478541,
                                      0.16900472663926790, 0.14065325971552592, 0.10479001032225018,
                                      0.06309209262997855, 0.02293532201052922};
  static constexpr double gauss[] = {0.41795918367346939, 0, 0.38183005050511894, 0,
                                     0.27970539148927667, 0, 0.12948496616886969, 0};
  const double middle = (from + to) / 2, half = (to - from) / 2;
  Stretch15 out{from, to, 0, {}};
  Sums coarse{};
  for (std::size_t k = 0; k < 8; ++k) {
    Sums n = value(middle + half * at[k]);
    if (k > 0) {
      const Sums other = value(middle - half * at[k]);
      for (std::size_t i = 0; i < 4; ++i) n[i] += other[i];
    }
    for (std::size_t i = 0; i < 4; ++i) out.sum[i] += half * weight[k] * n[i], coarse[i] += half * gauss[k] * n[i];
  }
  for (std::size_t i = 0; i < 4; ++i) out.error = std::max(out.error, std::abs(out.sum[i] - coarse[i]));
  return out;
}

// Integrates functions that are not polynomials: bisects the interval with the largest error until the total is
// negligible. Corners, jumps and vertical slopes need some thirty bisections each.
template <class F>
Sums by_halving(const F& value, const std::vector<double>& seams) {
  constexpr std::size_t most = 256;
  double size = 0;  // the largest absolute value
  const auto seen = [&](double u) {
    const Sums n = value(u);
    for (const double x : n) size = std::max(size, std::abs(x));
    return n;
  };
  std::vector<Stretch15> all;
  const auto worse = [](const Stretch15& a, const Stretch15& b) { return a.error < b.error; };
  for (std::size_t i = 0; i + 1 < seams.size(); ++i)
    for (double part = 0; part < 4; ++part) {
      const double width = (seams[i + 1] - seams[i]) / 4;
      all.push_back(by_fifteen(seen, seams[i] + part * width, seams[i] + (part + 1) * width));
    }
  std::make_heap(all.begin(), all.end(), worse);
  const auto error = [&] {
    double sum = 0;
    for (const Stretch15& s : all) sum += s.error;
    return sum;
  };
  while (all.size() < most && error() > 1e-12 * size) {
    std::pop_heap(all.begin(), all.end(), worse);
    const Stretch15 s = all.back();
    all.back() = by_fifteen(seen, s.from, (s.from + s.to) / 2);
    std::push_heap(all.begin(), all.end(), worse);
    all.push_back(by_fifteen(seen, (s.from + s.to) / 2, s.to));
    std::push_heap(all.begin(), all.end(), worse);
  }
  Sums sum{};
  for (const Stretch15& s : all)
    for (std::size_t i = 0; i < 4; ++i) sum[i] += s.sum[i];
  return sum;
}

}  // namespace

void CurveSet::integrate(const Curve& c, std::uint32_t k, double u, double* out) const {
  const double h = static_cast<double>(c.columns->times[c.first + k + 1] - c.columns->times[c.first + k]);
  const auto twerper = static_cast<Twerper>(c.columns->twerpers[c.first + k]);
  const CurveDetail* from = detail(c, k);
  const Eases eases = eases_of(from, detail(c, k + 1), h);
  std::vector<double> seams{0, eases.out, 1 - eases.in, u};
  for (const double s : joints(twerper, from))
    if (s > 0 && s < 1) seams.push_back(eases.time_of(s));
  std::erase_if(seams, [&](double x) { return x > u; });
  std::sort(seams.begin(), seams.end());
  seams.erase(std::unique(seams.begin(), seams.end()), seams.end());
  const auto value = [&](double x) {
    Sums n{};
    segment(c, k, x * h, n.data());
    return n;
  };
  Sums sum{};
  if (!polynomials(twerper))
    sum = by_halving(value, seams);
  else
    for (std::size_t i = 0; i + 1 < seams.size(); ++i) {
      const Sums one = by_five(value, seams[i], seams[i + 1]);
      for (std::size_t x = 0; x < 4; ++x) sum[x] += one[x];
    }
  for (std::size_t x = 0; x < c.channels; ++x) out[x] = sum[x] * h / static_cast<double>(flicks_per_second);
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/noise.h"

#include <bit>
#include <cstdint>

namespace betwixt {
namespace {

// The finalizer of SplitMix64: every bit of x affects every bit of the result.
std::uint64_t stir(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}
double fraction(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

// Returns the contribution of the lattice corner (i, j, k) at the distance `d`.
double corner(const std::int64_t* cell, Vec3 d, int dimensions) {
  std::uint64_t h = 0;
  for (int a = 0; a < dimensions; ++a) h = stir(h ^ static_cast<std::uint64_t>(cell[a]));
  Vec3 g;
  for (int a = 0; a < dimensions; ++a) g[a] = 2 * fraction(h = stir(h)) - 1;
  return dot(dimensions == 1 ? g : normalize(g, {1, 0, 0}), d);
}

}  // namespace

double noise(Vec3 at, int dimensions) {
  std::int64_t cell[3] = {0, 0, 0};
  Vec3 f, fade;
  for (int a = 0; a < dimensions; ++a) {
    if (!(std::abs(at[a]) < 1e15)) return 0;  // beyond this every number is whole
    const double low = std::floor(at[a]);
    cell[a] = static_cast<std::int64_t>(low);
    const double x = f[a] = at[a] - low;
    fade[a] = x * x * x * (x * (x * 6 - 15) + 10);
  }
  double sum = 0;
  for (int c = 0; c < 1 << dimensions; ++c) {
    std::int64_t at_corner[3];
    Vec3 d;
    double weight = 1;
    for (int a = 0; a < dimensions; ++a) {
      const int up = c >> a & 1;
      at_corner[a] = cell[a] + up;
      d[a] = f[a] - up;
      weight *= up ? fade[a] : 1 - fade[a];
    }
    sum += weight * corner(at_corner, d, dimensions);
  }
  return sum * 2 / std::sqrt(dimensions);  // the maximum is in the middle of a cell: half its diagonal
}

double hashed(Vec3 seed) {
  std::uint64_t h = 0;
  for (int a = 0; a < 3; ++a) h = stir(h ^ std::bit_cast<std::uint64_t>(seed[a] + 0.0));  // converts -0 to 0
  return fraction(h);
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Random numbers. Every run gets the same ones.
#pragma once

#include <cstdint>
#include <random>

#include "betwixt/math.h"

namespace betwixt {

using Random = std::mt19937_64;

inline double between(Random& r, double least, double most) { return std::uniform_real_distribution(least, most)(r); }
inline std::int64_t whole(Random& r, std::int64_t least, std::int64_t most) {
  return std::uniform_int_distribution<std::int64_t>(least, most)(r);
}
inline Vec3 vector(Random& r, double most) {
  return {between(r, -most, most), between(r, -most, most), between(r, -most, most)};
}

}  // namespace betwixt

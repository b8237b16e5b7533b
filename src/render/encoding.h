// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// From linear light to sRGB bytes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace betwixt {

// The sRGB curve, exactly.
inline double encoded(double c) {
  c = std::clamp(c, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

// The same within a quarter of a byte, in the numbers and the order of `encoded_function` (canvas.h), so that the bytes
// are those of the shaders.
inline float encoded_as_drawn(float c) {
  c = std::clamp(c, 0.0F, 1.0F);
  const float r2 = std::sqrt(c), r4 = std::sqrt(r2), r8 = std::sqrt(r4);
  const float curve = 0.662002687F * r2 + 0.684122060F * r4 - 0.323583601F * r8 - 0.0225411470F * c;
  return c < 0.0031308F ? 12.92F * c : curve;
}

inline std::uint8_t byte_of(double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); }

}  // namespace betwixt

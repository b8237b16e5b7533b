// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/noise.h"

#include <cmath>

#include "procedure/routines.h"

namespace betwixt {
namespace {

// shows: G17
TEST(Lua, MathAndNoise) {
  EXPECT_EQ(number("clamp(5, 0, 3) + smoothstep(0, 2, 1) + floor(2.7)"), 5.5);
  EXPECT_EQ(number("math.sin(1) - sin(1)"), 0);
  EXPECT_EQ(number("noise(3) + noise(1, 2) + noise(1, 2, 3)"), 0);  // zero on the lattice
  double low = 1, high = -1;
  for (int i = 0; i < 20000; ++i)
    for (int d = 1; d <= 3; ++d) {
      const double n = noise({i * 0.137, i * 0.071, i * 0.019}, d);
      low = std::min(low, n), high = std::max(high, n);
      const double step = noise({i * 0.137 + 1e-6, i * 0.071, i * 0.019}, d) - n;
      ASSERT_LT(std::abs(step), 1e-5);
    }
  EXPECT_GE(low, -1);
  EXPECT_LE(high, 1);
  EXPECT_LT(low, -0.6);
  EXPECT_GT(high, 0.6);
  double sum = 0;
  for (int i = 0; i < 10000; ++i) sum += hashed({double(i), 0, 0});
  EXPECT_NEAR(sum / 10000, 0.5, 0.02);
  EXPECT_EQ(number("random(7) - random(7)"), 0);
}

}  // namespace
}  // namespace betwixt

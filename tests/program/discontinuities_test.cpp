// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the times at which values may jump. Exporters use them.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

std::vector<double> jumps(std::string_view script, double after, double until) {
  const LoadedFilm film(script);
  std::vector<double> out;
  for (const Time t : film.program.discontinuities(from_seconds(after), from_seconds(until)))
    out.push_back(t.seconds());
  return out;
}

TEST(Discontinuities, AreBehindTheFirstTimeAndUpToTheLast) {
  const char* film = "create ball sphere\nball.radius\n  0s 1\n  1s 2 hold\n  2s 3 hold\n  3s 4 hold\n";
  EXPECT_EQ(jumps(film, 0, 3), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(jumps(film, 1, 2.5), (std::vector<double>{2}));
}

// Two minutes at 60 ticks a second, and in a film with thousands of keys.
TEST(Discontinuities, HaveEveryTickOfEnvironments) {
  std::string film =
      "ticks 60\ncreate ball sphere\nset ball.environments (spin)\nanimate spin every 1t by translate(1 0 0)\n";
  EXPECT_EQ(jumps(film, 0, 120).size(), 7200u);
  film += "create other sphere\nother.radius\n";
  for (int k = 0; k < 5000; ++k) film += fmt::format("  {}s {}\n", 0.001 * k, 1 + k % 2);
  const std::vector<double> all = jumps(film, 0, 10);
  for (int tick = 1; tick <= 600; ++tick)
    EXPECT_TRUE(std::binary_search(all.begin(), all.end(), tick / 60.0, [](double a, double b) {
      return a < b - 1e-9;
    })) << tick;
}

}  // namespace
}  // namespace betwixt

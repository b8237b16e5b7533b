// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/look_table.h"

#include <algorithm>
#include <array>

#include "render/curves.h"
#include "scene/light_in_stops.h"

namespace betwixt {
namespace {

// A place on an axis of the table: the entry below it, and the share of the way to the next.
struct PlaceBetween {
  std::size_t below = 0;
  double share = 0;
};
PlaceBetween place_on_axis(const ColorTable& t, int channel, double color) {
  const auto c = static_cast<std::size_t>(channel);
  const double least = static_cast<double>(t.least[c]), most = static_cast<double>(t.most[c]);
  double place = t.takes == ColorTable::stops
                     ? place_of_white / stops_to_white * own_log2(1 + dark_stops * std::max(color, 0.0))
                     : (color - least) / (most - least);
  place = (place > 0 ? std::min(place, 1.0) : 0) * (t.size - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(t.size - 2));
  return {below, place - static_cast<double>(below)};
}

double entry(const ColorTable& t, std::size_t at, int channel) {
  return static_cast<double>(t.signals[3 * at + static_cast<std::size_t>(channel)]);
}

}  // namespace

Vec3 looked_up(const ColorTable& t, Vec3 color) {
  std::array<PlaceBetween, 3> on;
  for (int c = 0; c < 3; ++c) on[static_cast<std::size_t>(c)] = place_on_axis(t, c, color[c]);
  Vec3 out;
  if (!t.cube) {
    for (int c = 0; c < 3; ++c) {
      const auto [below, share] = on[static_cast<std::size_t>(c)];
      out[c] = ((1 - share) * entry(t, below, c) + share * entry(t, below + 1, c)) / 65535;
    }
    return out;
  }
  // From the lowest corner to the highest along the axes, that with the largest share first.
  const auto side = static_cast<std::size_t>(t.size);
  const std::array<std::size_t, 3> step{1, side, side * side};
  std::array<std::size_t, 3> order{0, 1, 2};
  const auto first_of = [&](std::size_t a, std::size_t b) {
    if (on[order[a]].share < on[order[b]].share) std::swap(order[a], order[b]);
  };
  first_of(0, 1), first_of(1, 2), first_of(0, 1);
  std::size_t corner = on[0].below + side * (on[1].below + side * on[2].below);
  double before = 1;
  for (std::size_t k = 0; k <= 3; ++k) {
    const double after = k < 3 ? on[order[k]].share : 0, weight = before - after;
    for (int c = 0; c < 3; ++c) out[c] += weight * entry(t, corner, c);
    if (k < 3) corner += step[order[k]], before = after;
  }
  return (1.0 / 65535) * out;
}

}  // namespace betwixt

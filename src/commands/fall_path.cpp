// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/fall_path.h"

#include <cmath>
#include <utility>

namespace betwixt {

std::vector<FallMark> fall_path(Time start, Vec3 place, Vec3 speed, const FallLaws& laws) {
  std::vector<FallMark> marks;
  const Vec3 along{speed.x, 0, speed.z};
  const Time begin = start + laws.delay, end = begin + laws.length;
  if (laws.delay > Time{}) {
    marks.push_back({start, place, along, along});
    place = place + laws.delay.seconds() * along;
    speed.y = 0;
  }
  Time now = begin;
  double t = begin.seconds(), came = speed.y;
  for (int hops = 0; hops < 200; ++hops) {
    const auto vertical = [&](double v) { return Vec3{along.x, v, along.z}; };
    marks.push_back({now, place, vertical(came), vertical(speed.y)});
    // Solves y + speed·d - g/2·d² = ground.
    const double root = speed.y * speed.y + 2 * laws.gravity * (place.y - laws.ground);
    const double left = end.seconds() - t;
    if (!(root > 0) || (place.y <= laws.ground && speed.y <= 0)) break;  // it rests
    const double d = (speed.y + std::sqrt(root)) / laws.gravity;
    if (d >= left) {
      const double y = place.y + speed.y * left - laws.gravity / 2 * left * left;
      const Vec3 reached = place + left * along;
      marks.push_back({end, {reached.x, y, reached.z}, vertical(speed.y - laws.gravity * left), {}});
      break;
    }
    t += d;
    const Time before = std::exchange(now, from_seconds(t));
    came = speed.y - laws.gravity * d;
    place = place + (now - before).seconds() * along;
    place.y = laws.ground;
    speed.y = -came * laws.bounce;
    if (speed.y * speed.y / (2 * laws.gravity) < 1e-4) speed.y = 0;  // hops too low to see
  }
  marks.back().out = {};
  return marks;
}

}  // namespace betwixt

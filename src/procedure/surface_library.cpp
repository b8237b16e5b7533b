// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Surfaces: the graph of a formula of two numbers.
#include <algorithm>
#include <cmath>

#include "procedure/plotting.h"

namespace betwixt::lua {
namespace {

// The grid of a surface. A point that is not there is NaN.
struct Surface {
  Plotting& p;
  int faces;
  std::vector<Vec3> numbers;

  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j * (faces + 1) + i); }
  // Returns the numbers of the point at two shares of the axes; NaN outside the domain, and beyond the ends of z.
  Vec3 look(double u, double v) const {
    const double x = p.space.x.number_at(u), y = p.space.y.number_at(v), z = p.of(x, y).x;
    return {x, y, p.space.z.holds(z) ? z : std::numeric_limits<double>::quiet_NaN()};
  }
  void fill() {
    for (int j = 0; j <= faces; ++j)
      for (int i = 0; i <= faces; ++i) numbers.push_back(look(share(i), share(j)));
  }
  double share(int i) const { return static_cast<double>(i) / faces; }
  bool there(int i, int j) const {
    return i >= 0 && j >= 0 && i <= faces && j <= faces && std::isfinite(numbers[index(i, j)].z);
  }

  // Returns the last point of the surface on the way from a point that is there to one that is not.
  Vec3 edge(int i, int j, int to_i, int to_j) const {
    double there = 0, beyond = 1;
    Vec3 last = numbers[index(i, j)];
    for (int k = 0; k < 12; ++k) {
      const double m = (there + beyond) / 2;
      const Vec3 n = look(share(i) + m * (share(to_i) - share(i)), share(j) + m * (share(to_j) - share(j)));
      (std::isfinite(n.z) ? there : beyond) = m;
      if (std::isfinite(n.z)) last = n;
    }
    return last;
  }
  // Moves points just outside to the edge, so that the surface ends there and not at the last whole face.
  void reach_edges() {
    std::vector<std::pair<std::size_t, Vec3>> moved;
    for (int j = 0; j <= faces; ++j)
      for (int i = 0; i <= faces; ++i) {
        if (there(i, j)) continue;
        Vec3 sum{};
        int count = 0;
        for (const auto& [di, dj] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
          if (there(i + di, j + dj)) sum = sum + edge(i + di, j + dj, i, j), ++count;
        if (count > 0) moved.emplace_back(index(i, j), (1.0 / count) * sum);
      }
    for (const auto& [at, n] : moved) numbers[at] = n;
  }
};

}  // namespace

int surface_of(lua_State* l, Machine& m) {
  Plotting p;
  if (auto why = p.open(l, m); !why.empty()) return fail_with(l, why);
  if (p.space.kind != betwixt::Kind::axes || !(p.space.size.z > 0))
    return fail_with(l, "a surface needs axes with a z axis: give them a size of three numbers");
  if (!p.space.y.good() || !p.space.z.good()) return fail_with(l, "its axes have no length");
  Surface s{p, static_cast<int>(std::clamp(std::round(number_now(m, ".density")), 2.0, 200.0)), {}};
  s.fill();
  s.reach_edges();
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  for (Vec3& n : s.numbers) n = std::isfinite(n.z) ? p.space.place(n) : lifted;
  return push_points(l, s.numbers), 1;
}

}  // namespace betwixt::lua

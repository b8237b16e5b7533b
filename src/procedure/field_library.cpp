// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Vector fields: arrows and streamlines.
#include <algorithm>
#include <cmath>
#include <optional>

#include "procedure/plotting.h"

namespace betwixt::lua {
namespace {

// Returns the vector at a place as the axes show it: how a point that it moves goes in the picture, in metres a second.
Vec3 shown_way(Plotting& p, double x, double y) {
  const Vec3 v = p.of(x, y);
  const double fast = std::max(std::abs(v.x), std::abs(v.y));
  if (!(fast > 0)) return {fast, fast, 0};
  const double h = 1e-6 * std::abs(p.space.x.high - p.space.x.low) / fast;
  return (1 / h) * (p.space.place({x + h * v.x, y + h * v.y, 0}) - p.space.place({x, y, 0}));
}

// One arrow of a field: its outline, of a length that has no unit.
void add_arrow(std::vector<Vec3>& out, Vec3 middle, Vec3 way, double thick) {
  const double all = length(way);
  if (!(all > 1e-6)) return;
  const Vec3 along = (1 / all) * way, side{-along.y, along.x, 0};
  const double head = std::min(all * 0.5, 3.2 * thick), wide = head * 0.55, thin = std::min(thick, head * 0.4) / 2;
  const Vec3 start = middle - 0.5 * way, neck = middle + (0.5 - head / all) * way, tip = middle + 0.5 * way;
  if (!out.empty()) out.push_back(lifted);
  for (const Vec3 p : {start - thin * side, neck - thin * side, neck - wide * side, tip, neck + wide * side,
                       neck + thin * side, start + thin * side})
    out.push_back(p);
}

// A point of a streamline: its place, the direction there, and the length of the line from its seed.
struct StreamPoint {
  Vec3 at, way;
  double along = 0;
};
using Stream = std::vector<StreamPoint>;

// Lines along a field that keep a distance from each other: each new one begins beside a line that is there (Jobard and
// Lefer, 1997), or at a place of a grid that is still empty.
class Streams {
 public:
  Streams(Plotting& p, double apart) : p_(p), apart_(apart), step_(apart / 6), half_(0.5 * p.space.size) {
    columns_ = cell(half_.x, half_.x) + 1, rows_ = cell(half_.y, half_.y) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  }

  std::vector<Stream> all() {
    const int columns = std::max(1, static_cast<int>(2 * half_.x / apart_)),
              rows = std::max(1, static_cast<int>(2 * half_.y / apart_));
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) {
        grow({(2 * (i + 0.5) / columns - 1) * half_.x, (2 * (j + 0.5) / rows - 1) * half_.y, 0});
        for (; next_ < lines_.size(); ++next_)
          for (std::size_t k = 0; k < lines_[next_].size(); ++k)
            for (const double side : {-1.0, 1.0}) {
              const auto& [at, way, along] = lines_[next_][k];
              grow(at + side * apart_ * Vec3{-way.y, way.x, 0});
            }
      }
    return std::move(lines_);
  }

 private:
  struct Known {
    Vec3 at;
    std::size_t line;
    double along;
  };

  int cell(double x, double half) const { return static_cast<int>((x + half) / apart_); }
  bool inside(Vec3 p) const { return std::abs(p.x) <= half_.x && std::abs(p.y) <= half_.y; }

  std::optional<Vec3> direction(Vec3 place) {
    const auto n = p_.space.numbers_at(place);
    if (!n) return std::nullopt;
    const Vec3 way = shown_way(p_, n->x, n->y);
    const double fast = length(way);
    return std::isfinite(fast) && fast > 1e-9 ? std::optional((1 / fast) * way) : std::nullopt;
  }

  // Calls with each known point within a distance, until one returns true.
  template <class F>
  bool any_near(Vec3 at, double distance, const F& f) const {
    const int x = cell(at.x, half_.x), y = cell(at.y, half_.y);
    for (int j = std::max(0, y - 1); j <= std::min(rows_ - 1, y + 1); ++j)
      for (int i = std::max(0, x - 1); i <= std::min(columns_ - 1, x + 1); ++i)
        for (const Known& k : cells_[static_cast<std::size_t>(j * columns_ + i)])
          if (const Vec3 d = k.at - at; d.x * d.x + d.y * d.y < distance * distance && f(k)) return true;
    return false;
  }
  void know(const StreamPoint& p) {
    const int x = std::clamp(cell(p.at.x, half_.x), 0, columns_ - 1),
              y = std::clamp(cell(p.at.y, half_.y), 0, rows_ - 1);
    cells_[static_cast<std::size_t>(y * columns_ + x)].push_back({p.at, lines_.size(), p.along});
  }

  // One step of Runge and Kutta of the fourth order, against the field if `sign` is -1.
  std::optional<Vec3> stepped(const StreamPoint& from, double sign) {
    const double h = sign * step_;
    const Vec3 a = from.way;
    const auto b = direction(from.at + h / 2 * a);
    const auto c = b ? direction(from.at + h / 2 * *b) : b;
    const auto d = c ? direction(from.at + h * *c) : c;
    if (!d) return std::nullopt;
    return from.at + h / 6 * (a + 2 * *b + 2 * *c + *d);
  }

  // Follows the field from the last point. Returns true if the line comes back to its seed.
  bool follow(Stream& line, double sign) {
    StreamPoint here = line.back();
    const Vec3 seed = here.at;
    for (double along = step_; along < 40 * (half_.x + half_.y); along += step_) {
      const auto at = stepped(here, sign);
      if (!at || !inside(*at)) return false;
      const auto way = direction(*at);
      if (!way) return false;
      if (along > 3 * step_ && length(*at - seed) < 1.1 * step_) {
        line.push_back({seed, line.front().way, along});
        return true;
      }
      const auto meets = [&](const Known& k) {
        if (k.line != lines_.size()) return true;
        const double between = std::abs(sign * along - k.along);
        return between > 2 * apart_ && std::abs(k.along) > apart_ / 2;  // near its seed it may close
      };
      if (any_near(*at, apart_ / 2, meets)) return false;
      here = {*at, *way, sign * along};
      line.push_back(here), know(here);
    }
    return false;
  }

  void grow(Vec3 seed) {
    if (!inside(seed) || any_near(seed, 0.98 * apart_, [](const Known&) { return true; })) return;
    const auto way = direction(seed);
    if (!way) return;
    Stream line{{seed, *way, 0}};
    know(line[0]);
    const bool closed = follow(line, 1);
    if (!closed) {
      Stream back{line[0]};
      follow(back, -1);
      line.insert(line.begin(), back.rbegin(), back.rend() - 1);
    }
    // A short line stays known: nothing longer begins there.
    if (line.back().along - line.front().along < apart_) line.clear();
    lines_.push_back(std::move(line));
  }

  Plotting& p_;
  double apart_, step_;
  Vec3 half_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<Known>> cells_;
  std::vector<Stream> lines_;
  std::size_t next_ = 0;  // the first line beside which no other was tried
};

// Puts points between those of a line, on cubics with its directions.
std::vector<Vec3> smooth(const Stream& line) {
  std::vector<Vec3> out;
  constexpr int pieces = 3;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const StreamPoint &a = line[i], &b = line[i + 1];
    const double h = length(b.at - a.at);
    for (int k = 0; k < pieces; ++k) {
      const double u = static_cast<double>(k) / pieces, v = 1 - u;
      out.push_back(v * v * (1 + 2 * u) * a.at + u * u * (3 - 2 * u) * b.at + h * u * v * (v * a.way - u * b.way));
    }
  }
  if (!line.empty()) out.push_back(line.back().at);
  return out;
}

// Adds the part of a line between two lengths from its beginning.
void add_part(std::vector<Vec3>& out, const std::vector<Vec3>& line, double from, double to) {
  double before = 0;
  bool down = false;
  for (std::size_t i = 0; i + 1 < line.size() && before < to; ++i) {
    const double way = length(line[i + 1] - line[i]), a = std::max(0.0, from - before), b = std::min(way, to - before);
    if (way > 0 && a < b) {
      const auto at = [&](double s) { return line[i] + s / way * (line[i + 1] - line[i]); };
      if (!down && !out.empty()) out.push_back(lifted);
      if (!down) out.push_back(at(a));
      out.push_back(at(b)), down = true;
    }
    before += way;
  }
}

// Adds the head of an arrow at the middle of a line.
void add_head(std::vector<Vec3>& out, const Stream& line, double size) {
  const StreamPoint& p = line[line.size() / 2];
  const Vec3 back = p.at - size * p.way, side = 0.5 * size * Vec3{-p.way.y, p.way.x, 0};
  out.insert(out.end(), {lifted, back + side, p.at, back - side});
}

}  // namespace

int field_of(lua_State* l, Machine& m) {
  Plotting p;
  if (auto why = p.open(l, m); !why.empty()) return fail_with(l, why);
  const double across = std::max(p.space.size.x, p.space.size.y);
  const double density = std::clamp(number_now(m, ".density"), 1.0, 100.0), cell = across / density;
  const int columns = std::max(1, static_cast<int>(p.space.size.x / cell)),
            rows = std::max(1, static_cast<int>(p.space.size.y / cell));
  struct Arrow {
    Vec3 at, way;
  };
  std::vector<Arrow> all;
  double longest = 0;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = p.space.x.number_at((i + 0.5) / columns), y = p.space.y.number_at((j + 0.5) / rows);
      const Vec3 way = shown_way(p, x, y);
      if (!std::isfinite(way.x) || !std::isfinite(way.y)) continue;
      all.push_back({p.space.place({x, y, 0}), way}), longest = std::max(longest, length(way));
    }
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  std::vector<Vec3> out;
  for (const Arrow& a : all) {
    const double share = longest > 0 ? length(a.way) / longest : 0;
    // Short arrows are a little longer than they should be, so that their direction is seen.
    add_arrow(out, a.at, (0.9 * cell * std::sqrt(share)) * normalize(a.way, {0, 0, 0}), 0.07 * cell);
  }
  return push_points(l, out), 1;
}

int streamlines_of(lua_State* l, Machine& m) {
  Plotting p;
  if (auto why = p.open(l, m); !why.empty()) return fail_with(l, why);
  if ((p.space.kind != betwixt::Kind::axes && p.space.kind != betwixt::Kind::plane_grid) || !p.space.y.good() ||
      !(p.space.size.y > 0))
    return fail_with(l, "streamlines need axes with x and y");
  const double density = std::clamp(number_now(m, ".density"), 1.0, 100.0);
  const double apart = std::max(p.space.size.x, p.space.size.y) / density;
  const double drawn = std::clamp(number_now(m, ".drawn"), 0.0, 1.0), flow = number_now(m, ".flow");
  const std::vector<Stream> all = Streams(p, apart).all();
  if (!p.of.problem().empty()) return fail_with(l, p.of.problem());
  std::vector<Vec3> out;
  const double period = 3 * apart;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].empty()) continue;
    const std::vector<Vec3> line = smooth(all[i]);
    if (drawn >= 1) {
      if (!out.empty()) out.push_back(lifted);
      out.insert(out.end(), line.begin(), line.end());
      add_head(out, all[i], 0.22 * apart);
      continue;
    }
    double whole = 0;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) whole += length(line[k + 1] - line[k]);
    // The golden ratio spreads where the pieces of neighbours are.
    const double shift = flow + 0.618033988749895 * static_cast<double>(i);
    for (double s = (shift - std::floor(shift) - 1) * period; s < whole; s += period)
      add_part(out, line, std::max(0.0, s), s + drawn * period);
  }
  return push_points(l, out), 1;
}

}  // namespace betwixt::lua

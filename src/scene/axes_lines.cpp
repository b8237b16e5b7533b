// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the pieces of axes are.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/utf8.h"
#include "scene/axes.h"

namespace betwixt {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr Vec3 pen_up{endless, endless, endless};
constexpr double half_tick = 0.07;  // metres
constexpr double past_end = 0.25;   // how far an axis goes on behind its last number

double length_of(const AxesSpace& s, char axis) {
  if (s.kind == Kind::polar_axes) return s.size.x / 2;
  return axis == 'y' ? s.size.y : axis == 'z' ? s.size.z : s.size.x;
}

// Returns the point of an axis at a number.
Vec3 on_axis(const AxesSpace& s, char axis, double number) {
  if (s.kind == Kind::number_line || s.kind == Kind::polar_axes) return s.place({number, 0, 0});
  const double x = crossing(s.x), y = crossing(s.y), z = s.size.z > 0 ? crossing(s.z) : 0;
  if (axis == 'y') return s.place({x, number, z});
  if (axis == 'z') return s.place({x, y, number});
  return s.place({number, y, z});
}

Vec3 across(char axis) { return axis == 'x' ? Vec3{0, 1, 0} : Vec3{1, 0, 0}; }

double width_of_label(const std::string& label, double em) {
  double letters = 0;
  for (const char c : label) letters += begins_character(c) ? 1 : 0;
  return 0.64 * em * letters;  // a digit of DejaVu Sans has 0.636
}

// Returns whether the other axis crosses inside, so that the label of this number would be on it.
bool crossed(const AxesSpace& s, char axis, double number) {
  if (s.kind != Kind::axes && s.kind != Kind::plane_grid) return false;
  if (axis == 'z') return false;
  const Axis &own = s.axis(axis), &other = s.axis(axis == 'x' ? 'y' : 'x');
  const double here = other.share(crossing(other)), there = own.share(number);
  const double at = own.share(crossing(own));
  // At the end of the axis only 0 can be left out: the other axis has it too.
  return here > 0.02 && std::abs(there - at) < 1e-9 && (at > 1e-9 || number == 0);
}

void add(std::vector<Vec3>& out, std::initializer_list<Vec3> points) {
  if (!out.empty()) out.push_back(pen_up);
  out.insert(out.end(), points);
}

void add_circle(std::vector<Vec3>& out, double radius) {
  constexpr int sides = 96;
  if (!out.empty()) out.push_back(pen_up);
  for (int i = 0; i <= sides; ++i) {
    const double a = 2 * pi * i / sides;
    out.push_back({radius * std::cos(a), radius * std::sin(a), 0});
  }
}

std::vector<Vec3> polar_grid(const AxesSpace& s) {
  std::vector<Vec3> out;
  for (const double r : ticks_of(s.x, s.size.x / 2, 0.5))
    if (const double place = s.place({r, 0, 0}).x; place > 1e-9) add_circle(out, place);
  for (int i = 0; i < 12; ++i) add(out, {{0, 0, 0}, s.place({s.x.high, i * pi / 6, 0})});
  return out;
}

}  // namespace

double crossing(const Axis& other) {
  if (other.scale == AxisScale::log) return other.low;
  const double low = std::min(other.low, other.high), high = std::max(other.low, other.high);
  return low > 0 ? low : high < 0 ? high : 0;
}

std::size_t most_labels(double length) { return static_cast<std::size_t>(std::clamp(length / 0.5, 0.0, 60.0)) + 2; }

Ticks ticks_of(const AxesSpace& s, char name) {
  const Axis& axis = s.axis(name);
  const double length = length_of(s, name), em = s.digits;
  const bool flat = name == 'x';  // its labels are beside one another
  double apart = flat ? std::max(0.9, 3 * em) : std::max(0.6, 2 * em);
  Ticks out;
  for (int attempt = 0;; ++attempt) {
    out.numbers = ticks_of(axis, length, apart);
    const double step = tick_step(axis, length, apart);
    out.labels.clear();
    double widest = 0;
    for (const double n : out.numbers) {
      out.labels.push_back(tick_label(axis, n, step));
      widest = std::max(widest, width_of_label(out.labels.back(), em));
    }
    const double room = flat ? widest + 0.5 * em : 1.3 * em;
    const auto count = static_cast<double>(out.numbers.size());
    const double between =
        count > 1 ? length * std::abs(axis.share(out.numbers.back()) - axis.share(out.numbers[0])) / (count - 1)
                  : length;
    if (between >= room && out.numbers.size() <= most_labels(length)) break;
    if (axis.step <= 0 && attempt < 8 && axis.scale != AxisScale::log) {
      apart = std::max(apart * 1.3, room);
      continue;
    }
    // The step is the author's: only some of the ticks have labels.
    const double fewer = std::max(room / std::max(between, 1e-9), count / static_cast<double>(most_labels(length)));
    const auto every = static_cast<std::size_t>(std::ceil(fewer - 1e-9));
    const auto zero = std::min<std::size_t>(
        static_cast<std::size_t>(std::find(out.numbers.begin(), out.numbers.end(), 0.0) - out.numbers.begin()),
        out.numbers.size());
    const std::size_t phase = zero < out.numbers.size() ? zero % every : 0;
    for (std::size_t i = 0; i < out.labels.size(); ++i)
      if (i % every != phase) out.labels[i].clear();
    break;
  }
  for (std::size_t i = 0; i < out.labels.size(); ++i)
    if (crossed(s, name, out.numbers[i])) out.labels[i].clear();
  return out;
}

Vec3 axis_tip(const AxesSpace& s, char name) {
  const Axis& axis = s.axis(name);
  const Vec3 from = on_axis(s, name, axis.low), to = on_axis(s, name, axis.high);
  return to + (s.kind == Kind::polar_axes ? 0 : past_end) * normalize(to - from, {1, 0, 0});
}

std::vector<Vec3> axis_line(const AxesSpace& s, char name) {
  const Axis& axis = s.axis(name);
  if (!axis.good()) return {};
  const Vec3 from = on_axis(s, name, axis.low), to = on_axis(s, name, axis.high);
  const Vec3 along = normalize(to - from, {1, 0, 0}), side = across(name);
  std::vector<Vec3> out;
  const double tip = 0.13;
  const Vec3 end = axis_tip(s, name);
  add(out, {from - (s.kind == Kind::number_line ? past_end : 0) * along, end});
  if (s.kind != Kind::polar_axes)
    add(out, {end - tip * along + 0.6 * tip * side, end, end - tip * along - 0.6 * tip * side});
  if (s.kind == Kind::number_line) {
    const Vec3 start = from - past_end * along;
    add(out, {start + tip * along + 0.6 * tip * side, start, start + tip * along - 0.6 * tip * side});
  }
  for (const double n : ticks_of(s, name).numbers) {
    const Vec3 p = on_axis(s, name, n);
    add(out, {p - half_tick * side, p + half_tick * side});
  }
  return out;
}

std::vector<Vec3> grid_lines(const AxesSpace& s) {
  if (!s.x.good()) return {};
  if (s.kind == Kind::polar_axes) return polar_grid(s);
  std::vector<Vec3> out;
  if (!s.y.good()) return {};
  const double z = s.size.z > 0 ? crossing(s.z) : 0;
  for (const double x : ticks_of(s, 'x').numbers) add(out, {s.place({x, s.y.low, z}), s.place({x, s.y.high, z})});
  for (const double y : ticks_of(s, 'y').numbers) add(out, {s.place({s.x.low, y, z}), s.place({s.x.high, y, z})});
  return out;
}

Vec3 label_place(const AxesSpace& s, char name, double number) {
  const Vec3 p = on_axis(s, name, number);
  // Letters are about 0.7 em high; the place is that of the middle of the base line, or of the right end.
  if (name == 'x') return p + Vec3{0, -half_tick - 1.15 * s.digits, 0};
  return p + Vec3{-half_tick - 0.4 * s.digits, -0.36 * s.digits, 0};
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Coordinates that axes give: from numbers to places and back, and readable ticks with their labels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "betwixt/shape.h"

namespace betwixt {

enum class AxisScale : std::uint8_t { linear, log, time };

// An axis: its ends, and the distance of its ticks; a step of 0 is chosen. The ends of a reversed axis are swapped.
struct Axis {
  double low = 0, high = 1, step = 0;
  AxisScale scale = AxisScale::linear;
  // Returns whether it has a length, and a logarithmic one no numbers below or at 0.
  bool good() const;
  double share(double number) const;  // 0 at `low`, 1 at `high`; NaN outside a logarithmic scale
  double number_at(double share) const;
  bool holds(double number) const;  // between its ends, with the rounding errors of ticks
};

// The space of one object that has coordinates. Its origin is the middle of its axes, in metres.
struct AxesSpace {
  Kind kind = Kind::axes;
  Axis x, y, z;
  Vec3 size{8, 4, 0};                // in metres; z 0: the axes are flat
  Vec3 right{1, 0, 0}, up{0, 1, 0};  // of a plane grid: the images of (1 0) and (0 1)
  double digits = 0.26;              // the size of numbers, an em in metres
  const Axis& axis(char name) const { return name == 'y' ? y : name == 'z' ? z : x; }
  // Returns the place of numbers, in the object's own space; NaN if there is none (the logarithm of a negative number).
  Vec3 place(Vec3 numbers) const;
  std::optional<Vec3> numbers_at(Vec3 place) const;
};

inline constexpr std::size_t most_ticks = 200;
// Returns the numbers of ticks, in order. Without a step, about one tick for each `apart` of `length` metres.
std::vector<double> ticks_of(const Axis&, double length, double apart = 0.9);
// Returns the distance of the ticks: the step if one is given.
double tick_step(const Axis&, double length, double apart = 0.9);
// Returns the label of a tick: with as many decimals as the step needs, large and small numbers as powers of ten.
std::string tick_label(const Axis&, double number, double step);

// The ticks of one axis, each with its label; "" if there is no room for it, or if another axis crosses there.
struct Ticks {
  std::vector<double> numbers;
  std::vector<std::string> labels;
};
Ticks ticks_of(const AxesSpace&, char axis);
// Returns how many labels an axis of this length can have at most.
std::size_t most_labels(double length);
// Returns the number of the other axis at which an axis lies: 0, or the nearest one that is there.
double crossing(const Axis& other);

// The lines of axes, as points with breaks (see Shape). `axis`: x, y or z, with its ticks and its tip.
std::vector<Vec3> axis_line(const AxesSpace&, char axis);
Vec3 axis_tip(const AxesSpace&, char axis);
std::vector<Vec3> grid_lines(const AxesSpace&);
// Returns the middle of the label of a number.
Vec3 label_place(const AxesSpace&, char axis, double number);

}  // namespace betwixt

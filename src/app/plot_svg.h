// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Draws values against time as SVG.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "betwixt/time.h"

namespace betwixt {

// x: frame numbers, y: values.
using Stroke = std::vector<std::pair<double, double>>;

// The curve of one number of a target. A jump ends one stroke and begins the next.
struct DrawnCurve {
  std::string name;
  std::vector<Stroke> strokes;
  Stroke events;
};

struct Plot {
  std::string title;
  double first = 1, last = 2;  // frames
  Rate rate;
  std::vector<DrawnCurve> curves;
};

std::string to_svg(const Plot&);

// Returns round numbers that divide low to high into at most `most` parts.
std::vector<double> ticks(double low, double high, int most);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The outlines that the paths of an SVG fill and stroke, and the look of a path.
#pragma once

#include <memory>
#include <vector>

#include "exchange/drawing.h"
#include "exchange/flattener.h"
#include "exchange/svg_style.h"

namespace betwixt {

inline constexpr double farthest_drawn = 1e6;  // in heights of the drawing

struct SvgGradient;  // exchange/svg_gradients.h

struct SvgPaint {
  bool there = false;
  Color color;
  double opacity = 1;
  std::shared_ptr<const SvgGradient> gradient;  // null if it has none
};

struct SvgLook {
  SvgPaint fill, stroke;
  double width = 0;
  bool round = false, square = false, even_odd = false;
  double dash = 0, gap = 0;
};

// Returns the outlines that a path fills and strokes. If one outline can express both, returns that one.
std::vector<DrawnThing> outlined(const std::vector<Flattener::Run>&, const SvgLook&);
// Puts each object's origin into the middle of its shapes, so that it turns about it, and each a little in front of
// the earlier ones.
void place_in_middles(std::vector<DrawnThing>&);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How a path of an SVG is filled and stroked, by its style and its surroundings.
#pragma once

#include <string_view>

#include "exchange/drawing.h"
#include "exchange/svg_elements.h"
#include "exchange/svg_gradients.h"
#include "exchange/svg_left_out.h"
#include "exchange/svg_outlines.h"

namespace betwixt {

// The state that an element inherits.
struct SvgAround {
  Affine to;
  SvgStyle style;
  double opacity = 1;
  std::uint32_t group = DrawnThing::nothing;
  Viewport viewport;
  std::size_t depth = 0;
};

// `name`: of the element, for what is left out.
SvgLook svg_look(const SvgAround&, std::string_view name, const SvgIds&, const SvgRules&, SvgLeftOut&);

}  // namespace betwixt

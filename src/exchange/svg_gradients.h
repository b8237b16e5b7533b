// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gradients of an SVG, and how they lie on an outline as gradients of the film.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "betwixt/gradient.h"
#include "exchange/drawing.h"
#include "exchange/svg_elements.h"
#include "exchange/svg_style.h"

namespace betwixt {

using SvgIds = std::unordered_map<std::string_view, pugi::xml_node>;

struct SvgGradient {
  bool radial = false, of_box = true;  // of_box: its numbers are shares of the box of the element
  bool focal = false;                  // its focus is not in its middle
  GradientSpread spread = GradientSpread::pad;
  Affine transform;
  double x = 0, y = 0, to_x = 1, to_y = 0, radius = 0.5;  // of a radial one, its middle and radius
  std::vector<std::pair<double, SvgColor>> stops;         // by place, at least one
  SvgColor middle() const;
};
// Returns nullopt if the id is of no gradient, or of one without stops.
std::optional<SvgGradient> gradient_with(std::string_view id, const Viewport&, const SvgIds&, const SvgRules&);

// Returns the gradient of an outline with this box. `to`: from the space of the element to that of the outline;
// `element`: the box of the element in its own space. The kind is `none` if it has no direction or no extent.
DrawnGradient laid_on(const Box& outline, const SvgGradient&, const Affine& to, const Box& element);

}  // namespace betwixt

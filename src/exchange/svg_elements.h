// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The elements of an SVG: their names and attributes, boxes, and basic shapes.
#pragma once

#include <cmath>
#include <initializer_list>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "exchange/svg_path.h"

namespace betwixt {

// The reference sizes of percentages, in user units.
struct Viewport {
  double width = 300, height = 150;
  double diagonal() const { return std::sqrt((width * width + height * height) / 2); }
};

std::string_view local_name(pugi::xml_node);
inline std::string_view said_in(pugi::xml_node node, const char* name) { return node.attribute(name).value(); }
std::string_view reference_of(pugi::xml_node);  // the id that its href names
bool any_of_these(std::string_view word, std::initializer_list<std::string_view> all);
// Returns the transform from the space of an element's viewBox to its viewport.
Affine fitted(pugi::xml_node, Viewport& inner, double width, double height);
// Returns the equivalent path, or nullopt if the element is no shape.
std::optional<std::string> path_of(pugi::xml_node, std::string_view tag, const Viewport&);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gradients of an SVG, which are drawn with their middle colour.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string_view>
#include <unordered_map>

#include "exchange/svg_style.h"

namespace betwixt {

using SvgIds = std::unordered_map<std::string_view, pugi::xml_node>;
// Returns the colour in the middle of a gradient, or nullopt if the id is of none.
std::optional<SvgColor> middle_of_gradient(std::string_view id, const SvgIds&, const SvgRules&);

}  // namespace betwixt

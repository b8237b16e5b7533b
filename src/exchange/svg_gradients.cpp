// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/svg_gradients.h"

#include <utility>
#include <vector>

#include "exchange/svg_elements.h"

namespace betwixt {
namespace {

SvgColor at_middle(const std::vector<std::pair<double, SvgColor>>& stops) {
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const auto& [at, color] = stops[i];
    if (at < 0.5) continue;
    if (i == 0 || at == 0.5) return color;
    const auto& [from, before] = stops[i - 1];
    const double s = (0.5 - from) / (at - from);
    const auto mixed = [s](double a, double b) { return (1 - s) * a + s * b; };
    return {{mixed(before.color.r, color.color.r), mixed(before.color.g, color.color.g),
             mixed(before.color.b, color.color.b)},
            mixed(before.opacity, color.opacity)};
  }
  return stops.back().second;
}

}  // namespace

std::optional<SvgColor> middle_of_gradient(std::string_view id, const SvgIds& ids, const SvgRules& rules) {
  for (int steps = 0; steps < 16; ++steps) {  // a gradient may take its stops from another
    const auto found = ids.find(id);
    if (found == ids.end()) return std::nullopt;
    const pugi::xml_node node = found->second;
    if (!any_of_these(local_name(node), {"linearGradient", "radialGradient"})) return std::nullopt;
    std::vector<std::pair<double, SvgColor>> stops;
    for (const pugi::xml_node stop : node.children()) {
      if (local_name(stop) != "stop") continue;
      SvgStyle style;
      for (const pugi::xml_attribute a : stop.attributes()) style.set(a.name(), a.value());
      rules.apply({"stop", said_in(stop, "id"), said_in(stop, "class")}, style);
      style.read(said_in(stop, "style"));
      const std::string_view said = style[Property::stop_color];
      SvgColor color =
          svg_color(said.empty() ? "black" : said, style[Property::color]).value_or(SvgColor{{0, 0, 0}, 1});
      color.opacity *= svg_opacity(style[Property::stop_opacity]);
      stops.emplace_back(svg_length(said_in(stop, "offset"), 1).value_or(0), color);
    }
    if (!stops.empty()) return at_middle(stops);
    id = reference_of(node);
  }
  return std::nullopt;
}

}  // namespace betwixt

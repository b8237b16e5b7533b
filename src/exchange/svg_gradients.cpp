// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/svg_gradients.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace betwixt {
namespace {

SvgColor between_colors(const SvgColor& a, const SvgColor& b, double s) {
  const auto mixed = [s](double x, double y) { return (1 - s) * x + s * y; };
  return {{mixed(a.color.r, b.color.r), mixed(a.color.g, b.color.g), mixed(a.color.b, b.color.b)},
          mixed(a.opacity, b.opacity)};
}

std::vector<std::pair<double, SvgColor>> stops_in(pugi::xml_node node, const SvgRules& rules) {
  std::vector<std::pair<double, SvgColor>> stops;
  for (const pugi::xml_node stop : node.children()) {
    if (local_name(stop) != "stop") continue;
    SvgStyle style;
    for (const pugi::xml_attribute a : stop.attributes()) style.set(a.name(), a.value());
    rules.apply({"stop", said_in(stop, "id"), said_in(stop, "class")}, style);
    style.read(said_in(stop, "style"));
    const std::string_view said = style[Property::stop_color];
    SvgColor color = svg_color(said.empty() ? "black" : said, style[Property::color]).value_or(SvgColor{{0, 0, 0}, 1});
    color.opacity *= svg_opacity(style[Property::stop_opacity]);
    const double at = std::clamp(svg_length(said_in(stop, "offset"), 1).value_or(0), 0.0, 1.0);
    stops.emplace_back(stops.empty() ? at : std::max(at, stops.back().first), color);
  }
  return stops;
}

// Files mix sRGB values. So colours are added between those of the file, as many as a gradient may have.
std::string written_stops(const std::vector<std::pair<double, SvgColor>>& stops) {
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < stops.size(); ++i) pairs += stops[i].first > stops[i - 1].first ? 1 : 0;
  const std::size_t each = pairs > 0 ? std::min<std::size_t>(1 + (most_stops - stops.size()) / pairs, 8) : 1;
  std::string out;
  const auto add = [&](double at, const SvgColor& c) {
    const auto byte = [](double v) { return std::lround(255 * std::clamp(v, 0.0, 1.0)); };
    out += fmt::format("{}#{:02x}{:02x}{:02x}", out.empty() ? "" : ", ", byte(c.color.r), byte(c.color.g),
                       byte(c.color.b));
    if (c.opacity < 1) out += fmt::format("{:02x}", byte(c.opacity));
    out += fmt::format(" {:.4g}%", 100 * at);
  };
  for (std::size_t i = 0; i < stops.size(); ++i) {
    add(stops[i].first, stops[i].second);
    const bool goes = i + 1 < stops.size() && stops[i + 1].first > stops[i].first;
    for (std::size_t k = 1; goes && k < each; ++k) {
      const double s = static_cast<double>(k) / static_cast<double>(each);
      add((1 - s) * stops[i].first + s * stops[i + 1].first, between_colors(stops[i].second, stops[i + 1].second, s));
    }
  }
  return out;
}

}  // namespace

SvgColor SvgGradient::middle() const {
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const auto& [at, color] = stops[i];
    if (at < 0.5) continue;
    if (i == 0 || at == 0.5) return color;
    const auto& [from, before] = stops[i - 1];
    return between_colors(before, color, (0.5 - from) / (at - from));
  }
  return stops.back().second;
}

std::optional<SvgGradient> gradient_with(std::string_view id, const Viewport& viewport, const SvgIds& ids,
                                         const SvgRules& rules) {
  SvgGradient g;
  std::vector<pugi::xml_node> all;  // a gradient takes what it does not say from another
  for (int steps = 0; steps < 16; ++steps) {
    const auto found = ids.find(id);
    if (found == ids.end() || !any_of_these(local_name(found->second), {"linearGradient", "radialGradient"})) break;
    all.push_back(found->second);
    if (g.stops.empty()) g.stops = stops_in(found->second, rules);
    id = reference_of(found->second);
  }
  if (all.empty() || g.stops.empty()) return std::nullopt;
  const auto said = [&](const char* name) {
    for (const pugi::xml_node node : all)
      if (const std::string_view is = said_in(node, name); !is.empty()) return is;
    return std::string_view();
  };
  g.radial = local_name(all[0]) == "radialGradient";
  g.of_box = said("gradientUnits") != "userSpaceOnUse";
  const std::string_view spread = said("spreadMethod");
  g.spread = spread == "repeat"    ? GradientSpread::repeat
             : spread == "reflect" ? GradientSpread::reflect
                                   : GradientSpread::pad;
  g.transform = transform_in(said("gradientTransform")).value_or(Affine{});
  const double width = g.of_box ? 1 : viewport.width, height = g.of_box ? 1 : viewport.height,
               both = g.of_box ? 1 : viewport.diagonal();
  const auto number = [&](const char* name, double whole, double share) {
    return svg_length(said(name), whole).value_or(share * whole);
  };
  if (g.radial) {
    g.x = number("cx", width, 0.5), g.y = number("cy", height, 0.5), g.radius = number("r", both, 0.5);
    g.focal = number("fx", width, g.x / width) != g.x || number("fy", height, g.y / height) != g.y;
  } else {
    g.x = number("x1", width, 0), g.y = number("y1", height, 0);
    g.to_x = number("x2", width, 1), g.to_y = number("y2", height, 0);
  }
  return g;
}

DrawnGradient laid_on(const Box& outline, const SvgGradient& g, const Affine& to, const Box& element) {
  const Vec3 low = element.low, size = element.high - element.low;
  const Affine box{size.x, 0, 0, size.y, low.x, low.y};
  const Affine all = g.of_box ? to * box * g.transform : to * g.transform;
  const double width = outline.high.x - outline.low.x, height = outline.high.y - outline.low.y;
  const Vec3 middle = 0.5 * (outline.low + outline.high);
  const double least = 1e-9 * std::max(width, height), d = all.a * all.d - all.b * all.c;
  DrawnGradient out;
  if (!(std::max(width, height) > 0) || !all.sane() || !(std::abs(d) > 0)) return out;
  Vec3 moved;
  if (g.radial) {
    const double across = g.radius * std::hypot(all.a, all.c), up = g.radius * std::hypot(all.b, all.d);
    const bool circle = std::abs(across - up) <= 0.02 * std::max(across, up) || width < least || height < least;
    out.kind = static_cast<std::uint32_t>(circle ? GradientKind::circular : GradientKind::radial);
    out.size =
        circle ? 2 * std::max(across, up) / std::max(width, height) : std::sqrt(2 * across / width * (2 * up / height));
    moved = all(Vec3{g.x, g.y, 0}) - middle;
  } else {
    // The place along it is a linear function of the outline's space, whose slope is `slope`.
    const double x = g.to_x - g.x, y = g.to_y - g.y, square = x * x + y * y;
    const Vec3 slope{(all.d * x - all.b * y) / (d * square), (all.a * y - all.c * x) / (d * square), 0};
    const double steep = length(slope);
    if (!(square > 0) || !(steep > 0) || !std::isfinite(steep)) return out;
    const Vec3 along = 1 / steep * slope;
    out.kind = static_cast<std::uint32_t>(GradientKind::linear);
    out.turn = std::atan2(along.y, along.x);
    out.size = 1 / (steep * std::max(width * std::abs(along.x) + height * std::abs(along.y), least));
    const double by = 0.5 / steep - dot(middle - all(Vec3{g.x, g.y, 0}), along);
    // Only what is along it counts, so a box without a height or a width moves it by the other.
    moved = height < least && along.x != 0  ? Vec3{by / along.x, 0, 0}
            : width < least && along.y != 0 ? Vec3{0, by / along.y, 0}
                                            : by * along;
  }
  out.move_x = width > least ? moved.x / width : 0, out.move_y = height > least ? moved.y / height : 0;
  out.spread = static_cast<std::uint32_t>(g.spread);
  out.stops = written_stops(g.stops);
  const bool fits = out.size >= 0.001 && out.size <= 1e6 && std::abs(out.move_x) <= 1e6 && std::abs(out.move_y) <= 1e6;
  return fits ? out : DrawnGradient{};
}

}  // namespace betwixt

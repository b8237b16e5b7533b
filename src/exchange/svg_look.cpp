// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/svg_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

SvgPaint paint_of(Property which, std::string_view otherwise, Property opacity, const SvgAround& around,
                  std::string_view name, const SvgIds& ids, const SvgRules& rules, SvgLeftOut& left_out) {
  std::string_view said = around.style[which];
  if (said.empty()) said = otherwise;
  const double seen = around.opacity * svg_opacity(around.style[opacity]);
  if (said == "none") return {};
  if (const std::string_view of = svg_reference(said); !of.empty()) {
    if (auto gradient = gradient_with(of, around.viewport, ids, rules)) {
      const SvgColor middle = gradient->middle();
      const bool plain = gradient->stops.size() < 2 || gradient->stops.size() > most_stops;
      if (gradient->stops.size() > most_stops)
        left_out.add(fmt::format("of gradients with more than {} stops the middle colour is used", most_stops), name);
      if (gradient->focal) left_out.add("the focus of a radial gradient is in its middle", name);
      if (plain) return {true, middle.color, middle.opacity * seen, nullptr};
      return {true, middle.color, seen, std::make_shared<const SvgGradient>(*std::move(gradient))};
    }
    const std::string_view behind = trimmed(said.substr(std::min(said.find(')') + 1, said.size())));
    if (behind.empty() || behind == "none") {
      left_out.add(fmt::format("a {} by '{}', which is not a gradient, is left out", name_of(which), of.substr(0, 60)),
                   name);
      return {};
    }
    said = behind;
  }
  const auto color = svg_color(said, around.style[Property::color]);
  if (!color) {
    left_out.add(fmt::format("a {} of '{}' is left out", name_of(which), said.substr(0, 40)), name);
    return {};
  }
  return {color->opacity > 0, color->color, color->opacity * seen, nullptr};
}

void dashes_of(const SvgStyle& style, double stretch, double whole, SvgLook& look, std::string_view name,
               SvgLeftOut& left_out) {
  std::string_view all = style[Property::dasharray];
  std::vector<double> lengths;
  while (!(all = trimmed(all)).empty() && lengths.size() < 1000) {
    const std::size_t end = std::min(all.find_first_of(" ,\t\r\n"), all.size());
    if (const auto one = svg_length(all.substr(0, end), whole)) lengths.push_back(std::max(0.0, *one));
    all.remove_prefix(std::min(end + 1, all.size()));
  }
  if (lengths.empty()) return;
  look.dash = std::min(lengths[0] * stretch, farthest_drawn);
  look.gap = std::min(lengths[lengths.size() > 1 ? 1 : 0] * stretch, farthest_drawn);
  for (std::size_t i = 2; i < lengths.size(); ++i)
    if (lengths[i] != lengths[i % 2] || lengths.size() % 2 != 0) {
      left_out.add("dashes of several lengths are all drawn with the first length", name);
      break;
    }
  if (svg_length(style[Property::dashoffset], whole).value_or(0) != 0)
    left_out.add("the offset of dashes is left out", name);
}

}  // namespace

void SvgLeftOut::add(const std::string& what, std::string_view of) {
  auto& [count, names] = all_[what];
  if (++count <= most_named && !of.empty()) names.emplace_back(of.substr(0, 60));
}

void SvgLeftOut::say(std::vector<std::string>& out) const {
  for (const auto& [what, of] : all_) {
    const auto& [count, names] = of;
    std::string all;
    for (const std::string& name : names) all += fmt::format("{}'{}'", all.empty() ? "" : ", ", name);
    if (count > names.size() && !names.empty()) all += fmt::format(" and {} more", count - names.size());
    out.push_back(what + (all.empty() ? "" : fmt::format(" (in {})", all)));
  }
}

SvgLook svg_look(const SvgAround& around, std::string_view name, const SvgIds& ids, const SvgRules& rules,
                 SvgLeftOut& left_out) {
  SvgLook look;
  const SvgStyle& style = around.style;
  const auto said = [&](Property p, std::string_view word) { return style[p] == word; };
  look.fill = paint_of(Property::fill, "black", Property::fill_opacity, around, name, ids, rules, left_out);
  look.stroke = paint_of(Property::stroke, "none", Property::stroke_opacity, around, name, ids, rules, left_out);
  look.even_odd = said(Property::fill_rule, "evenodd");
  // A stroke has a single width, so take the average scale.
  const Affine& m = around.to;
  const double stretch = std::sqrt(std::abs(m.a * m.d - m.b * m.c));
  const double across = std::hypot(m.a, m.b), up = std::hypot(m.c, m.d);
  const double whole = around.viewport.diagonal();
  look.width = svg_length(style[Property::stroke_width], whole).value_or(1) * stretch;
  look.width = std::min(look.width, farthest_drawn);
  look.stroke.there = look.stroke.there && look.width > 0;
  if (!look.stroke.there) return look;
  if (std::max(std::abs(across - up) / stretch, std::abs(m.a * m.c + m.b * m.d) / (stretch * stretch)) > 0.02)
    left_out.add("a stretched stroke is drawn with the same width everywhere", name);
  const bool round_ends = said(Property::linecap, "round"), round_joins = said(Property::linejoin, "round");
  look.round = round_ends || round_joins;
  look.square = said(Property::linecap, "square");
  if (said(Property::linejoin, "bevel")) left_out.add("bevelled corners of strokes are drawn mitred", name);
  dashes_of(style, stretch, whole, look, name, left_out);
  for (const Property p : {Property::marker_start, Property::marker_mid, Property::marker_end})
    if (!style[p].empty() && style[p] != "none") left_out.add("markers are left out", name);
  return look;
}

}  // namespace betwixt

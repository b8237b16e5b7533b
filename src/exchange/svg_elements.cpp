// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/svg_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exchange/svg_style.h"

namespace betwixt {

std::string_view local_name(pugi::xml_node node) {
  const std::string_view name = node.name();
  return name.starts_with("svg:") ? name.substr(4) : name;
}

std::string_view reference_of(pugi::xml_node node) {
  const std::string_view plain = said_in(node, "href"), of = plain.empty() ? said_in(node, "xlink:href") : plain;
  return of.starts_with("#") ? of.substr(1) : std::string_view();
}

bool any_of_these(std::string_view word, std::initializer_list<std::string_view> all) {
  return std::find(all.begin(), all.end(), word) != all.end();
}

Affine fitted(pugi::xml_node node, Viewport& inner, double width, double height) {
  PathNumbers n(said_in(node, "viewBox"));
  std::array<double, 4> box{};
  inner = {width, height};
  for (double& v : box) {
    const auto one = n.number();
    if (!one) return {};
    v = *one;
  }
  if (!(box[2] > 0) || !(box[3] > 0)) return {};
  inner = {box[2], box[3]};
  double sx = width / box[2], sy = height / box[3];
  const std::string_view how = said_in(node, "preserveAspectRatio");
  if (how.find("none") == std::string_view::npos)
    sx = sy = how.find("slice") != std::string_view::npos ? std::max(sx, sy) : std::min(sx, sy);
  const auto share = [&](const char* first, const char* last) {
    return how.find(first) != std::string_view::npos ? 0.0 : how.find(last) != std::string_view::npos ? 1.0 : 0.5;
  };
  const double x = share("xMin", "xMax") * (width - box[2] * sx), y = share("YMin", "YMax") * (height - box[3] * sy);
  return {sx, 0, 0, sy, x - box[0] * sx, y - box[1] * sy};
}

std::optional<std::string> path_of(pugi::xml_node node, std::string_view tag, const Viewport& v) {
  const auto length = [&](const char* name, double whole) { return svg_length(said_in(node, name), whole); };
  const auto x = [&](const char* name) { return length(name, v.width).value_or(0); };
  const auto y = [&](const char* name) { return length(name, v.height).value_or(0); };
  if (tag == "path") return std::string(said_in(node, "d"));
  if (tag == "line") return fmt::format("M{} {}L{} {}", x("x1"), y("y1"), x("x2"), y("y2"));
  if (tag == "polyline") return fmt::format("M{}", said_in(node, "points"));
  if (tag == "polygon") return fmt::format("M{}Z", said_in(node, "points"));
  if (tag == "circle" || tag == "ellipse") {
    const double r = length("r", v.diagonal()).value_or(0);
    const auto rx = tag == "circle" ? r : length("rx", v.width), ry = tag == "circle" ? r : length("ry", v.height);
    const double a = rx.value_or(ry.value_or(0)), b = ry.value_or(rx.value_or(0)), cx = x("cx"), cy = y("cy");
    if (!(a > 0) || !(b > 0)) return "";
    return fmt::format("M{} {}A{} {} 0 0 1 {} {}A{} {} 0 0 1 {} {}Z", cx + a, cy, a, b, cx - a, cy, a, b, cx + a, cy);
  }
  if (tag == "rect") {
    const double w = x("width"), h = y("height"), left = x("x"), top = y("y");
    if (!(w > 0) || !(h > 0)) return "";
    const auto rx = length("rx", v.width), ry = length("ry", v.height);
    const double a = std::clamp(rx.value_or(ry.value_or(0)), 0.0, w / 2);
    const double b = std::clamp(ry.value_or(rx.value_or(0)), 0.0, h / 2);
    const double right = left + w, bottom = top + h;
    if (!(a > 0) || !(b > 0)) return fmt::format("M{} {}H{}V{}H{}Z", left, top, right, bottom, left);
    return fmt::format("M{} {}H{}A{} {} 0 0 1 {} {}V{}A{} {} 0 0 1 {} {}H{}A{} {} 0 0 1 {} {}V{}A{} {} 0 0 1 {} {}Z",
                       left + a, top, right - a, a, b, right, top + b, bottom - b, a, b, right - a, bottom, left + a, a,
                       b, left, bottom - b, top + b, a, b, left + a, top);
  }
  return std::nullopt;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// SVG styles: attributes, style="…", and rules of <style> with a tag, classes and an id.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/value.h"

namespace betwixt {

// Children inherit the properties before `opacity`.
enum class Property : std::uint8_t {
  fill,
  fill_rule,
  fill_opacity,
  stroke,
  stroke_width,
  stroke_opacity,
  linecap,
  linejoin,
  dasharray,
  dashoffset,
  color,
  visibility,
  marker_start,
  marker_mid,
  marker_end,
  opacity,
  display,
  clip_path,
  mask,
  filter,
  blend,
  stop_color,
  stop_opacity,
  count
};
inline constexpr std::size_t property_count = static_cast<std::size_t>(Property::count);
std::string_view name_of(Property);

// The value of each property in the file's words; "" if unset.
class SvgStyle {
 public:
  std::string_view operator[](Property p) const { return said_[static_cast<std::size_t>(p)]; }
  SvgStyle inherited() const;
  void set(std::string_view name, std::string_view value);
  void read(std::string_view declarations);  // "fill: red; stroke: none"

 private:
  std::array<std::string_view, property_count> said_{};
};

// The features of an element that rules can select.
struct SvgElement {
  std::string_view tag, id, classes;
};

class SvgRules {
 public:
  void read(std::string_view sheet);  // stores views of `sheet`, which must stay in place
  void apply(const SvgElement&, SvgStyle&) const;
  bool passed_over() const { return passed_over_; }  // whether there are rules of unsupported kinds

 private:
  struct Rule {
    std::string_view tag, id;
    std::vector<std::string_view> classes;
    std::string_view declarations;
    std::size_t number = 0;
    std::size_t weight() const { return (id.empty() ? 0 : 10'000) + 100 * classes.size() + (tag.empty() ? 0 : 1); }
  };
  void add(std::string_view selector, std::string_view declarations);

  std::vector<Rule> rules_;
  std::multimap<std::string_view, std::size_t> by_word_;  // by an id, a class or a tag that the rule requires
  bool passed_over_ = false;
};

// Reads "red", "#f00", "rgb(255, 0, 0)", "hsl(0 100% 50%)" and its opacity. `current` is the value of currentColor.
struct SvgColor {
  Color color;
  double opacity = 1;
};
std::optional<SvgColor> svg_color(std::string_view text, std::string_view current);
// Reads a number, also with a unit, in user units (px). A percentage is of `whole`.
std::optional<double> svg_length(std::string_view text, double whole);
// Returns the opacity from 0 to 1; also reads a percentage.
double svg_opacity(std::string_view text);
// Returns X of url(#X), or "" for anything else.
std::string_view svg_reference(std::string_view text);
std::string_view trimmed(std::string_view text);

}  // namespace betwixt

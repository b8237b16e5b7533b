// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/svg_style.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "exchange/svg_path.h"
#include "scene/colors.h"

namespace betwixt {
namespace {

constexpr std::string_view css_blanks = " \t\r\n\f";

constexpr std::array<std::string_view, property_count> property_names{"fill",
                                                                      "fill-rule",
                                                                      "fill-opacity",
                                                                      "stroke",
                                                                      "stroke-width",
                                                                      "stroke-opacity",
                                                                      "stroke-linecap",
                                                                      "stroke-linejoin",
                                                                      "stroke-dasharray",
                                                                      "stroke-dashoffset",
                                                                      "color",
                                                                      "visibility",
                                                                      "marker-start",
                                                                      "marker-mid",
                                                                      "marker-end",
                                                                      "opacity",
                                                                      "display",
                                                                      "clip-path",
                                                                      "mask",
                                                                      "filter",
                                                                      "mix-blend-mode",
                                                                      "stop-color",
                                                                      "stop-opacity"};

// Removes and returns the text before `end`; removes `end`, too.
std::string_view take_until(std::string_view& rest, char end) {
  const auto at = rest.find(end);
  const std::string_view taken = rest.substr(0, at);
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + 1);
  return taken;
}

bool has_class(std::string_view all, std::string_view word) {
  while (!all.empty()) {
    all.remove_prefix(std::min(all.find_first_not_of(css_blanks), all.size()));
    const std::string_view one = all.substr(0, all.find_first_of(css_blanks));
    if (!one.empty() && one == word) return true;
    all.remove_prefix(one.size());
  }
  return false;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(css_blanks), text.size()));
  return text.substr(0, text.find_last_not_of(css_blanks) + 1);
}

std::string_view name_of(Property p) { return property_names[static_cast<std::size_t>(p)]; }

SvgStyle SvgStyle::inherited() const {
  SvgStyle out;
  std::copy_n(said_.begin(), static_cast<std::size_t>(Property::opacity), out.said_.begin());
  return out;
}

void SvgStyle::set(std::string_view name, std::string_view value) {
  value = trimmed(value.substr(0, value.find('!')));  // "!important"
  if (value.empty() || value == "inherit") return;
  const auto at = std::find(property_names.begin(), property_names.end(), name);
  if (at != property_names.end()) said_[static_cast<std::size_t>(at - property_names.begin())] = value;
  if (name == "marker")
    for (const Property p : {Property::marker_start, Property::marker_mid, Property::marker_end})
      said_[static_cast<std::size_t>(p)] = value;
}

void SvgStyle::read(std::string_view declarations) {
  while (!declarations.empty()) {
    std::string_view value = take_until(declarations, ';');
    const std::string_view name = trimmed(take_until(value, ':'));
    set(name, value);
  }
}

// ---- Rules

void SvgRules::read(std::string_view sheet) {
  for (;;) {
    sheet = trimmed(sheet);
    if (sheet.empty()) return;
    if (sheet.starts_with("/*")) {
      const auto end = sheet.find("*/");
      sheet.remove_prefix(end == std::string_view::npos ? sheet.size() : end + 2);
      continue;
    }
    if (sheet.starts_with("@")) {  // everything in its braces is unsupported
      passed_over_ = true;
      int depth = 0;
      std::size_t i = 0;
      for (; i < sheet.size() && !(depth == 0 && sheet[i] == ';'); ++i) {
        if (sheet[i] == '{') ++depth;
        if (sheet[i] == '}' && --depth <= 0) break;
      }
      sheet.remove_prefix(std::min(i + 1, sheet.size()));
      continue;
    }
    std::string_view selectors = take_until(sheet, '{');
    const std::string_view declarations = take_until(sheet, '}');
    while (!selectors.empty()) add(trimmed(take_until(selectors, ',')), declarations);
  }
}

void SvgRules::add(std::string_view selector, std::string_view declarations) {
  if (selector.empty() || selector.find_first_of(" \t\r\n>+~:[") != std::string_view::npos) {
    passed_over_ = true;
    return;
  }
  Rule rule;
  rule.declarations = declarations;
  rule.number = rules_.size();
  const auto word = [&] {
    const std::string_view w = selector.substr(0, selector.find_first_of(".#"));
    selector.remove_prefix(w.size());
    return w;
  };
  rule.tag = word();
  if (rule.tag == "*") rule.tag = {};
  while (!selector.empty()) {
    const char what = selector[0];
    selector.remove_prefix(1);
    if (what == '#')
      rule.id = word();
    else
      rule.classes.push_back(word());
  }
  by_word_.emplace(!rule.id.empty() ? rule.id : !rule.classes.empty() ? rule.classes[0] : rule.tag, rule.number);
  rules_.push_back(std::move(rule));
}

void SvgRules::apply(const SvgElement& element, SvgStyle& style) const {
  if (rules_.empty()) return;
  std::vector<const Rule*> fitting;
  const auto look = [&](std::string_view word) {
    for (auto [at, end] = by_word_.equal_range(word); at != end; ++at) {
      const Rule& r = rules_[at->second];
      const bool fits = (r.tag.empty() || r.tag == element.tag) && (r.id.empty() || r.id == element.id) &&
                        std::all_of(r.classes.begin(), r.classes.end(),
                                    [&](std::string_view c) { return has_class(element.classes, c); });
      if (fits) fitting.push_back(&r);
    }
  };
  look({}), look(element.tag), look(element.id);
  for (std::string_view rest = element.classes; !(rest = trimmed(rest)).empty();) {
    const std::string_view one = rest.substr(0, rest.find_first_of(css_blanks));
    look(one);
    rest.remove_prefix(one.size());
  }
  std::sort(fitting.begin(), fitting.end(), [](const Rule* a, const Rule* b) {
    return std::pair(a->weight(), a->number) < std::pair(b->weight(), b->number);
  });
  for (const Rule* r : fitting) style.read(r->declarations);
}

// ---- Values

namespace {

double in_unit(double v) { return std::clamp(v, 0.0, 1.0); }

// A number, and whether it is a percentage.
struct CssNumber {
  double value = 0;
  bool percent = false;
  double of(double whole) const { return percent ? value / 100 : value / whole; }
};
// Reads up to four numbers: "255, 0 0 / 50%".
std::vector<CssNumber> css_numbers_in(std::string_view text) {
  std::vector<CssNumber> out;
  while (out.size() < 4) {
    text.remove_prefix(std::min(text.find_first_not_of(" ,/\t\r\n"), text.size()));
    if (text.starts_with("+")) text.remove_prefix(1);
    CssNumber part;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), part.value);
    if (read.ec != std::errc()) break;
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    if (text.starts_with("deg")) text.remove_prefix(3);
    part.percent = text.starts_with("%");
    if (part.percent) text.remove_prefix(1);
    out.push_back(part);
  }
  return out;
}

Color of_hue(double degrees, double saturation, double lightness) {
  const double a = saturation * std::min(lightness, 1 - lightness);
  const auto channel = [&](double n) {
    const double k = std::fmod(std::fmod(n + degrees / 30, 12) + 12, 12);
    return lightness - a * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
  };
  return {channel(0), channel(8), channel(4)};
}

std::optional<SvgColor> hexadecimal(std::string_view digits) {
  std::uint32_t v = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), v, 16);
  if (read.ec != std::errc() || read.ptr != digits.data() + digits.size()) return std::nullopt;
  if (digits.size() == 3 || digits.size() == 4) {  // each digit represents two
    std::uint32_t wide = 0;
    for (std::size_t i = digits.size(); i-- > 0;) wide = wide << 8 | (v >> (4 * i) & 15) * 17;
    v = wide;
  } else if (digits.size() != 6 && digits.size() != 8) {
    return std::nullopt;
  }
  if (digits.size() % 4 != 0) return SvgColor{from_bytes(v), 1};
  return SvgColor{from_bytes(v >> 8), (v & 255) / 255.0};
}

}  // namespace

std::optional<SvgColor> svg_color(std::string_view text, std::string_view current) {
  text = trimmed(text);
  std::string small(text.substr(0, 40));
  std::transform(small.begin(), small.end(), small.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (small == "currentcolor") return current.empty() ? SvgColor{{0, 0, 0}, 1} : svg_color(current, {});
  if (small == "transparent") return SvgColor{{0, 0, 0}, 0};
  if (small.starts_with("#")) return hexadecimal(std::string_view(small).substr(1));
  if (const auto open = small.find('('); open != std::string::npos) {
    const auto p = css_numbers_in(std::string_view(small).substr(open + 1));
    if (p.size() < 3) return std::nullopt;
    const double opacity = p.size() == 4 ? in_unit(p[3].of(1)) : 1;
    if (small.starts_with("rgb"))
      return SvgColor{{in_unit(p[0].of(255)), in_unit(p[1].of(255)), in_unit(p[2].of(255))}, opacity};
    if (small.starts_with("hsl") && std::abs(p[0].value) < 1e6)
      return SvgColor{of_hue(p[0].value, in_unit(p[1].value / 100), in_unit(p[2].value / 100)), opacity};
    return std::nullopt;
  }
  const auto known = named_color(small);
  return known ? std::optional(SvgColor{from_bytes(*known), 1}) : std::nullopt;
}

std::optional<double> svg_length(std::string_view text, double whole) {
  constexpr std::pair<std::string_view, double> units[] = {{"", 1},    {"px", 1},         {"pt", 96 / 72.0},
                                                           {"pc", 16}, {"mm", 96 / 25.4}, {"cm", 96 / 2.54},
                                                           {"in", 96}, {"em", 16},        {"ex", 8}};
  text = trimmed(text);
  if (text.starts_with("+")) text.remove_prefix(1);
  double v = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), v);
  if (read.ec != std::errc() || !(std::abs(v) <= farthest_in_svg)) return std::nullopt;
  const std::string_view unit = trimmed(text.substr(static_cast<std::size_t>(read.ptr - text.data())));
  if (unit == "%") return v / 100 * whole;
  for (const auto& [name, pixels] : units)
    if (unit == name) return v * pixels;
  return std::nullopt;
}

double svg_opacity(std::string_view text) {
  const auto p = css_numbers_in(text);
  return p.empty() ? 1 : in_unit(p[0].of(1));
}

std::string_view svg_reference(std::string_view text) {
  if (!text.starts_with("url(")) return {};
  text = trimmed(text.substr(4, text.find(')') - 4));
  if (text.size() > 1 && (text.front() == '"' || text.front() == '\'')) text = text.substr(1, text.size() - 2);
  return text.starts_with("#") ? text.substr(1) : std::string_view();
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "algebra/css_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "betwixt/math.h"

namespace betwixt::algebra {
namespace {

constexpr Unit css_angles[] = {{"deg", pi, 180}, {"grad", pi, 200}, {"rad", 1, 1}, {"turn", 2 * pi, 1}};
// An inch is 96 pixels.
constexpr Unit css_lengths[] = {{"px", 1, 1},    {"in", 96, 1}, {"cm", 9600, 254}, {"mm", 960, 254},
                                {"q", 240, 254}, {"pt", 4, 3},  {"pc", 16, 1}};
// A unit that depends on the page.
struct PageUnit {
  std::string_view name, needs;
  double divisor;
  std::optional<double> (*whole)(const CssPage&);  // of `divisor` such units
};
template <bool smaller>
std::optional<double> viewport_side(const CssPage& p) {
  if (!p.viewport_width || !p.viewport_height) return std::nullopt;
  return smaller ? std::min(*p.viewport_width, *p.viewport_height) : std::max(*p.viewport_width, *p.viewport_height);
}
constexpr std::string_view a_viewport = "the size of the viewport";
constexpr PageUnit page_units[] = {
    {"em", "the font size", 1, [](const CssPage& p) { return p.font_size; }},
    {"rem", "the font size of the root", 1, [](const CssPage& p) { return p.root_font_size; }},
    {"vw", a_viewport, 100, [](const CssPage& p) { return p.viewport_width; }},
    {"vh", a_viewport, 100, [](const CssPage& p) { return p.viewport_height; }},
    {"vmin", a_viewport, 100, viewport_side<true>},
    {"vmax", a_viewport, 100, viewport_side<false>}};

constexpr std::string_view worked_out_here[] = {"calc", "min", "max", "clamp"};
constexpr int deepest = 100;

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool in_word(char c) {
  return is_digit(c) || (small(c) >= 'a' && small(c) <= 'z') || c == '-' || c == '_' || (c & 0x80) != 0;
}

template <std::size_t n>
const Unit* unit_named(const Unit (&units)[n], std::string_view name) {
  const auto found = std::find_if(units, units + n, [&](const Unit& u) { return same_in_css(name, u.name); });
  return found == units + n ? nullptr : found;
}

const PageUnit* page_unit(std::string_view name) {
  const auto found = std::find_if(std::begin(page_units), std::end(page_units),
                                  [&](const PageUnit& u) { return same_in_css(name, u.name); });
  return found == std::end(page_units) ? nullptr : found;
}

}  // namespace

bool same_in_css(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char p, char q) { return small(p) == small(q); });
}

void CssNumbers::space() {
  for (;;) {
    while (at < text.size() && std::string_view(" \t\r\n\f").find(text[at]) != std::string_view::npos) ++at;
    if (text.substr(at, 2) != "/*") return;
    at = std::min(text.find("*/", at + 2), text.size() - 2) + 2;
  }
}

std::string_view CssNumbers::word() {
  const std::size_t from = at;
  while (at < text.size() && in_word(text[at])) ++at;
  return text.substr(from, at - from);
}

// As in CSS: a point needs a digit after it, and 1em is 1 with a unit.
bool CssNumbers::number(double& out) {
  const std::size_t from = at;
  std::size_t end = at + (peek() == '+' || peek() == '-');
  const std::size_t first = end;
  const auto c = [&](std::size_t i) { return i < text.size() ? text[i] : '\0'; };
  const auto digits = [&] {
    while (is_digit(c(end))) ++end;
  };
  digits();
  if (c(end) == '.' && is_digit(c(end + 1))) ++end, digits();
  if (end == first) {
    const std::string_view name = word();
    if (!name.empty() && peek() == '(')
      return fail(from, at, ErrorCode::type, fmt::format("{}() is not supported", name),
                  "write the number, or use calc(), min(), max() or clamp()");
    return fail(from, std::max(at, from + 1), ErrorCode::syntax, "expected a number here");
  }
  if (small(c(end)) == 'e' &&
      (is_digit(c(end + 1)) || ((c(end + 1) == '+' || c(end + 1) == '-') && is_digit(c(end + 2)))))
    end += 2, digits();
  const std::size_t plus = peek() == '+';
  const auto read = std::from_chars(text.data() + from + plus, text.data() + end, out);
  at = end;
  return read.ec == std::errc() || too_large(from);
}

bool CssNumbers::too_large(std::size_t from) {
  return fail(from, at, ErrorCode::range, fmt::format("'{}' is too large or too small", text.substr(from, at - from)));
}

// Reads the unit after a number, possibly "".
std::string_view CssNumbers::unit() {
  if (peek() != '%') return word();
  return text.substr(at++, 1);
}

// Converts a number of a unit of length.
bool CssNumbers::pixels(double& number, std::string_view name, std::size_t from, std::size_t unit_from,
                        Part percent_of) {
  if (name == "%" && percent_of != Part::none) {
    const auto& whole = percent_of == Part::width ? page.width : page.height;
    if (!whole)
      return fail(unit_from, at, ErrorCode::type, "'%' is not a unit of length here",
                  "use px, or give the size of the element, to which percentages refer");
    number = number / 100 * *whole;
  } else if (const Unit* u = unit_named(css_lengths, name)) {
    number = number * u->of / u->divisor;
  } else if (const PageUnit* of_page = page_unit(name)) {
    const auto whole = of_page->whole(page);
    if (!whole)
      return fail(unit_from, at, ErrorCode::type, fmt::format("'{}' is not a unit of length here", name),
                  fmt::format("use px, or give {}", of_page->needs));
    number = number * *whole / of_page->divisor;
  } else {
    return fail(unit_from, at, ErrorCode::type, fmt::format("'{}' is not a unit of length here", name),
                name == "%" ? "use px: elements have no size along z"
                            : "units are px in cm mm q pt pc, em rem and vw vh vmin vmax");
  }
  return std::isfinite(number) || too_large(from);
}

bool CssNumbers::length(double& out, Part percent_of) {
  if (at_function()) return worked_out(out, Type::length, percent_of);
  const std::size_t from = at;
  if (!number(out)) return false;
  const std::size_t unit_from = at;
  const std::string_view name = unit();
  if (name.empty() && out == 0) return true;
  if (name.empty())
    return fail(from, at, ErrorCode::type, fmt::format("a length needs its unit: {}", text.substr(from, at - from)),
                "px");
  return pixels(out, name, from, unit_from, percent_of);
}

bool CssNumbers::angle(Angle& out) {
  if (at_function()) return worked_out(out.radians, Type::angle, Part::none);
  const std::size_t from = at;
  double count = 0;
  if (!number(count)) return false;
  const std::size_t unit_from = at;
  const std::string_view name = unit();
  if (name.empty() && count == 0) return true;
  if (const Unit* u = unit_named(css_angles, name)) {
    const auto read = read_angle(text.substr(from, unit_from - from), count, *u);
    if (read) out = *read;
    return read || too_large(from);
  }
  return fail(name.empty() ? from : unit_from, at, ErrorCode::type,
              name.empty() ? fmt::format("an angle needs its unit: {}", text.substr(from, at - from))
                           : fmt::format("'{}' is not a unit of angle", name),
              "units are deg, grad, rad, turn");
}

bool CssNumbers::plain(double& out) {
  if (at_function()) return worked_out(out, Type::number, Part::none);
  if (!number(out)) return false;
  const std::size_t unit_from = at;
  const std::string_view name = unit();
  return name.empty() ||
         fail(unit_from, at, ErrorCode::type, fmt::format("expected a number without a unit here, not '{}'", name),
              name == "%" ? "write 0.5 instead of 50%" : "");
}

// ---- Expressions

bool CssNumbers::at_function() const {
  std::size_t end = at;
  while (end < text.size() && in_word(text[end])) ++end;
  return end < text.size() && text[end] == '(' &&
         std::any_of(std::begin(worked_out_here), std::end(worked_out_here),
                     [&](std::string_view name) { return same_in_css(text.substr(at, end - at), name); });
}

bool CssNumbers::worked_out(double& out, Type wanted, Part percent_of) {
  constexpr const char* names[] = {"a number without a unit", "a length", "an angle"};
  const std::size_t from = at;
  Value v;
  if (!function(v, percent_of)) return false;
  if (v.type != wanted)
    return fail(
        from, at, ErrorCode::type,
        fmt::format("expected {} here, not {}", names[static_cast<int>(wanted)], names[static_cast<int>(v.type)]));
  out = v.number;
  if (wanted == Type::angle && !(std::abs(out) < 2 * pi * most_turns)) return too_large(from);
  return std::isfinite(out) || too_large(from);
}

bool CssNumbers::function(Value& out, Part percent_of) {
  const std::size_t from = at;
  const std::string_view name = word();
  ++at;  // '('
  if (++depth_ > deepest)
    return fail(from, at, ErrorCode::range, fmt::format("brackets can be at most {} levels deep", deepest));
  const bool read = arguments(name, from, out, percent_of);
  --depth_;
  return read;
}

// Reads up to the ')' and skips it.
bool CssNumbers::arguments(std::string_view name, std::size_t from, Value& out, Part percent_of) {
  Value values[3];
  std::size_t count = 0;
  const std::size_t most = same_in_css(name, "calc") ? 1 : same_in_css(name, "clamp") ? 3 : 0;
  for (;; ++at) {
    Value& v = values[most == 3 ? std::min<std::size_t>(count, 2) : 0];
    Value next;
    if (!sum(next, percent_of)) return false;
    if (count > 0 && next.type != values[0].type)
      return fail(from, at, ErrorCode::type, fmt::format("the values of {}() must be of the same kind", name));
    if (count == 0 || most != 0)
      v = next;
    else
      v.number = same_in_css(name, "min") ? std::min(v.number, next.number) : std::max(v.number, next.number);
    ++count;
    if (peek() != ',' || count == most) break;
  }
  if (at == text.size()) return fail(at, at + 1, ErrorCode::syntax, "')' is missing");
  if (peek() != ')')
    return fail(at, at + 1, ErrorCode::syntax, most == 1 ? "expected ')' here" : "expected ',' or ')' here");
  ++at;
  if (most == 3 && count < 3)
    return fail(from, at, ErrorCode::syntax, "clamp() needs a minimum, a value and a maximum");
  out = values[0];
  if (most == 3) out.number = std::max(values[0].number, std::min(values[1].number, values[2].number));
  return true;
}

bool CssNumbers::sum(Value& out, Part percent_of) {
  space();
  if (!term(out, percent_of)) return false;
  for (;;) {
    const bool apart = at > 0 && std::string_view(" \t\r\n\f/").find(text[at - 1]) != std::string_view::npos;
    const std::size_t sign_at = at;
    const char sign = peek();
    if (sign != '+' && sign != '-') return true;
    ++at;
    // As in CSS, 1 -2 are two numbers.
    if (!apart || std::string_view(" \t\r\n\f/").find(peek()) == std::string_view::npos)
      return fail(sign_at, at, ErrorCode::syntax, fmt::format("'{}' needs a space on both sides", sign));
    space();
    Value next;
    if (!term(next, percent_of)) return false;
    if (next.type != out.type)
      return fail(sign_at, at, ErrorCode::type, "numbers, lengths and angles cannot be added to each other");
    out.number += sign == '+' ? next.number : -next.number;
  }
}

bool CssNumbers::term(Value& out, Part percent_of) {
  if (!value(out, percent_of)) return false;
  for (space(); peek() == '*' || peek() == '/'; space()) {
    const std::size_t sign_at = at;
    const bool quotient = text[at++] == '/';
    space();
    Value next;
    if (!value(next, percent_of)) return false;
    if (next.type != Type::number && (quotient || out.type != Type::number))
      return fail(sign_at, at, ErrorCode::type,
                  quotient ? "a divisor must be a number without a unit"
                           : "one of the two factors must be a number without a unit");
    if (quotient && next.number == 0) return fail(sign_at, at, ErrorCode::range, "a divisor must not be 0");
    if (out.type == Type::number) out.type = next.type;
    out.number = quotient ? out.number / next.number : out.number * next.number;
  }
  return true;
}

bool CssNumbers::value(Value& out, Part percent_of) {
  const std::size_t from = at;
  if (peek() == '(') {
    ++at;
    if (++depth_ > deepest)
      return fail(from, at, ErrorCode::range, fmt::format("brackets can be at most {} levels deep", deepest));
    if (!sum(out, percent_of)) return false;
    --depth_;
    if (peek() != ')') return fail(at, at + 1, ErrorCode::syntax, "')' is missing");
    ++at;
    return true;
  }
  if (at_function()) return function(out, percent_of);
  if (!number(out.number)) return false;
  const std::size_t unit_from = at;
  const std::string_view name = unit();
  if (name.empty()) return true;
  if (const Unit* u = unit_named(css_angles, name)) {
    out = {out.number * u->of / u->divisor, Type::angle};
    return true;
  }
  out.type = Type::length;
  return pixels(out.number, name, from, unit_from, percent_of);
}

}  // namespace betwixt::algebra

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The functions, constants and names of formulas. Included only by the files of src/language/formula*.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "language/formula.h"
#include "procedure/noise.h"
#include "syntax/characters.h"

namespace betwixt::formulas {

using Of = Quantity::Of;

inline constexpr std::size_t most_arguments = 8;

inline constexpr std::pair<std::string_view, double> constants[] = {
    {"pi", pi}, {"tau", 2 * pi}, {"e", 2.718281828459045235360287}};

inline bool name_goes_on(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
inline bool number_begins(const char* at, const char* end) {
  const auto digit = [&](const char* p) { return p < end && *p >= '0' && *p <= '9'; };
  return digit(at) || (at < end && *at == '.' && digit(at + 1));
}
inline std::string_view name_at(const char* at, const char* end) {
  const char* p = at;
  if (p < end && is_letter(*p))
    while (p < end && name_goes_on(*p)) ++p;
  return {at, static_cast<std::size_t>(p - at)};
}
inline double radians(const Quantity& q) { return q.of == Of::angle ? q.value * (pi / 180) : q.value; }
inline Quantity number(double v) { return {Of::number, v, 0, false}; }
inline Quantity degrees(double radians) { return {Of::angle, radians * (180 / pi), 0, false}; }

// A function of numbers, with the types of its arguments and of its result.
struct FunctionRow {
  std::string_view name;
  std::size_t least, most;
  // `turns`: angles, or radians; `alike`: all of one type, which the result has, too.
  enum Takes { numbers, turns, alike } takes;
  Quantity (*of)(const Quantity* a, std::size_t n);
};
inline Quantity with(Quantity like, double value) { return like.value = value, like; }

inline constexpr FunctionRow function_rows[] = {
    {"sin", 1, 1, FunctionRow::turns, [](const Quantity* a, std::size_t) { return number(std::sin(radians(*a))); }},
    {"cos", 1, 1, FunctionRow::turns, [](const Quantity* a, std::size_t) { return number(std::cos(radians(*a))); }},
    {"tan", 1, 1, FunctionRow::turns, [](const Quantity* a, std::size_t) { return number(std::tan(radians(*a))); }},
    {"asin", 1, 1, FunctionRow::numbers, [](const Quantity* a, std::size_t) { return degrees(std::asin(a->value)); }},
    {"acos", 1, 1, FunctionRow::numbers, [](const Quantity* a, std::size_t) { return degrees(std::acos(a->value)); }},
    {"atan", 1, 2, FunctionRow::alike,
     [](const Quantity* a, std::size_t n) { return degrees(std::atan2(a[0].value, n > 1 ? a[1].value : 1)); }},
    {"sqrt", 1, 1, FunctionRow::numbers, [](const Quantity* a, std::size_t) { return number(std::sqrt(a->value)); }},
    {"abs", 1, 1, FunctionRow::alike, [](const Quantity* a, std::size_t) { return with(*a, std::abs(a->value)); }},
    {"min", 1, most_arguments, FunctionRow::alike,
     [](const Quantity* a, std::size_t n) {
       return *std::min_element(a, a + n, [](const auto& x, const auto& y) { return x.value < y.value; });
     }},
    {"max", 1, most_arguments, FunctionRow::alike,
     [](const Quantity* a, std::size_t n) {
       return *std::max_element(a, a + n, [](const auto& x, const auto& y) { return x.value < y.value; });
     }},
    {"floor", 1, 1, FunctionRow::numbers, [](const Quantity* a, std::size_t) { return number(std::floor(a->value)); }},
    {"ceil", 1, 1, FunctionRow::numbers, [](const Quantity* a, std::size_t) { return number(std::ceil(a->value)); }},
    {"round", 1, 1, FunctionRow::numbers,
     [](const Quantity* a, std::size_t) { return number(std::floor(a->value + 0.5)); }},
    {"sign", 1, 1, FunctionRow::alike,
     [](const Quantity* a, std::size_t) { return number((a->value > 0) - (a->value < 0)); }},
    {"mix", 3, 3, FunctionRow::alike,
     [](const Quantity* a, std::size_t) {
       return with(a[0], a[0].value * (1 - a[2].value) + a[1].value * a[2].value);
     }},
    {"clamp", 3, 3, FunctionRow::alike,
     [](const Quantity* a, std::size_t) {
       return with(a[0], std::fmax(a[1].value, std::fmin(a[0].value, a[2].value)));
     }},
    {"smoothstep", 3, 3, FunctionRow::alike,
     [](const Quantity* a, std::size_t) {
       const double low = a[0].value, high = a[1].value, x = a[2].value;
       const double u = low == high ? x >= high : std::fmax(0, std::fmin((x - low) / (high - low), 1));
       return number(u * u * (3 - 2 * u));
     }},
    {"hash", 1, 3, FunctionRow::numbers,
     [](const Quantity* a, std::size_t n) {
       return number(hashed({a[0].value, n > 1 ? a[1].value : 0, n > 2 ? a[2].value : 0}));
     }},
    {"noise", 1, 3, FunctionRow::numbers,
     [](const Quantity* a, std::size_t n) {
       const Vec3 at{a[0].value, n > 1 ? a[1].value : 0, n > 2 ? a[2].value : 0};
       return number(noise(at, static_cast<int>(n)));
     }},
};

inline const FunctionRow* find_function(std::string_view name) {
  const auto at =
      std::find_if(std::begin(function_rows), std::end(function_rows), [&](const auto& f) { return f.name == name; });
  return at == std::end(function_rows) ? nullptr : at;
}

}  // namespace betwixt::formulas

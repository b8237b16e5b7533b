// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts of C++20 that the standard library of Emscripten 3.1 lacks. The build includes this before every file.
#pragma once
#ifdef __cplusplus
#include <fast_float/fast_float.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <functional>
#include <type_traits>

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

template <class Real, class = enable_if_t<is_floating_point_v<Real>>>
from_chars_result from_chars(const char* first, const char* last, Real& out) {
  Real read = 0;
  const auto r = fast_float::from_chars(first, last, read);
  if (r.ec == errc()) out = read;
  return {r.ptr, r.ec};
}

namespace ranges {

template <class Range, class Value, class Projection = std::identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](const auto& one) { return std::invoke(projection, one) == value; });
}

}  // namespace ranges

}  // namespace std
#endif

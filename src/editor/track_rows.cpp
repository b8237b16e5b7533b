// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/track_rows.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "base/memory.h"
#include "language/values.h"

namespace betwixt {

std::size_t width_of(Type type) {
  switch (type) {
    case Type::scalar:
    case Type::angle:
      return 1;
    case Type::pair:
      return 2;
    case Type::vector:
    case Type::color:
    case Type::rotation:
      return 3;
    default:
      return 0;
  }
}

// Adding 0 makes 0 of -0, which a script cannot say.
Value value_of(Type type, const double* n) {
  const double x = n[0] + 0;
  if (type == Type::pair) return Vec3{x, n[1] + 0, 0};
  if (type == Type::vector) return Vec3{x, n[1] + 0, n[2] + 0};
  if (type == Type::color) return Color{x, n[1] + 0, n[2] + 0};
  if (type == Type::rotation) return Angles{{x, n[1] + 0, n[2] + 0}};
  return x;
}

void TrackRows::write(std::size_t row, std::string& to) const {
  const auto out = std::back_inserter(to);
  const Time t = times[row];
  const auto frame = static_cast<std::int64_t>(std::llround(rate.frame_number(t)));
  if (rate.frame(static_cast<double>(frame)) == t)  // the usual case, and the fastest
    fmt::format_to(out, FMT_COMPILE("  {}f "), frame);
  else
    fmt::format_to(out, FMT_COMPILE("  {} "), write_time(t, rate));
  if (type == Type::scalar && spec.unit == Unit::none)
    fmt::format_to(out, FMT_COMPILE("{}"), numbers[row] + 0);
  else
    to += write_value(value(row), spec, component, [](ObjectId) { return std::string(); });
  if (!twerper.empty()) (to += ' ') += twerper;
}

void TrackRows::write_all(std::string_view before, std::string_view behind, std::string& to) const {
  for (std::size_t i = 0; i < times.size(); ++i) {
    to += before;
    write(i, to);
    to += behind;
  }
}

std::size_t TrackRows::bytes() const {
  return sizeof *this + bytes_held(times) + bytes_held(numbers) + bytes_held(twerper);
}

}  // namespace betwixt

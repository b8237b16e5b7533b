// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"
#include "betwixt/result.h"
#include "betwixt/value.h"

namespace betwixt {

std::string to_string(const Diagnostic& d) {
  static constexpr const char* words[] = {"notice", "warning", "error"};
  const Place& at = d.what.place;
  std::string out;
  if (!at.file.empty()) out += at.file + ":";
  if (at.line > 0) out += fmt::format("{}:{}:", at.line, at.column);
  if (!out.empty()) out += " ";
  out += fmt::format("{}: {}\n", words[static_cast<int>(d.severity)], d.what.message);
  if (at.line > 0 && !d.line.empty()) {
    std::string lead;  // tabs stay tabs, so that the caret stands where the eye expects it
    int characters = 0;
    for (std::size_t i = 0; i < d.line.size() && characters < d.caret; ++i) {
      if (!begins_character(d.line[i])) continue;
      lead += d.line[i] == '\t' ? '\t' : ' ';
      ++characters;
    }
    out += "  " + d.line + "\n  " + lead + "^" +
           std::string(static_cast<std::size_t>(std::clamp(at.length, 1, 60) - 1), '~') + "\n";
  }
  if (!d.what.hint.empty()) out += "  " + d.what.hint + "\n";
  return out;
}

bool has_errors(const Diagnostics& all) {
  return std::any_of(all.begin(), all.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
}

bool has_velocity(Type type) {
  switch (type) {
    case Type::scalar:
    case Type::angle:
    case Type::pair:
    case Type::vector:
    case Type::color:
    case Type::rotation:
    case Type::orientation:
      return true;
    default:
      return false;
  }
}

std::string_view to_string(Type type) {
  switch (type) {
    case Type::scalar:
      return "a number";
    case Type::angle:
      return "an angle";
    case Type::pair:
      return "a pair of numbers";
    case Type::vector:
      return "a vector";
    case Type::color:
      return "a colour";
    case Type::boolean:
      return "on or off";
    case Type::rotation:
      return "a rotation";
    case Type::orientation:
      return "an orientation";
    case Type::shape:
      return "a shape";
    case Type::aim:
      return "a point or an object";
    case Type::text:
      return "a text";
    case Type::points:
      return "a list of points";
    case Type::names:
      return "a list of names";
    case Type::attachment:
      return "an attachment";
    case Type::transform:
      return "a transform";
    case Type::motion:
      return "a motion";
  }
  return "a value";
}

}  // namespace betwixt

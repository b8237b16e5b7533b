// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/utf8.h"

namespace betwixt {

std::string json_text(std::string_view s) {
  std::string out = "\"";
  for (std::size_t i = 0; i < s.size();) {
    const std::size_t n = character_length(s, i);
    const char c = s[i];
    if (n == 0)
      out += "\uFFFD";
    else if (n > 1)
      out += is_hidden(character_at(s, i, n)) ? fmt::format("\\u{:04x}", static_cast<unsigned>(character_at(s, i, n)))
                                              : std::string(s.substr(i, n));
    else if (c == '"' || c == '\\')
      out += '\\', out += c;
    else if (c == '\n')
      out += "\\n";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
    i += n == 0 ? 1 : n;
  }
  return out + "\"";
}

std::string json_words(std::string_view s) { return json_text(visible_lines(s)); }

std::size_t json_depth(std::string_view s) {
  std::size_t depth = 0, most = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const char c = s[i];
    if (quoted && c == '\\')
      ++i;
    else if (c == '"')
      quoted = !quoted;
    else if (!quoted && (c == '[' || c == '{'))
      most = std::max(most, ++depth);
    else if (!quoted && (c == ']' || c == '}') && depth > 0)
      --depth;
  }
  return most;
}

std::string json_number(double n) { return std::isfinite(n) ? fmt::format("{}", n == 0 ? 0.0 : n) : "null"; }

}  // namespace betwixt

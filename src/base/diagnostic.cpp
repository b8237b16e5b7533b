// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"

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

void point_at(Diagnostic& d, std::string_view text, std::string_view part) {
  const std::size_t at = part.empty() ? std::string_view::npos : text.find(part);
  if (at == std::string_view::npos) return;
  const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1,
                    end = std::min(text.find('\n', at), text.size());
  d.line = text.substr(begin, end - begin);
  d.caret = static_cast<int>(count_characters(text.substr(begin, at - begin)));
  d.what.place.line =
      static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) + 1;
  d.what.place.column = d.caret + 1;
  d.what.place.length = static_cast<int>(count_characters(part.substr(0, std::min(part.find('\n'), end - at))));
}

bool has_errors(const Diagnostics& all) {
  return std::any_of(all.begin(), all.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
}

}  // namespace betwixt

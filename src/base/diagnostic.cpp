// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/utf8.h"

namespace betwixt {

namespace {

// Returns spaces as wide as the shown text; tabs stay tabs, so that the caret is in the right column.
std::string spaces_below(std::string_view shown) {
  std::string out;
  for (const char c : shown)
    if (begins_character(c)) out += c == '\t' ? '\t' : ' ';
  return out;
}

}  // namespace

ShownLine shown_line(const Diagnostic& d) {
  const std::string_view line = d.line, before = first_characters(line, static_cast<std::size_t>(std::max(d.caret, 0)));
  const std::string_view marked =
      first_characters(line.substr(before.size()), static_cast<std::size_t>(std::clamp(d.what.place.length, 1, 60)));
  return {visible(line, true), visible(before, true),
          std::clamp<std::size_t>(count_characters(visible(marked, true)), 1, 60)};
}

std::string to_string(const Diagnostic& d) {
  static constexpr const char* words[] = {"notice", "warning", "error"};
  const Place& at = d.what.place;
  std::string out;
  if (!at.file.empty()) out += visible(at.file) + ":";
  if (at.line > 0) out += fmt::format("{}:{}:", at.line, at.column);
  if (!out.empty()) out += " ";
  out += fmt::format("{}: {}\n", words[static_cast<int>(d.severity)], visible_lines(d.what.message));
  if (at.line > 0 && !d.line.empty()) {
    const ShownLine shown = shown_line(d);
    out += "  " + shown.line + "\n  " + spaces_below(shown.before) + "^" + std::string(shown.length - 1, '~') + "\n";
  }
  if (!d.what.hint.empty()) out += "  " + visible_lines(d.what.hint) + "\n";
  return out;
}

std::string to_string(const Error& e) { return to_string(Diagnostic{Severity::error, e, {}, 0}); }

std::string with_line(int line, const std::string& message) {
  return line > 0 ? fmt::format("line {}: {}", line, message) : message;
}

std::string to_string(const Problem& p) {
  const std::string why = with_line(p.line, p.message);
  switch (p.what) {
    case Problem::procedure:
      return fmt::format("{}: the procedure \"{}\" gives no value: {}", p.subject, p.name, why);
    case Problem::filter:
      return fmt::format("{}: the filter '{}' is left out: {}", p.subject, p.name, why);
    case Problem::twerper:
      return fmt::format("the twerper '{}' returned no number and is linear there: {}", p.name, why);
    case Problem::step:
      return fmt::format("{}: {} failed: {}", p.subject, p.name, why);
    case Problem::other:
      break;
  }
  return p.subject + why;
}

std::vector<std::string> to_strings(const std::vector<Problem>& all) {
  std::vector<std::string> out;
  out.reserve(all.size());
  for (const Problem& p : all) out.push_back(to_string(p));
  return out;
}

void point_at(Diagnostic& d, Problem& p, std::string_view text, std::string_view part) {
  std::size_t at = part.empty() ? std::string_view::npos : text.find(part);
  if (at == std::string_view::npos) return;
  for (int line = std::exchange(p.line, 0); line > 1; --line) {
    const std::size_t next = part.find('\n');
    if (next == std::string_view::npos) break;
    const std::size_t first = std::min(part.find_first_not_of(" \t", next + 1), part.size());
    at += first, part.remove_prefix(first);
  }
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

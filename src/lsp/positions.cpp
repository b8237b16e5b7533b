// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "lsp/positions.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"

namespace betwixt {
namespace {

// Returns at least one byte, so that invalid UTF-8 is read byte by byte.
std::size_t bytes_at(std::string_view line, std::size_t i) {
  return std::max<std::size_t>(1, character_length(line, i));
}

std::optional<std::size_t> whole_number_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number_integer()) return std::nullopt;
  if (found->is_number_unsigned()) return found->get<std::size_t>();
  return found->get<std::int64_t>() < 0 ? std::nullopt : std::optional(found->get<std::size_t>());
}

int hex_digit(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

}  // namespace

std::size_t utf16_units(std::string_view s) {
  std::size_t units = 0;
  for (std::size_t i = 0; i < s.size();) {
    const std::size_t bytes = bytes_at(s, i);
    units += bytes == 4 ? 2 : 1;
    i += bytes;
  }
  return units;
}

Json position_at(const ScriptText& lines, std::size_t place) {
  const std::size_t line = lines.line_of(place);
  const std::string_view text = lines.line(line);
  const std::size_t in_line = std::min(place - lines.start(line), text.size());
  return {{"line", line}, {"character", utf16_units(text.substr(0, in_line))}};
}

Json range_of(const ScriptText& lines, Span s) {
  return {{"start", position_at(lines, s.at)}, {"end", position_at(lines, s.end())}};
}

std::optional<std::size_t> place_of(const ScriptText& lines, const Json& position) {
  if (!position.is_object()) return std::nullopt;
  const auto line = whole_number_at(position, "line"), unit = whole_number_at(position, "character");
  if (!line || !unit) return std::nullopt;
  if (*line >= lines.count()) return lines.text().size();
  const std::string_view text = lines.line(*line);
  std::size_t i = 0;
  for (std::size_t units = 0; i < text.size();) {
    const std::size_t bytes = bytes_at(text, i);
    units += bytes == 4 ? 2 : 1;
    if (units > *unit) break;  // inside a character: use its start
    i += bytes;
  }
  return lines.start(*line) + i;
}

std::optional<Span> span_of(const ScriptText& lines, const Json& range) {
  if (!range.is_object() || !range.contains("start") || !range.contains("end")) return std::nullopt;
  const auto from = place_of(lines, range["start"]), to = place_of(lines, range["end"]);
  if (!from || !to) return std::nullopt;
  return Span{*from, std::max(*from, *to) - *from};
}

Span span_of(const ScriptText& lines, const Place& place) {
  if (place.line < 1) return {};
  const std::size_t line = static_cast<std::size_t>(place.line) - 1;
  if (line >= lines.count()) return {lines.text().size(), 0};
  const std::string_view text = lines.line(line);
  const auto characters = [](int n) { return static_cast<std::size_t>(std::max(0, n)); };
  const std::string_view before = first_characters(text, characters(place.column - 1));
  const std::string_view about = first_characters(text.substr(before.size()), characters(place.length));
  return {lines.start(line) + before.size(), about.size()};
}

std::optional<std::string> path_of_uri(std::string_view uri) {
  if (!uri.starts_with("file://")) return std::nullopt;
  uri.remove_prefix(7);
  uri.remove_prefix(std::min(uri.find('/'), uri.size()));  // the host name, which is taken to be this machine
  uri = uri.substr(0, uri.find_first_of("?#"));
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hex_digit(uri[i + 1]) : -1;
    const int low = high < 0 ? -1 : hex_digit(uri[i + 2]);
    if (low < 0) {
      path += uri[i];
      continue;
    }
    path += static_cast<char>(high * 16 + low);
    i += 2;
  }
  return path.empty() || path.find('\0') != std::string::npos ? std::nullopt : std::optional(path);
}

std::string uri_of_path(std::string_view path) {
  constexpr std::string_view plain = "-._~/!$&'()*+,;=:@";
  std::string uri = "file://";
  for (const char c : path) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (kept || plain.find(c) != std::string_view::npos)
      uri += c;
    else
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

}  // namespace betwixt

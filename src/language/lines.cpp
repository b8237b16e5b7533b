// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "base/utf8.h"
#include "syntax/characters.h"

namespace betwixt {
namespace {

int characters(const char* from, const char* to) { return static_cast<int>(count_characters(between(from, to))); }

// Returns the part of a line around a place in it. Long lines are cut.
std::pair<const char*, const char*> around(const char* start, const char* stop, const char* spot) {
  const char *from = start, *to = stop;
  if (spot - from > 100) {
    from = spot - 60;
    while (from < spot && !begins_character(*from)) ++from;
  }
  if (to - from > 160) {
    to = from + 160;
    while (to > spot && to < stop && !begins_character(*to)) --to;
  }
  return {from, std::max(from, to)};
}

}  // namespace

Diagnostic Source::diagnose(Severity severity, Error error, std::string_view about) {
  Diagnostic d{severity, std::move(error), {}, 0};
  const char* begin = text.data();
  const char* end = begin + text.size();
  const char* spot = about.data() ? std::clamp(about.data(), begin, end) : begin;
  if (!counted_) counted_ = begin;
  const auto [before, after] = std::minmax(counted_, spot);
  const auto passed = static_cast<int>(std::count(before, after, '\n'));
  lines_ += spot < counted_ ? -passed : passed;
  counted_ = spot;

  const char* start = spot;
  while (start > begin && start[-1] != '\n') --start;
  const char* stop = line_end(spot, end);
  if (stop > start && stop[-1] == '\r') --stop;
  Place& at = d.what.place;
  at.file = name;
  at.line = lines_;
  at.column = characters(start, spot) + 1;
  const auto rest = static_cast<std::size_t>(std::max(spot, stop) - spot);
  at.length = std::max(1, characters(spot, spot + std::min(about.size(), rest)));
  const auto [from, to] = around(start, stop, spot);
  d.line = std::string(from, to);
  d.caret = characters(from, spot);
  return d;
}

std::optional<Unsound> unsound(std::string_view text) {
  const auto* p = reinterpret_cast<const unsigned char*>(text.data());
  const std::size_t n = text.size();
  const auto bad = [&](std::size_t i, const char* what) {
    return Unsound{i, fail(ErrorCode::file, fmt::format("this is not a text file: {} (byte 0x{:02x})", what, p[i]))};
  };
  // Tests eight plain characters at once: none above 0x7f, and none below 0x20 (a subtraction borrows into its top
  // bit).
  const auto plain = [&](std::size_t i) {
    std::uint64_t w;
    std::memcpy(&w, p + i, 8);
    return ((w | (w - 0x2020202020202020)) & 0x8080808080808080) == 0;
  };
  for (std::size_t i = 0; i < n;) {
    while (i + 8 <= n && plain(i)) i += 8;
    if (i == n) break;
    const unsigned char ch = p[i];
    if (ch < 0x80) {
      if (ch < 0x20 && ch != '\n' && ch != '\t' && ch != '\r') return bad(i, "it contains a control character");
      ++i;
      continue;
    }
    const std::size_t length = character_length(text, i);
    if (length == 0) return bad(i, "it is not UTF-8");
    i += length;
  }
  return std::nullopt;
}

}  // namespace betwixt

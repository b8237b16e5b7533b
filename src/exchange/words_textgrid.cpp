// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words from Praat's TextGrid in its long form.
#include <fmt/format.h>

#include <algorithm>

#include "exchange/words_reading.h"

namespace betwixt {
namespace {

// A tier with intervals: its name, and the lines that it has.
struct GridTier {
  std::string_view name, lines;
};

// Takes `key = value` from a line. Returns false if it is another one.
bool grid_value(std::string_view line, std::string_view key, std::string_view& value) {
  line = without_blanks(line);
  if (!line.starts_with(key)) return false;
  line = without_blanks(line.substr(key.size()));
  if (!line.starts_with('=')) return false;
  return value = without_blanks(line.substr(1)), true;
}

// Two quotes within a text are one.
bool grid_text(WordsReading& in, std::string_view value, std::string& out) {
  out.clear();
  if (!value.starts_with('"')) return in.wrong(value, "a text in quotes is missing here");
  for (std::size_t i = 1; i < value.size(); ++i) {
    if (value[i] != '"') {
      out += value[i];
      continue;
    }
    if (i + 1 == value.size()) return true;
    if (value[++i] != '"') break;
    out += '"';
  }
  return in.wrong(value, "this text is not closed on its line");
}

std::vector<GridTier> interval_tiers(std::string_view text) {
  std::vector<GridTier> all;
  bool open = false;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view line = take_line_of(rest);
    std::string_view value;
    if (grid_value(line, "class", value)) {
      open = value == "\"IntervalTier\"";
      if (open) all.push_back({{}, rest});
    } else if (open && grid_value(line, "name", value)) {
      all.back().name = value;
    } else if (open && without_blanks(line).starts_with("item [")) {
      open = false;
    }
    if (open)
      all.back().lines = {all.back().lines.data(), static_cast<std::size_t>(rest.data() - all.back().lines.data())};
  }
  return all;
}

bool read_tier(WordsReading& in, std::string_view lines) {
  double start = 0, end = 0;
  bool inside = false;
  std::string said;
  for (std::string_view rest = lines; !rest.empty();) {
    const std::string_view line = take_line_of(rest);
    std::string_view value;
    if (without_blanks(line).starts_with("intervals [")) inside = true;
    if (!inside) continue;
    if (grid_value(line, "xmin", value)) {
      if (!in.seconds(value, start)) return false;
    } else if (grid_value(line, "xmax", value)) {
      if (!in.seconds(value, end)) return false;
    } else if (grid_value(line, "text", value)) {
      if (!grid_text(in, value, said)) return false;
      if (end < start) return in.wrong(line, "this interval ends before it begins");
      if (!in.add_sentence(start, end, said, value)) return false;
    }
  }
  return true;
}

}  // namespace

bool read_text_grid(WordsReading& in) {
  const std::vector<GridTier> tiers = interval_tiers(in.text());
  if (tiers.empty())
    return in.wrong(in.text(), "this TextGrid has no tier of intervals; it must be in the long text form");
  const auto named = std::find_if(tiers.begin(), tiers.end(), [](const GridTier& tier) {
    return tier.name == "\"words\"" || tier.name == "\"Words\"" || tier.name == "\"word\"" ||
           tier.name.ends_with(" - words\"");
  });
  return read_tier(in, (named == tiers.end() ? tiers.begin() : named)->lines);
}

}  // namespace betwixt

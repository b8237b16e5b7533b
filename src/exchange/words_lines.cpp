// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words from lines of text: `start end word`, Audacity's labels, WebVTT and SRT.
#include <algorithm>

#include "exchange/words_reading.h"

namespace betwixt {
namespace {

// Takes the text up to a blank or a tab.
std::string_view take_field(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  const std::string_view field = rest.substr(0, rest.find_first_of(" \t"));
  rest.remove_prefix(field.size());
  return field;
}

// Returns where the text goes on that a line leaves open, as `between` does for pointers.
std::string_view from_to(std::string_view from, std::string_view to) {
  return {from.data(), static_cast<std::size_t>(to.data() - from.data())};
}

// Adds the part of a cue between two times. Its tags are removed.
bool add_part(WordsReading& in, double start, double end, std::string_view part) {
  return in.add_sentence(start, std::max(start, end), plain_cue(part), part);
}

// A cue of WebVTT can have the time of each word: One <00:00:01.200>two <00:00:01.700><c>three</c>
bool read_cue_text(WordsReading& in, double start, double end, std::string_view text) {
  std::string_view part = text, rest = text;
  double from = start;
  while (!rest.empty()) {
    const std::size_t open = rest.find('<');
    if (open == std::string_view::npos || open + 1 >= rest.size()) break;
    const std::size_t close = rest.find('>', open);
    if (close == std::string_view::npos) break;
    const std::string_view tag = rest.substr(open + 1, close - open - 1);
    const std::string_view before = from_to(part, rest.substr(open));
    rest.remove_prefix(close + 1);
    if (tag.empty() || tag[0] < '0' || tag[0] > '9') continue;
    double at = 0;
    if (!in.clock(tag, at)) return false;
    if (at < from) return in.wrong(tag, "the times of this cue are out of order");
    if (!add_part(in, from, at, before)) return false;
    from = at, part = rest;
  }
  return add_part(in, from, end, part);
}

// Reads the line with a cue's times, and the lines below it up to an empty one.
bool read_cue(WordsReading& in, std::string_view times, std::string_view& rest) {
  std::string_view line = times;
  double start = 0, end = 0;
  if (!in.clock(take_field(line), start)) return false;
  const std::string_view arrow = take_field(line);
  if (arrow != "-->") return in.wrong(arrow, "--> is missing between the times of this cue");
  const std::string_view until = take_field(line);
  if (!in.clock(until, end)) return false;
  if (end < start) return in.wrong(until, "this cue ends before it begins");
  const std::string_view text = rest;
  std::string_view behind = rest;
  while (!rest.empty() && !without_blanks(take_line_of(rest)).empty()) behind = rest;
  return read_cue_text(in, start, end, from_to(text, behind));
}

}  // namespace

bool read_word_lines(WordsReading& in) {
  for (std::string_view rest = in.text(); !rest.empty();) {
    const std::string_view line = take_line_of(rest);
    std::string_view fields = line;
    const std::string_view first = take_field(fields);
    if (first.empty() || first.starts_with('#') || first.starts_with('\\')) continue;  // Audacity: \ frequencies
    double start = 0, end = 0;
    if (!in.seconds(first, start)) return false;
    const std::string_view second = take_field(fields);
    if (second.empty()) return in.wrong(line, "a line is START END WORD, as in 0.52 0.81 square");
    if (!in.seconds(second, end)) return false;
    if (end < start) return in.wrong(second, "this word ends before it begins");
    if (!in.add_sentence(start, end, fields, first)) return false;
  }
  return true;
}

bool read_cues(WordsReading& in) {
  for (std::string_view rest = in.text(); !rest.empty();) {
    const std::string_view line = take_line_of(rest);
    if (line.starts_with("NOTE") || line.starts_with("STYLE") || line.starts_with("REGION")) {
      while (!rest.empty() && !without_blanks(take_line_of(rest)).empty()) continue;
    } else if (line.find("-->") != std::string_view::npos && !read_cue(in, line, rest)) {
      return false;
    }
  }
  return true;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/ripple.h"

#include <fmt/format.h>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "betwixt/track.h"
#include "scene/document.h"
#include "studio/timeline/time_words.h"

namespace betwixt::studio {
namespace {

// Returns all events from one time to before another.
std::vector<EventAt> events_between(const Document& d, Time from, Time to) {
  std::vector<EventAt> all;
  for (const ObjectId id : objects(d)) {
    if (d.scene().objects[id.index].derived) continue;
    for (const TrackView& t : tracks(d, id))
      each_event(d, t.target, from, to - Time{1}, [&](const EventView& e) { all.push_back({t.target, e.time}); });
  }
  return all;
}

// Appends what `action` (`move`, `clear`) does with the notes, steps and descriptions from one time to another.
void add_cues(const Document& d, std::string_view action, Time from, Time to, const std::string& how, Lines& out) {
  const auto add = [&](std::string_view word, const auto& all) {
    std::optional<Time> first, last;
    for (const auto& cue : all)
      if (from <= cue.time && cue.time <= to) first = first.value_or(cue.time), last = cue.time;
    if (first)
      out.push_back(fmt::format("{} {} {}..{}{}", action, word, format_time(*first, d), format_time(*last, d), how));
  };
  add("notes", d.notes(from, to)), add("steps", d.pauses()), add("descriptions", d.descriptions());
}

// Appends the lines that move everything from a time on, with the end of the film.
void add_moves(const Document& d, Time from, Time by, Lines& to) {
  for (std::string& line : move_lines(d, events_between(d, from, latest_time), by)) to.push_back(std::move(line));
  add_cues(d, "move", from, latest_time, fmt::format(" by {}", length_words(d, by)), to);
  const auto [first, last] = d.range();
  if (last >= from)
    to.push_back(fmt::format("range {} {}", format_time(first, d), format_time(std::max(first, last + by), d)));
}

}  // namespace

Lines insert_time_lines(const Document& d, Time at, Time by) {
  Lines lines;
  if (by > Time{}) add_moves(d, at, by, lines);
  return lines;
}

Lines remove_time_lines(const Document& d, Time from, Time to) {
  Lines lines;
  if (!(to > from)) return lines;
  lines = clear_lines(d, events_between(d, from, to));
  add_cues(d, "clear", from, to - Time{1}, "", lines);
  add_moves(d, to, from - to, lines);
  return lines;
}

}  // namespace betwixt::studio

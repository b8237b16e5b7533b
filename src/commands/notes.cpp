// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Notes at times, and operations on their track.
#include "commands/notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

constexpr std::size_t most_notes = 1'000'000;

bool note(Command& k) {
  auto& [s, c, time, layer, script] = k;
  if (!time) return c.fail_here(ErrorCode::syntax, "a note needs a time", "as in at 24f note \"…\"");
  Note note{*time, {}, {}};
  if (!c.text(note.text)) return false;
  if (!c.at_line_end()) {
    const std::string_view key = c.next_word();
    if (key != "color") return no_choice(c, key, "after its text a note may have a color", "as in color=red");
    if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing after color");
    if (!values(k).color(note.color.emplace())) return false;
  }
  if (!finish(c)) return false;
  s.notes.edit().emplace(*time, std::move(note));
  return true;
}

bool notes(Command& k) { return on_or_off(k.cursor, "notes must be on or off", k.scene.notes_shown); }

constexpr Verb notes_rows[] = {
    {"note", "at TIME note \"…\" [color=COLOR]", "A text at a time, a marker; it shows while the film plays.",
     "at 24f note \"first bounce ends\"\nat 48f note \"check the shadow\" color=gold",
     Verb::timed | Verb::aside | Verb::quick, note, "NUMBER…"},
    {"notes", "notes on or notes off", "Shows or hides notes while the film plays.", "notes off",
     Verb::once | Verb::aside, notes, "on off"},
};

}  // namespace

bool accept_notes(Command& k, std::string_view& word) {
  Cursor& c = k.cursor;
  const char* const start = c.at;
  word = c.next_word();
  if (word == "notes") return true;
  c.at = start;
  return false;
}

Time time_of(double flicks) { return Time{std::llround(std::clamp(flicks, -5e18, 5e18))}; }

bool retime_notes(Command& k, std::string_view word, Segment of,
                  const std::function<void(Time, std::vector<Time>&)>& to) {
  Cursor& c = k.cursor;
  if (!finish(c)) return false;
  std::multimap<Time, Note> stay, go;
  for (const auto& n : *k.scene.notes) {
    auto& to_where = of.from <= n.first && n.first <= of.to ? go : stay;
    to_where.emplace_hint(to_where.end(), n);
  }
  if (go.empty()) k.script.note(Severity::notice, "there are no notes in this segment", word);
  std::vector<Time> times;
  for (auto& [time, note] : go) {
    times.clear();
    to(time, times);
    for (const Time t : times) {
      if (!in_reach(t)) return c.fail(ErrorCode::range, "the notes would be more than 146 years away", word);
      if (stay.size() == most_notes)
        return c.fail(ErrorCode::range, fmt::format("a film can have at most {} notes", most_notes), word);
      note.time = t;
      stay.emplace(t, note);
    }
  }
  k.scene.notes.edit() = std::move(stay);
  return true;
}

std::span<const Verb> notes_verbs() { return notes_rows; }

}  // namespace betwixt

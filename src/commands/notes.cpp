// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Notes at times, and operations on the tracks of notes, steps and descriptions.
#include "commands/notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace betwixt {
namespace {

constexpr std::size_t most_notes = 1'000'000;
constexpr std::string_view names_of_cues[] = {"notes", "steps", "descriptions"};

using Retiming = std::function<void(Time, std::vector<Time>&)>;
struct CuesAbout {
  std::string_view word;
  std::size_t most;
};

void put_cue(std::multimap<Time, Note>& all, const Note& note) { all.emplace(note.time, note); }
template <class Cue>
void put_cue(std::map<Time, Cue>& all, const Cue& cue) {
  all.insert_or_assign(cue.time, cue);
}

template <class Map>
bool retime(Command& k, Cow<Map>& all, CuesAbout about, Segment of, const Retiming& to) {
  Map stay, go;
  for (const auto& cue : *all) {
    Map& to_where = of.from <= cue.first && cue.first <= of.to ? go : stay;
    to_where.emplace_hint(to_where.end(), cue);
  }
  if (go.empty())
    k.script.note(Severity::notice, fmt::format("there are no {} in this segment", about.word), about.word);
  // Round by round, so that each copy replaces what the one before it left at its times.
  std::vector<std::vector<typename Map::mapped_type>> rounds;
  std::vector<Time> times;
  const auto fails = [&](std::string why) { return k.cursor.fail(ErrorCode::range, std::move(why), about.word); };
  std::size_t count = stay.size();
  for (auto& [time, cue] : go) {
    times.clear();
    to(time, times);
    if ((count += times.size()) > about.most)
      return fails(fmt::format("a film can have at most {} {}", about.most, about.word));
    rounds.resize(std::max(rounds.size(), times.size()));
    for (std::size_t n = 0; n < times.size(); ++n) {
      if (!in_reach(times[n])) return fails(fmt::format("the {} would be more than 146 years away", about.word));
      cue.time = times[n];
      rounds[n].push_back(cue);
    }
  }
  for (const auto& round : rounds)
    for (const auto& cue : round) put_cue(stay, cue);
  all.edit() = std::move(stay);
  return true;
}

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

std::optional<Cues> accept_cues(Command& k, std::string_view& word) {
  Cursor& c = k.cursor;
  const char* const start = c.at;
  word = c.next_word();
  for (std::size_t i = 0; i < std::size(names_of_cues); ++i)
    if (word == names_of_cues[i]) return static_cast<Cues>(i);
  c.at = start;
  return std::nullopt;
}

Time time_of(double flicks) { return Time{std::llround(std::clamp(flicks, -5e18, 5e18))}; }

bool retime_cues(Command& k, Cues which, std::string_view word, Segment of, const Retiming& to) {
  if (!finish(k.cursor)) return false;
  Scene& s = k.scene;
  switch (which) {
    case Cues::notes:
      return retime(k, s.notes, {word, most_notes}, of, to);
    case Cues::steps:
      return retime(k, s.pauses, {word, most_cues}, of, to);
    case Cues::descriptions:
      return retime(k, s.descriptions, {word, most_cues}, of, to);
  }
  return false;
}

std::span<const Verb> notes_verbs() { return notes_rows; }

}  // namespace betwixt

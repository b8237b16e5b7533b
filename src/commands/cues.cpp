// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a film says to the people around it: where a speaker waits, and what somebody who cannot see it is told.
#include <fmt/format.h>

#include "commands/notes.h"
#include "commands/translating.h"

namespace betwixt {
namespace {

constexpr std::size_t longest_cue = 10'000;  // bytes

bool cue_text(Cursor& c, std::string& out) {
  c.space();
  const char* const start = c.at;
  if (!c.text(out)) return false;
  return out.size() <= longest_cue ||
         c.fail(ErrorCode::range, fmt::format("this text is longer than {} bytes", longest_cue), {start, 1});
}

template <class Map>
bool has_room(Cursor& c, const Map& all, std::string_view about) {
  return all.size() < most_cues ||
         c.fail(ErrorCode::range, fmt::format("a film can have at most {} of these", most_cues), about);
}

// [at TIME] step ["text"] [note="…"]
bool step(Command& k) {
  auto& [s, c, time, layer, script] = k;
  Pause pause{time.value_or(c.clock.begin), {}, {}};
  c.space();
  if (c.peek() == '"' && !cue_text(c, pause.text)) return false;
  if (!c.at_line_end()) {
    const std::string_view key = c.next_word();
    if (key == "at") return no_choice(c, key, "the time stands before 'step'", "as in at 24f step \"The proof\"");
    if (key != "note")
      return no_choice(c, key, "a step may have a text and a note", "as in step \"The proof\" note=\"…\"");
    if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing after note");
    if (!cue_text(c, pause.note)) return false;
  }
  if (!finish(c) || !has_room(c, *s.pauses, {script.verb, 4})) return false;
  s.pauses.edit().insert_or_assign(pause.time, std::move(pause));
  return true;
}

// at TIME describe "…"
bool describe_film(Command& k) {
  auto& [s, c, time, layer, script] = k;
  if (!time)
    return c.fail_here(ErrorCode::syntax, "a description needs a time", "as in at 24f describe \"The ball falls\"");
  Description said{*time, {}};
  c.space();
  const char* const start = c.at;
  if (!cue_text(c, said.text)) return false;
  translate_text(script, said.text, c.since(start));
  if (!finish(c) || !has_room(c, *s.descriptions, {script.verb, 8})) return false;
  s.descriptions.edit().insert_or_assign(said.time, std::move(said));
  return true;
}

constexpr Verb cues_rows[] = {
    {"step", "[at TIME] step [\"TEXT\"] [note=\"…\"]",
     "A place where a speaker waits when the film is presented. The text is its name, the note is for the speaker.",
     "at 24f step \"The proof\" note=\"Ask who knows it\"", Verb::timed | Verb::aside | Verb::quick, step, "note=…"},
    {"describe", "at TIME describe \"TEXT\"",
     "Says what is to be seen from this time on, for people who cannot see the film.",
     "at 48f describe \"The ball falls\"", Verb::timed | Verb::aside | Verb::quick | Verb::after_time, describe_film},
};

}  // namespace

std::span<const Verb> cues_verbs() { return cues_rows; }

}  // namespace betwixt

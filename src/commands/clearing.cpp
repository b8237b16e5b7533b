// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The command `clear`: events or notes of a segment, at one time, or those that no later value needs.
#include <fmt/format.h>

#include <algorithm>

#include "commands/notes.h"
#include "commands/segments.h"
#include "scene/names.h"

namespace betwixt {
namespace {

// Returns whether the target's value may depend on all earlier events: an object that was let go, a value that velocity
// has moved, a filter with memory, a track that repeats.
bool needs_all_before(const Scene& s, const Target& t) {
  const Slot* const slot = s.objects[t.object.index].find(t.function, t.layer);
  if (!slot) return false;
  const Type type = spec_of(s, t.function).type;
  if (type == Type::attachment || type == Type::motion || !slot->filters.empty()) return true;
  const auto comes_round = [](const Cow<Track>& track) { return track->after != Extrapolation::hold; };
  const auto empty = [](const Cow<Track>& track) { return track->events.empty(); };
  const auto any = [](const auto& components, const auto& is) {
    return std::any_of(components.begin(), components.end(), is);
  };
  return comes_round(slot->track) || any(slot->components, comes_round) || !empty(slot->velocity.track) ||
         any(slot->velocity.components, [&](const Cow<Track>& track) { return !empty(track); });
}

// Reads the rest of `clear TARGET before`.
bool clear_before(Command& k, Stretch& on, std::optional<Cues> cues) {
  Time t;
  if (!k.cursor.time(t)) return false;
  if (cues) return retime_cues(k, *cues, on.word, {Time{INT64_MIN}, t - Time{1}}, [](Time, auto&) {});
  std::size_t whole = 0;
  std::string left;
  std::erase_if(on.of.targets, [&](const Target& target) {
    if (!needs_all_before(k.scene, target)) return false;
    if (++whole <= 3) left += (left.empty() ? "" : ", ") + target_name(k.scene, target);
    return true;
  });
  if (whole > 3) left += fmt::format(" and {} more", whole - 3);
  if (whole > 0)
    k.script.note(Severity::notice, "not cleared, because later values depend on all earlier events: " + left, on.word);
  if (on.of.targets.empty()) return finish(k.cursor);
  const auto erase = [&](Track& track, Type type, int, const Target&) -> Result<Changed> {
    return Changed{erase_before(track, t, row_of(type).changes), 0};
  };
  return operate(k, on, erase, false);
}

bool clear(Command& k) {
  Cursor& c = k.cursor;
  Stretch on;
  const std::optional<Cues> cues = accept_cues(k, on.word);
  if (!cues) on.word = c.next_word();
  if (!cues && !targets(k, on.word, on.of, Meant::any)) return false;
  if (c.accept_word("before")) return clear_before(k, on, cues);
  const char* const start = (c.space(), c.at);
  if (!c.time(on.segment.from)) return false;
  on.segment.to = on.segment.from;
  if (c.end - c.at > 1 && c.at[0] == '.' && c.at[1] == '.') {
    c.at += 2;
    if (!c.time(on.segment.to)) return false;
    if (on.segment.to < on.segment.from)
      return c.fail(ErrorCode::range, "this segment ends before it begins", c.since(start));
  }
  if (cues) return retime_cues(k, *cues, on.word, on.segment, [](Time, auto&) {});
  const auto erase = [&](Track& t, Type, int, const Target&) -> Result<Changed> {
    return Changed{t.events.erase(on.segment.from, on.segment.to), 0};
  };
  return operate_and_say(k, on, erase, false);
}

constexpr Verb clearing_rows[] = {
    {"clear", "clear TARGET A..B, clear TARGET TIME or clear TARGET before TIME",
     "Removes events, notes, steps or descriptions: those of a segment, those at one time, or, with `before`, those "
     "that no later value "
     "needs.",
     "clear ball.position 6f..18f", Verb::layered, clear, "TARGET; before"},
};

}  // namespace

std::span<const Verb> clearing_verbs() { return clearing_rows; }

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands about visibility and the active camera.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/names.h"
#include "commands/command.h"

namespace betwixt {
namespace {

// Reads `for LENGTH [wipe=WORD]`, the way to the next camera, if it takes time.
bool way_to_camera(Command& k, std::optional<CutWay>& way) {
  Cursor& c = k.cursor;
  c.space();
  const std::string_view word = c.peek_word();
  if (!c.accept_word("for")) return true;
  if (!k.time)
    return c.fail(ErrorCode::syntax, "a change of the camera that takes time needs a beginning", word,
                  "as in at 48f look through eye for 12f");
  c.space();
  const char* const start = c.at;
  way.emplace();
  if (!c.length(way->length)) return false;
  if (way->length <= Time{}) return c.fail(ErrorCode::range, "the change must last longer than 0", c.since(start));
  c.space();
  if (c.at_line_end()) return true;
  const std::string_view key = c.word();
  if (key != "wipe" || c.peek() != '=') return c.fail(ErrorCode::syntax, "wipe= or nothing may follow here", key);
  ++c.at;
  const std::string_view w = c.next_word();
  const auto* const at = std::find(change_names.begin() + 1, change_names.end(), w);
  if (at == change_names.end())
    return no_choice(c, w, "a wipe must be left, right, up, down or iris",
                     did_you_mean(w, {change_names.begin() + 1, change_names.end()}));
  way->kind = static_cast<ChangeKind>(at - change_names.begin());
  return true;
}

bool look(Command& k) {
  auto& [s, c, time, layer, script] = k;
  if (!c.accept_word("through")) return c.fail_here(ErrorCode::syntax, "'through' is missing here");
  ObjectId id;
  c.space();
  const std::string_view w = c.peek_word();
  if (!values(k).object(id)) return false;
  const Kind kind = s.objects[id.index].kind;
  if (kind != Kind::camera)
    return c.fail(ErrorCode::type, fmt::format("'{}' is a {}, not a camera", w, name_of(kind)), w);
  std::optional<CutWay> way;
  if (!way_to_camera(k, way) || !finish(c)) return false;
  const Time from = time.value_or(Time{INT64_MIN});
  s.cuts.edit()[from] = id;
  if (way) s.cut_ways.edit()[from] = *way;
  if (!way && s.cut_ways->count(from) > 0) s.cut_ways.edit().erase(from);
  return true;
}

template <bool on>
bool display(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> found;
  if (!objects(k, word, found) || !finish(c)) return false;
  for (ObjectId id : found) {
    Target t{id, fn::display, -1};
    t.layer = layer;
    if (!time) {
      set_value(s, t, on);
      continue;
    }
    Event e;
    e.time = *time;
    e.value = on;
    put_event(s, t, std::move(e));
  }
  return true;
}

constexpr Verb showing_rows[] = {
    {"look", "at TIME look through CAMERA [for LENGTH [wipe=left|right|up|down|iris]]",
     "Changes the camera from this time on: a cut. With `for`, the picture of the one before dissolves into the new "
     "one, "
     "or a wipe shows the new one.",
     "at 24f look through eye\nat 24f look through eye for 12f wipe=left", Verb::timed | Verb::aside | Verb::quick,
     look, "through; CAMERA for wipe=left wipe=right wipe=up wipe=down wipe=iris"},
    {"show", "show A or at TIME show A", "Shows objects, from a time on or for the whole film.", "at 12f show ball",
     Verb::timed | Verb::layered | Verb::aside | Verb::quick, display<true>, "OBJECT…"},
    {"hide", "hide A or at TIME hide A", "Hides objects, from a time on or for the whole film.", "at 24f hide ball",
     Verb::timed | Verb::layered | Verb::aside | Verb::quick, display<false>, "OBJECT…"},
};

}  // namespace

std::span<const Verb> showing_verbs() { return showing_rows; }

}  // namespace betwixt

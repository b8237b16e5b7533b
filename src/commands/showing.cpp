// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands about visibility and the active camera.
#include <fmt/format.h>

#include <algorithm>

#include "commands/command.h"

namespace betwixt {
namespace {

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
  if (!finish(c)) return false;
  s.cuts.edit()[time.value_or(Time{INT64_MIN})] = id;
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
    {"look", "at TIME look through CAMERA", "Changes the camera from this time on: a cut.", "at 24f look through eye",
     Verb::timed | Verb::aside | Verb::quick, look, "through; CAMERA"},
    {"show", "show A or at TIME show A", "Shows objects, from a time on or for the whole film.", "at 12f show ball",
     Verb::timed | Verb::layered | Verb::aside | Verb::quick, display<true>, "OBJECT…"},
    {"hide", "hide A or at TIME hide A", "Hides objects, from a time on or for the whole film.", "at 24f hide ball",
     Verb::timed | Verb::layered | Verb::aside | Verb::quick, display<false>, "OBJECT…"},
};

}  // namespace

std::span<const Verb> showing_verbs() { return showing_rows; }

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that attach objects to each other and detach them.
#include <fmt/format.h>

#include <algorithm>

#include "commands/command.h"
#include "scene/names.h"

namespace betwixt {
namespace {

template <AttachmentKind kind>
bool take_hold(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> children;
  if (!objects(k, word, children)) return false;
  constexpr std::string_view link = kind == AttachmentKind::hang ? "on" : "to";
  if (!c.accept_word(link)) return c.fail_here(ErrorCode::syntax, fmt::format("'{}' is missing here", link));
  Attachment to{kind, {}, false};
  c.space();
  const char* start = c.at;
  if (!values(k).object(to.parent)) return false;
  if (const Object& parent = s.objects[to.parent.index]; parent.kind == Kind::environment)
    return c.fail(ErrorCode::type, fmt::format("'{}' is an environment, so it cannot be a parent", parent.name),
                  c.since(start),
                  fmt::format("to put an object into it: set {}.environments ({})", word.substr(0, 40), parent.name));
  to.keep_world = c.accept_word("keep-world");
  if (!finish(c)) return false;
  return attachment(k, children, to, time, word);
}

template <AttachmentKind kind>
bool let_loose(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> children;
  if (!objects(k, word, children) || !finish(c)) return false;
  if (kind == AttachmentKind::letgo && !time)
    return c.fail(ErrorCode::syntax, "letgo needs a time", word,
                  fmt::format("as in at 60f letgo {}", word.substr(0, 40)));
  return attachment(k, children, {kind, {}, false}, time, word);
}

constexpr Verb attachments_rows[] = {
    {"hang", "hang A on B [keep-world]", "Hangs an object on another: it moves along, but does not turn with it.",
     "at 20f hang ball on hand", Verb::timed | Verb::aside | Verb::quick, take_hold<AttachmentKind::hang>,
     "OBJECT; on; OBJECT; keep-world"},
    {"attach", "attach A to B [keep-world]", "Attaches an object to another: it moves and turns along.",
     "at 20f attach ball to hand keep-world", Verb::timed | Verb::aside | Verb::quick,
     take_hold<AttachmentKind::attach>, "OBJECT; to; OBJECT; keep-world"},
    {"couple", "couple A to B [keep-world]", "Couples an object to another: it moves, turns and scales along.",
     "couple ball to hand", Verb::timed | Verb::aside | Verb::quick, take_hold<AttachmentKind::couple>,
     "OBJECT; to; OBJECT; keep-world"},
    {"detach", "detach A", "Detaches an object from its parent: its own tracks place it in the world.", "detach ball",
     Verb::timed | Verb::aside | Verb::quick, let_loose<AttachmentKind::detach>, "OBJECT…"},
    {"letgo", "at TIME letgo A", "Releases an object from its parent: it keeps its place, without a jump.",
     "at 20f attach ball to hand\nat 60f letgo ball", Verb::timed | Verb::aside | Verb::quick,
     let_loose<AttachmentKind::letgo>, "OBJECT…"},
};

}  // namespace

void say_fall_ends(Command& k, ObjectId child, Time when, std::string_view about) {
  Scene& s = k.scene;
  if (end_fall(s, child, when))
    k.script.note(Severity::notice,
                  fmt::format("the fall of {} now ends at {}, where an object holds it", s.objects[child.index].name,
                              format_time(when, s.rate)),
                  about);
}

// Puts an attachment on the tracks of `children`. Changes nothing if one of them would depend on itself.
bool attachment(Command& k, const std::vector<ObjectId>& children, const Attachment& to, std::optional<Time> when,
                std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  if (layer) return c.fail(ErrorCode::type, "a layer cannot have attachments", about);
  const Scene before = s;
  for (ObjectId child : children) {
    if (to.kind >= AttachmentKind::hang) {
      if (!placed(s.objects[to.parent.index].kind) || !placed(s.objects[child.index].kind)) {
        s = before;
        return c.fail(ErrorCode::type, "layers and environments cannot have a parent or be one", about);
      }
      // The end of the attachment: its next event.
      Time until{INT64_MAX};
      const Time from = when.value_or(Time{INT64_MIN});
      const auto known = attachments(s.objects[child.index]);
      for (const AttachmentSpan& a : known)
        if (a.from > from) {
          until = a.from;
          break;
        }
      if (const auto path = circle(s, child, to.parent, from, until); !path.empty()) {
        const std::string name = s.objects[child.index].name;
        std::string way;
        for (ObjectId at : path) way += s.objects[at.index].name + " → ";
        s = before;
        static constexpr std::string_view words[] = {"", "", "hung on", "attached to", "coupled to"};
        return c.fail(ErrorCode::name,
                      child == to.parent
                          ? fmt::format("'{}' cannot be {} itself", name, words[static_cast<std::size_t>(to.kind)])
                          : fmt::format("this would make a cycle: {}{}", way, name),
                      about);
      }
      if (!s.objects[to.parent.index].leads) s.objects.edit(to.parent.index).leads = true;
    }
    if (!when) {
      set_value(s, {child, fn::attachment}, to);
      continue;
    }
    if (to.kind >= AttachmentKind::hang) say_fall_ends(k, child, *when, about);
    Event e;
    e.time = *when;
    e.value = to;
    put_event(s, {child, fn::attachment}, std::move(e));
  }
  return true;
}

std::span<const Verb> attachments_verbs() { return attachments_rows; }

}  // namespace betwixt

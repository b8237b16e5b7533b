// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands that write values and events.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/cancellation.h"
#include "base/names.h"
#include "commands/furnishing.h"
#include "commands/verbs.h"
#include "track/curve.h"

namespace betwixt {
namespace {

bool at(Command& k) {
  auto& [s, c, time, layer, script] = k;
  if (time) return c.fail_here(ErrorCode::syntax, "a command can have only one 'at'");
  std::optional<Time> until;
  c.space();
  const char* const times = c.at;
  Time from;
  if (!time_or_segment(c, from, until)) return false;
  const std::string_view segment = c.since(times);
  Command timed{s, c, from, layer, script};
  c.space();
  const char* start = c.at;
  const bool sets = c.accept_word("set");  // at T set TARGET VALUE is at T TARGET VALUE
  const std::string_view w = c.next_word();
  if (w.empty())
    return c.fail_here(ErrorCode::syntax, sets ? "a target is missing here" : "a target or a command is missing here");
  if (sets || w.find('.') != std::string_view::npos) {
    show_lists(s, script);
    return to_each_type(timed, w, start, [&](const Selected& to) {
      if (until && to.type() == Type::motion) return moving(timed, to, from, until);
      timed.cursor.space();
      if (goes_along(timed.cursor)) return along_line(timed, to, from, until);
      return until ? one_time_only(timed.cursor, segment) : event(timed, to, from);
    });
  }
  if (until) return one_time_only(c, segment);
  c.at = start;
  const Verb* verb = find_verb(w);
  if (verb && layer && verb->flags & Verb::timed && !(verb->flags & Verb::layered)) return on_no_layer(c, w);
  if (verb && verb->flags & Verb::timed) return carry_out(timed);
  if (verb) return c.fail(ErrorCode::syntax, fmt::format("'{}' takes no time: it applies to the whole film", w), w);
  if (const auto why = not_of_a_script(w); !why.empty())
    return c.fail(ErrorCode::name, fmt::format("'{}' {}", w, why), w);
  const Hint near = did_you_mean(w, verb_words(Verb::timed));
  return c.fail(ErrorCode::syntax, fmt::format("expected a target or a command here, not '{}'", w.substr(0, 40)), w,
                near.empty() ? "as in at 24f ball.position (1 2 3)" : near);
}

// Reports a `set` that is never visible: it applies only before the track's first event.
void say_unseen(Command& k, const Selected& to, std::string_view about) {
  const Time begins = k.scene.range ? k.scene.range->first : Time{};
  for (const Target& t : to.targets)
    for (const Track* track : tracks_of(k.scene, t))
      if (!track->events.empty() && track->events.front().time <= begins)
        return k.script.note(
            Severity::warning, "this track has events from the beginning, so 'set' has no effect", about,
            fmt::format("change an event with at TIME {} VALUE, or remove the events with clear", about.substr(0, 60)));
}

// Fails if the target is a component that cannot be set by itself.
bool has_components(Command& k, const Target& t, std::string_view about) {
  const Slot* slot = k.scene.objects[t.object.index].find(t.function, t.layer);
  if (t.component < 0 || !slot || !slot->set) return true;
  if (std::holds_alternative<Procedure>(*slot->set))
    return k.cursor.fail(ErrorCode::type, "code computes the whole value, so its components cannot be set", about);
  if (std::holds_alternative<Quat>(*slot->set))
    return k.cursor.fail(ErrorCode::type, "an orientation has no separate angles", about,
                         "set the whole value as euler(x y z) first");
  return true;
}

// Sets a component by code. `set` stores one whole value, of which code cannot give a part, so the component's own
// track begins with the code.
bool compute_component(Command& k, const Selected& to, const Value& code) {
  Event e;
  e.time = std::min(k.scene.range ? k.scene.range->first : Time{}, Time{});
  e.value = code;
  const auto free = [&](const Track* track) {
    if (track->events.empty() || e.time < track->events.front().time) return true;
    return track->events.front().time == e.time && std::holds_alternative<Procedure>(track->events.front().value);
  };
  for (const Target& t : to.targets) {
    if (!has_components(k, t, to.text)) return false;
    const auto tracks = tracks_of(k.scene, t);
    if (!std::all_of(tracks.begin(), tracks.end(), free)) return say_unseen(k, to, to.text), true;
  }
  for (const Target& t : to.targets) Cancellation::check(), put_event(k.scene, t, e);
  return true;
}

// Couples an object that goes to other axes to them, if it was coupled to those that it was on.
bool goes_to_axes(Command& k, ObjectId id, const Value& v, std::string_view about) {
  const Object& o = k.scene.objects[id.index];
  const Slot *on = o.find(fn::on_axes), *slot = o.find(fn::attachment);
  const auto* was = on && on->set ? std::get_if<ObjectId>(&*on->set) : nullptr;
  const auto* coupled = slot && slot->set ? std::get_if<Attachment>(&*slot->set) : nullptr;
  const auto* axes = std::get_if<ObjectId>(&v);
  if (!axes || !*axes || (coupled && coupled->parent && (!was || coupled->parent != *was))) return true;
  Object moved = o;
  moved.slot(fn::on_axes).set = v;
  ObjectId parent;
  if (!put_on_axes(k, moved, parent, about)) return false;
  set_value(k.scene, Target{id, fn::attachment}, Attachment{AttachmentKind::couple, parent, false});
  return true;
}

bool set_alike(Command& k, const Selected& to) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view w = to.text;
  if (time) return event(k, to, *time);
  Value v;
  c.space();
  // For a live host, `set` of environments takes effect now, not from the beginning.
  if (script.options.now && to.type() == Type::names) {
    script.stamp(s, {script.verb, static_cast<std::size_t>(w.data() - script.verb)}, "at ", " ");
    c.ticks_read = true;
    return event(k, to, *script.options.now);
  }
  if (to.velocity)
    return c.fail(ErrorCode::type, "a velocity needs a time", w, fmt::format("as in at 1f {} …", w.substr(0, 60)));
  if (to.type() == Type::motion)
    return c.fail(ErrorCode::type, "a motion cannot be set: it needs a segment of time", w,
                  fmt::format("as in at 1f..24f {} T(6 0)", w.substr(0, 60)));
  if (c.peek() == '=') {
    if (!computed(k, to, v) || !finish(c)) return false;
    if (to.component >= 0) return compute_component(k, to, v);
    for (const Target& t : to.targets) Cancellation::check(), set_value(s, t, v);
    return true;
  }
  if (goes_along(c)) return set_along_line(k, to);
  if (to.type() == Type::attachment)
    return c.fail(ErrorCode::type, "an attachment cannot be set", w,
                  "write couple A to B, attach A to B, hang A on B or detach A");
  if (!values(k).value(*to.spec, to.component, v, to.targets[0].function) || !finish(c)) return false;
  for (const Target& t : to.targets) {
    if (!draws(k, t, w) || !focuses_elsewhere(k, t, v, w) || !has_components(k, t, w)) return false;
  }
  say_unseen(k, to, w);
  for (const Target& t : to.targets) {
    Cancellation::check();
    if (t.function == fn::on_axes && !goes_to_axes(k, t.object, v, w)) return false;
    set_value(s, t, v);
  }
  say_missing_style(k, s.objects[to.targets[0].object.index], to.targets[0].function, v, w);
  for (const Target& t : to.targets)
    if (!make_parts(k, t.object, t.function, v, w)) return false;
  return true;
}

bool set(Command& k) {
  const std::string_view w = k.cursor.next_word();
  return to_each_type(k, w, w.data(), [&](const Selected& to) { return set_alike(k, to); });
}

// Reads NAME [in=light|srgb] for values of one type.
bool twerper_of_all(Command& k, const Selected& to, bool none) {
  auto& [s, c, time, layer, script] = k;
  Twerper chosen = Twerper::unset;
  TwerperArguments arguments;
  if (!none && !twerper(k, to, chosen, arguments)) return false;
  std::optional<bool> srgb;
  if (!c.at_line_end()) {
    const std::string_view key = c.peek_word();
    if (key != "in") return finish(c);
    c.word();
    if (!c.accept('=')) return c.fail_here(ErrorCode::syntax, "'=' is missing after in");
    const std::string_view how = c.next_word();
    if (how != "light" && how != "srgb") return no_choice(c, how, "write in=light or in=srgb");
    if (!row_of(to.type()).light)
      return c.fail(ErrorCode::type,
                    fmt::format("only colours can blend in light or srgb; this is {}", to_string(to.type())), key);
    srgb = how == "srgb";
  }
  if (!finish(c)) return false;
  for (const Target& t : to.targets)
    for (Track* track : edit_tracks(s, t)) {
      track->global = chosen;
      track->arguments = arguments;
      if (srgb) track->srgb = *srgb;
    }
  return true;
}

bool global_twerper(Command& k) {
  Selected to;
  if (!targets(k, k.cursor.next_word(), to, Meant::any)) return false;
  if (!to.spec) to.spec = &built_in_functions()[fn::position];  // the rest is still read
  const bool none = k.cursor.accept_word("none");
  if (none && k.cursor.at_line_end()) return twerper_of_all(k, to, none);
  return for_each_type(k, to, [&](const Selected& one) { return twerper_of_all(k, one, none); });
}

bool extend(Command& k) {
  auto& [s, c, time, layer, script] = k;
  Selected to;
  if (!targets(k, c.next_word(), to, Meant::any)) return false;
  const std::string_view how = c.next_word();
  const auto at = std::find(extrapolation_names.begin(), extrapolation_names.end(), how);
  if (at == extrapolation_names.end())
    return no_choice(c, how,
                     how.empty() ? "hold, linear, cycle or bounce is missing here"
                                 : fmt::format("a track must be extended by hold, linear, cycle or bounce, not '{}'",
                                               how.substr(0, 40)),
                     did_you_mean(how, {extrapolation_names.begin(), extrapolation_names.end()}));
  bool before = true, after = true;
  if (c.accept_word("before"))
    after = false;
  else if (c.accept_word("after"))
    before = false;
  if (!finish(c)) return false;
  const auto extend = static_cast<Extrapolation>(at - extrapolation_names.begin());
  const auto holds = [&](const Target& t) { return t.function == fn::attachment && extend != Extrapolation::hold; };
  std::vector<Target> holding;
  std::copy_if(to.targets.begin(), to.targets.end(), std::back_inserter(holding), holds);
  std::erase_if(to.targets, holds);
  const std::string why = fmt::format("an attachment cannot be extended by {}", how);
  if (to.targets.empty() && !holding.empty())
    return c.fail(ErrorCode::type, why, how,
                  fmt::format("repeat it with copy: copy {} 1f..24f to 25f times 3", to.text.substr(0, 60)));
  if (!holding.empty()) say_left_out(k, holding, to.text, why);
  for (const Target& t : to.targets)
    for (Track* track : edit_tracks(s, t)) {
      if (before) track->before = extend;
      if (after) track->after = extend;
    }
  return true;
}

constexpr Verb tracks_rows[] = {
    {"set", "set TARGET VALUE, as in set ball.color red",
     "Sets the value of a function; it applies while the track has no events.", "set ball.color red",
     Verb::timed | Verb::layered | Verb::aside | Verb::quick, set, "TARGET; VALUE; WAY…"},
    {"at", "at TIME TARGET VALUE or at TIME COMMAND", "Gives a command its time, or puts one event on a track.",
     "at 12f ball.radius 2 ease-in=4f", Verb::layered | Verb::prefix | Verb::quick, at, "NUMBER"},
    {"twerper", "twerper TARGET NAME [in=light|srgb] or twerper TARGET none",
     "Sets the twerper (interpolation, easing) of a whole track; none gives every event its own again.",
     "twerper ball.position linear", Verb::layered, global_twerper, "TARGET; TWERPER none; in=light in=srgb"},
    {"extend", "extend TARGET hold|linear|cycle|bounce [before|after]",
     "The extrapolation of a track: its values before its first and after its last event.",
     "extend ball.position cycle", Verb::layered, extend, "TARGET; hold linear cycle bounce; before after"},
};

}  // namespace

std::span<const Verb> tracks_verbs() { return tracks_rows; }

}  // namespace betwixt

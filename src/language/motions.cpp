// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motions in scripts: 1f..48f T(6.28 0) R(-1turn @ 0 1). On the track a motion is an event that reigns up to the next
// one; where nothing moves, an empty motion stands.
#include <fmt/format.h>

#include "base/names.h"
#include "language/reader.h"

namespace betwixt {
namespace {

bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// The factors from here on: one-letter words, each with what stands in its brackets.
std::string_view factors(const char* from, const char* end) {
  const char* last = from;
  for (const char* p = from; p < end;) {
    if (*p == ' ' || *p == '\t' || *p == ',' || *p == '*') {
      ++p;
      continue;
    }
    if (!letter(*p) || (p + 1 < end && (letter(p[1]) || p[1] == '-' || p[1] == '='))) break;
    const char* open = p + 1;
    while (open < end && (*open == ' ' || *open == '\t')) ++open;
    if (open == end || *open != '(') {
      last = line_end(p, end);  // whatever it is: the one who reads motions says what is wrong with it
      break;
    }
    const char* close = std::find(open, end, ')');
    if (close == end) {
      last = line_end(open, end);
      break;
    }
    // A new line or another bracket inside: the closing one is missing, or stands behind that of a centre.
    if (const char* inner = std::find(open + 1, close, '('); inner != close) close = std::find(close + 1, end, ')');
    p = last = close == end ? line_end(open, end) : close + 1;
  }
  return {from, static_cast<std::size_t>(last - from)};
}

const char* character(const char* at, const char* end, int count) {
  for (; count > 0 && at < end; --count) {
    ++at;
    while (at < end && (*at & 0xC0) == 0x80) ++at;
  }
  return at;
}

bool moves(const Event& e) {
  const auto* m = std::get_if<Moves>(&e.value);
  return !e.keep && m && !(*m)->factors.empty();
}

}  // namespace

bool ValueReader::motion(Moves& out) {
  c.space();
  const char* start = c.at;
  std::string quoted;
  std::string_view text;
  if (c.peek() == '"') {
    if (!c.text(quoted)) return false;
    text = quoted;
  } else {
    text = factors(start, c.end);
    if (text.empty())
      return c.fail_here(Code::syntax, "a motion is wanted here",
                         "a string of T(…), R(…) and S(…), as in T(6.28 0) R(-1turn @ 0 1)");
    c.at = text.data() + text.size();
  }
  const auto part = [&](int column, int length) -> std::string_view {
    if (!quoted.empty()) return c.since(start);
    const char *from = character(text.data(), c.at, column - 1), *to = character(from, c.at, length);
    return {from, static_cast<std::size_t>(to - from)};
  };
  auto read = parse_motion(text);
  if (!read) {
    const Error& e = read.error();
    return c.fail(e.code, e.message, part(e.place.column, e.place.length), e.hint);
  }
  for (const Factor& f : read->factors) {
    if (f.about.empty()) continue;
    const std::size_t at = text.find(f.about, text.find('@'));
    const std::string_view about = quoted.empty() ? text.substr(at, f.about.size()) : c.since(start);
    Cursor name(f.about);
    ObjectId id;
    ValueReader reader{name, scene, {}, {}};
    if (!reader.object(id)) return c.fail(name.error->code, name.error->message, about, name.error->hint);
    if (!placed(scene.objects[id.index].kind))
      return c.fail(Code::type, fmt::format("'{}' is nowhere: it cannot be a centre", f.about), about);
  }
  out = Moves(*std::move(read));
  return true;
}

// What stands behind a row's segment.
bool Reader::moving(Cursor& c, const Selected& to, Time from, std::optional<Time> until) {
  c.space();
  const char* start = c.at;
  if (to.velocity) return c.fail_here(Code::type, "a motion has no velocity");
  if (c.peek() == '=')
    return c.fail_here(Code::type, "a motion cannot be computed", "procedures compute positions, rotations and scales");
  Event e;
  e.time = from;
  Moves value;
  if (!values(c).motion(value)) return false;
  const std::string_view about = c.since(start);
  const bool rest = value->factors.empty();
  e.value = std::move(value);
  if (!way(c, to, e) || !finish(c)) return false;
  const Document now(std::make_shared<const Scene>(s));
  if (until && *until <= from)
    return c.fail(Code::range, "a motion takes time: its segment ends where it begins", about);
  for (const Target& t : to.targets) {
    if (t.layer)
      return c.fail(Code::type, "a motion is no layer's: it is added to what the tracks say anyway", to.text);
    const Slot* slot = s.objects[t.object.index].find(t.function);
    if (!slot) continue;
    const Event *busy = nullptr, *before = nullptr;
    std::optional<Time> end;
    slot->track->events.each([&](const Event& other) {
      if (other.time < from) before = moves(other) ? &other : nullptr;
      if (other.time >= from && before && !end) end = other.time;
      if (until && other.time > from && other.time < *until && moves(other) && !busy) busy = &other;
    });
    // Up to the next event: where it stood open, the new one ends it.
    if (before && end && *end > from) busy = before;
    if (busy)
      return c.fail(Code::range,
                    fmt::format("'{}' is under way from {} with {}", now.name(t), format_time(busy->time, now),
                                to_string(*std::get<Moves>(busy->value)).substr(0, 80)),
                    about, "motions of one object follow one another; those at the same time make one string");
  }
  if (!until && !rest)
    note(Severity::notice, "this motion has no end yet: it goes on to the next row", about, "a segment, as in 1f..24f");
  // An ease-in is of the arrival: it belongs to the event at the end.
  const Time ease_in = until ? e.detail->ease_in : Time{};
  if (ease_in != Time{}) e.detail.edit().ease_in = {};
  for (const Target& t : to.targets) {
    Events& events = edit_tracks(s, t)[0]->events;
    if (until) {
      for (const Event& inside : events.between(from, *until))
        if (inside.time > from && inside.time < *until) events.erase(inside.time, inside.time);
      Event end{*until, Moves(), {}, Twerper::unset, false, false};
      if (const Event* there = events.find(*until)) end = *there;
      if (ease_in != end.detail->ease_in) end.detail.edit().ease_in = ease_in;
      events.put(std::move(end));
    }
    Event begin = e;
    if (const Event* there = events.find(from); until && there && there->detail->ease_in != Time{})
      begin.detail.edit().ease_in = there->detail->ease_in;
    events.put(std::move(begin));
  }
  return true;
}

}  // namespace betwixt

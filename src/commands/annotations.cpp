// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Annotations: one word draws what points at a thing. They write plain objects below the thing, and plain events.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/command.h"
#include "commands/furnishing.h"
#include "commands/furniture_rows.h"
#include "commands/measuring.h"
#include "language/values.h"
#include "scene/code_languages.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

// An annotation of one object while it is written.
struct Annotation {
  Command& k;
  const Object& object;
  Vec3 low, high;  // in the object's own space
  Time from, length;
  std::string lines;

  std::string name(std::string_view part) const { return fmt::format("{}/{}", object.name, part); }
  bool exists(std::string_view part) const { return static_cast<bool>(k.scene.names.find(name(part))); }
  Vec3 middle() const { return 0.5 * (low + high); }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
  std::string accent() const { return theme_color(k.scene, &Theme::accent); }
  std::string line_color() const { return palette(k.scene, 1); }
  // A sheet of the accent is faint on a bright background, so it is less transparent there.
  const char* sheet() const { return theme_of(k.scene).paper.g > 0.5 ? "0.4" : "0.7"; }
  // A margin that suits the size of the object.
  double margin() const { return std::clamp(0.25 * std::min(width(), height()), 0.08, 0.25); }
  template <class... A>
  void line(fmt::format_string<A...> format, A&&... arguments) {
    lines += fmt::format(format, std::forward<A>(arguments)...) + "\n";
  }
  void at(const std::string& what) {
    line("at {} {} for {}", write_time(from, k.scene.rate), what, write_seconds(length));
  }
};

std::string xyz(Vec3 v) { return fmt::format("({} {} {})", write_number(v.x), write_number(v.y), write_number(v.z)); }

// ---- What each word draws, and how it comes and goes

struct AnnotationRow {
  std::string_view part;  // the name below the object
  void (*make)(Annotation&, std::string_view part);
  std::string_view come, go;  // the words of an entrance and an exit
};

void make_highlight(Annotation& a, std::string_view part) {
  const double m = a.margin();
  a.line("create {} rectangle size=({} {}) corner={} color={} transparency={} position={}", a.name(part),
         write_number(a.width() + 2 * m), write_number(a.height() + 2 * m), write_number(m), a.accent(), a.sheet(),
         xyz({a.middle().x, a.middle().y, a.low.z - 0.015}));
}
void make_underline(Annotation& a, std::string_view part) {
  a.line("create {} line to=({} 0 0) width={} color={} position={}", a.name(part), write_number(a.width()),
         write_number(0.35 * a.margin()), a.line_color(), xyz({a.low.x, a.low.y - 0.8 * a.margin(), a.high.z + 0.01}));
}
void make_circle(Annotation& a, std::string_view part) {
  const double m = 1.6 * a.margin(), w = a.width() + 2 * m, h = a.height() + 2 * m;
  a.line("create {} rectangle size=({} {}) corner={} fill=off stroke={} stroke-width={} position={}", a.name(part),
         write_number(w), write_number(h), write_number(0.5 * std::min(w, h)), a.line_color(),
         write_number(0.35 * a.margin()), xyz({a.middle().x, a.middle().y, a.high.z + 0.01}));
}
void make_cross(Annotation& a, std::string_view part) {
  a.line("create {} line to=({} {} 0) width={} color=#ff5c5c position={}", a.name(part), write_number(a.width()),
         write_number(a.height()), write_number(0.4 * a.margin()), xyz({a.low.x, a.low.y, a.high.z + 0.01}));
}
void make_spotlight(Annotation& a, std::string_view part) {
  // A dark sheet with a hole, in front of everything else.
  const double radius = 0.5 * std::hypot(a.width(), a.height()) + a.margin(), far = 200;
  std::string hole;
  for (int i = 0; i <= 64; ++i) {
    const double angle = 2 * pi * (i % 64) / 64;
    hole += fmt::format("{}({:.4g} {:.4g})", i ? " " : "", radius * std::cos(angle), radius * std::sin(angle));
  }
  a.line(
      "create {3} polygon points=((-{0} -{0}) ({0} -{0}) ({0} {0}) (-{0} {0})) holes=({1}) color=black "
      "transparency=0.35 material=glow position={2}",
      far, hole, xyz({a.middle().x, a.middle().y, a.high.z + 0.5}), a.name(part));
}

constexpr AnnotationRow annotation_rows[] = {{"highlight", make_highlight, "fade-in", "fade-out"},
                                             {"underline", make_underline, "draw", "erase"},
                                             {"circle", make_circle, "draw", "erase"},
                                             {"cross", make_cross, "draw", "erase"},
                                             {"spotlight", make_spotlight, "fade-in", "fade-out"}};

// The bounds of what the object and those below it draw, in the object's own space.
bool measure(Annotation& a, ObjectId id, std::string_view about) {
  // Other marks are no part of the thing.
  std::vector<ObjectId> all{id};
  for (const AnnotationRow& row : annotation_rows)
    if (const ObjectId mark = a.k.scene.names.find(a.name(row.part))) all.push_back(mark);
  const Measured m = measured(a.k.scene, all, a.from)[0];
  const auto inward = inverse(m.world);
  if (!m.any || !inward)
    return a.k.cursor.fail(ErrorCode::range, fmt::format("'{}' draws nothing at this time", a.object.name), about);
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = transform_point(
        *inward, {(corner & 1 ? m.high : m.low).x, (corner & 2 ? m.high : m.low).y, (corner & 4 ? m.high : m.low).z});
    for (int i = 0; i < 3; ++i) {
      a.low[i] = corner ? std::min(a.low[i], p[i]) : p[i];
      a.high[i] = corner ? std::max(a.high[i], p[i]) : p[i];
    }
  }
  return true;
}

// ---- The mark of lines of code

// Warns of lines that the code does not have at this time.
void say_missing_lines(const Annotation& a, double last, std::string_view about) {
  const Value v = value_said(a.k.scene, a.object, fn::text, a.from);
  const auto* text = std::get_if<Text>(&v);
  if (const double lines = text ? code_extent(**text).lines : last; last > lines)
    a.k.script.note(Severity::warning, fmt::format("the code has {:g} lines at this time", lines), about);
}

// Lets the mark appear, glide to other lines, or go.
void mark_lines(Annotation& a, std::optional<std::pair<double, double>> to) {
  const FunctionId function = *find_built_in(Kind::code, "lines");
  const Value said = value_said(a.k.scene, a.object, function, a.from);
  const Vec3 now = std::holds_alternative<Vec3>(said) ? std::get<Vec3>(said) : Vec3{};
  const std::string lines = a.object.name + ".lines", mark = a.name("mark");
  const auto at = [&](Time t, const std::string& what) { a.line("at {} {}", write_time(t, a.k.scene.rate), what); };
  const auto pair = [](double x, double y) { return fmt::format("({} {})", write_number(x), write_number(y)); };
  const Time end = a.from + a.length;
  if (now.x > 0 && to) {
    at(a.from, lines + " " + pair(now.x, now.y) + " ease-in-out");
    at(end, lines + " " + pair(to->first, to->second) + " hold");
  } else if (to) {
    const Slot* slot = a.object.find(function);
    if (a.from > Time{} && (!slot || slot->track->events.empty())) at(Time{}, lines + " (0 0) hold");
    at(a.from, lines + " " + pair(to->first, to->second) + " hold");
    at(a.from, mark + ".transparency 1 linear");
    at(end, mark + ".transparency 0 hold");
  } else if (now.x > 0) {
    at(a.from, mark + ".transparency 0 linear");
    at(end, mark + ".transparency 1 hold");
    at(end, lines + " (0 0) hold");
  }
}

// Reads `lines 3`, or `lines 3..5`.
bool some_lines(Command& k, std::pair<double, double>& out) {
  Cursor& c = k.cursor;
  c.space();
  const char* const start = c.at;
  if (!c.number(out.first)) return false;
  out.second = out.first;
  if (c.accept('.') && (!c.accept('.') || !c.number(out.second)))
    return c.fail(ErrorCode::syntax, "lines are a number, or two with dots between", c.since(start),
                  "as in lines 3..5");
  if (out.first < 1 || out.second < out.first || out.first != std::floor(out.first))
    return c.fail(ErrorCode::range, "lines are counted from 1, and the first comes first", c.since(start),
                  "as in highlight c lines 3..5");
  return true;
}

template <std::size_t row>
bool annotate(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const AnnotationRow& how = annotation_rows[row];
  std::string_view word;
  std::vector<ObjectId> found;
  if (!objects(k, word, found)) return false;
  std::optional<std::pair<double, double>> lines;
  const bool off = c.accept_word("off");
  if (row == 0 && !off && c.accept_word("lines") && !some_lines(k, lines.emplace())) return false;
  Time length = from_seconds(0.5);
  if (!lasting(k, length, word)) return false;
  std::string all;
  for (const ObjectId id : found) {
    const Object& o = s.objects[id.index];
    Annotation a{k, o, {}, {}, time.value_or(Time{}), length, {}};
    const bool code = o.kind == Kind::code;
    if (lines && !code)
      return c.fail(ErrorCode::type, fmt::format("'{}' is {}; only code has lines", o.name, a_kind(o.kind)), word);
    if (lines || (off && row == 0 && code && !a.exists(how.part))) {
      if (lines) say_missing_lines(a, lines->second, word);
      mark_lines(a, lines);
    } else if (off) {
      if (!a.exists(how.part))
        return c.fail(ErrorCode::name, fmt::format("'{}' has no {} here", o.name, how.part), word,
                      "write this line below the line that makes it");
      a.at(fmt::format("{} {}", how.go, a.name(how.part)));
    } else {
      if (!a.exists(how.part)) {
        if (!measure(a, id, word)) return false;
        how.make(a, how.part);
      }
      a.at(fmt::format("{} {}", how.come, a.name(how.part)));
    }
    all += a.lines;
  }
  return all_or_none(k, all, word);
}

constexpr unsigned in_time = Verb::timed;
constexpr Verb annotations_rows[] = {
    {"highlight", "at TIME highlight OBJECTS [lines N | lines N..M | off] [for L]",
     "Puts a bright sheet behind an object, or marks lines of code; `off` takes it away.",
     "create title text text=\"The end\"\nat 12f highlight title\nat 48f highlight title off", in_time, annotate<0>,
     "OBJECT; lines off for"},
    {"underline", "at TIME underline OBJECTS [off] [for L]", "Draws a line under an object; `off` takes it away.",
     "create title text text=\"The end\"\nat 12f underline title", in_time, annotate<1>, "OBJECT; off for"},
    {"circle-around", "at TIME circle-around OBJECTS [off] [for L]",
     "Draws a line around an object; `off` takes it away.", "at 12f circle-around ball for 12f", in_time, annotate<2>,
     "OBJECT; off for"},
    {"cross-out", "at TIME cross-out OBJECTS [off] [for L]", "Strikes an object out; `off` takes the line away.",
     "create title text text=\"The end\"\nat 12f cross-out title", in_time, annotate<3>, "OBJECT; off for"},
    {"spotlight", "at TIME spotlight OBJECTS [off] [for L]",
     "Darkens everything but an object; `off` takes the dark away.", "at 12f spotlight ball", in_time, annotate<4>,
     "OBJECT; off for"},
};

}  // namespace

std::span<const Verb> annotations_verbs() { return annotations_rows; }

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Entrances and exits: one word writes the plain events that bring an object on, or take it off.
#include <fmt/format.h>

#include "base/utf8.h"
#include "commands/command.h"
#include "commands/furnishing.h"
#include "commands/measuring.h"
#include "language/values.h"
#include "scene/document.h"
#include "scene/formula_parts.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

// What writes the events of one command.
struct Stage {
  Command& k;
  Time from, until;
  std::string lines;

  const Scene& scene() const { return k.scene; }
  std::string at(Time t) const { return "at " + write_time(t, k.scene.rate) + " "; }
  // Returns the value that the object has at the beginning; with `counts`, the last one that counts.
  template <class T>
  T value(const Object& o, FunctionId f, bool (*counts)(const Value&) = nullptr) const {
    const Value said = value_said(scene(), o, f, from, counts);
    const T* typed = std::get_if<T>(&said);
    return typed ? *typed : std::get<T>(spec_of(scene(), f).rest);
  }
  void move(const std::string& target, const std::string& begin, const std::string& end, const char* way) {
    lines += at(from) + target + " " + begin + " " + way + "\n" + at(until) + target + " " + end + " hold\n";
  }
  // Shows the object from the beginning of the entrance on, if it was not shown before.
  void appear(const Object& o) {
    const Slot* slot = o.find(fn::display);
    const bool before = slot && has_events_before(*slot, from);
    if (!before && from > Time{}) lines += at(Time{}) + "hide " + o.name + "\n";
    lines += at(from) + "show " + o.name + "\n";
  }
  void vanish(const Object& o) { lines += at(until) + "hide " + o.name + "\n"; }

 private:
  static bool has_events_before(const Slot& slot, Time t) {
    bool any = false;
    slot.track->events.each([&](const Event& e) { any = any || e.time < t; });
    return any;
  }
};

bool has_function(const Object& o, std::string_view name) { return find_built_in(o.kind, name).has_value(); }

// Returns the letters of a text or a formula that can be seen one by one; 0 if code or LaTeX makes them.
std::size_t letters_of(const Stage& s, const Object& o) {
  if (!has_letters(o.kind)) return 0;
  const auto tex = find_built_in(o.kind, "tex");
  if (tex && o.find(*tex)) {
    const auto formula = s.scene().formulas->find(*s.value<Text>(o, *tex));
    if (formula != s.scene().formulas->end()) return formula->second->letters.size();
  }
  const Slot* slot = o.find(fn::text);
  if (!slot || (slot->set && std::holds_alternative<Procedure>(*slot->set))) return 0;
  const Text text = s.value<Text>(o, fn::text);
  std::size_t count = 0;
  for (const char c : *text) count += begins_character(c) ? 1 : 0;
  return count;
}

bool can_be_seen(const Value& transparency) {
  const auto* v = std::get_if<double>(&transparency);
  return v && *v < 1;
}
bool has_a_size(const Value& scale) {
  const auto* v = std::get_if<Vec3>(&scale);
  return v && length(*v) > 0;
}

void fade(Stage& s, const Object& o, bool in) {
  if (!drawable(o.kind)) return;
  const std::string seen = write_number(s.value<double>(o, fn::transparency, can_be_seen));
  s.move(o.name + ".transparency", in ? "1" : seen, in ? seen : "1", "linear");
}

// Returns whether the letters are typed with those of a formula or of a block of code.
bool is_part_of_letters(const Stage& s, const Object& o) { return shown_part(o) && formula_of_part(s.scene(), o); }

// Draws one object in the way that suits its kind.
void draw(Stage& s, const Object& o, bool in) {
  if (!drawable(o.kind) || is_part_of_letters(s, o)) return;
  const bool line = row_of(o.kind).line;
  if (const std::size_t letters = letters_of(s, o); letters > 0) {
    const std::string all = std::to_string(letters);
    // At the end a longer text is not cut off.
    s.move(o.name + ".typed", in ? "0" : all, in ? fmt::format("{} cut {}", all, most_letters) : "0", "linear");
  } else if (line && has_function(o, "trim")) {
    s.move(o.name + ".trim", in ? "(0 0)" : "(0 1)", in ? "(0 1)" : "(1 1)", "ease-in-out");
  } else {
    fade(s, o, in);
  }
}

void grow(Stage& s, const Object& o, bool in) {
  const std::string full = write_vector(s.value<Vec3>(o, fn::scale, has_a_size));
  s.move(o.name + ".scale", in ? "(0 0 0)" : full, in ? full : "(0 0 0)", in ? "ease-out" : "ease-in");
}
void flip(Stage& s, const Object& o, bool in) {
  const Angles a = s.value<Angles>(o, fn::rotation);
  const double there = a.xyz.y;
  s.move(o.name + ".rotation.y", write_angle(in ? there - pi / 2 : there), write_angle(in ? there : there + pi / 2),
         in ? "ease-out" : "ease-in");
}
void wipe(Stage& s, const Object& o, bool in) {
  const std::string full = write_number(s.value<Vec3>(o, fn::scale).x);
  s.move(o.name + ".scale.x", in ? "0" : full, in ? full : "0", "ease-in-out");
}

// Which of an entrance's objects get events: only the one that is named, or all below it too.
template <void (*one)(Stage&, const Object&, bool), bool in, bool below>
bool entrance(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> found;
  if (!objects(k, word, found)) return false;
  Time length = from_seconds(1);
  if (!lasting(k, length, word)) return false;
  const Time from = time.value_or(Time{});
  Stage stage{k, from, from + length, {}};
  for (const ObjectId id : found) {
    const Object& o = s.objects[id.index];
    if (!placed(o.kind) || o.kind == Kind::light || o.kind == Kind::camera || o.kind == Kind::sound)
      return c.fail(ErrorCode::type, fmt::format("'{}' is {}, which has no picture", o.name, a_kind(o.kind)), word);
    std::vector<ObjectId> all{id};
    for (const ObjectId part : script.below(s, o.name, false)) all.push_back(part);
    for (const ObjectId part : all) {
      const Object& p = s.objects[part.index];
      const bool computed = p.find(fn::display) && p.find(fn::display)->set &&
                            std::holds_alternative<Procedure>(*p.find(fn::display)->set);
      if (drawable(p.kind) && !computed && in) stage.appear(p);
      if (below || part == id) one(stage, p, in);
      if (drawable(p.kind) && !computed && !in) stage.vanish(p);
    }
  }
  return all_or_none(k, stage.lines, word);
}

bool morph(Command& k) {
  auto& [s, c, time, layer, script] = k;
  ObjectId a, b;
  c.space();
  const std::string_view first = c.peek_word();
  if (!values(k).object(a)) return false;
  if (!c.accept_word("into"))
    return c.fail_here(ErrorCode::syntax, "'into' is missing here", "as in at 24f morph square into disc");
  c.space();
  const std::string_view second = c.peek_word();
  if (!values(k).object(b)) return false;
  Time length = from_seconds(1);
  if (!lasting(k, length, first)) return false;
  const Object &from = s.objects[a.index], &to = s.objects[b.index];
  for (const auto& [o, word] : {std::pair{&from, first}, {&to, second}})
    if (!drawable(o->kind))
      return c.fail(ErrorCode::type, fmt::format("'{}' is {}, which has no shape", o->name, a_kind(o->kind)), word);
  if (a == b) return c.fail(ErrorCode::name, "an object cannot become itself", second);
  const Time start = time.value_or(Time{});
  Stage stage{k, start, start + length, {}};
  stage.move(from.name + ".geometry", fmt::format("shape({})", from.name), fmt::format("shape({})", to.name),
             "ease-in-out");
  const auto color = [](const Color& v) {
    return fmt::format("rgb({} {} {})", write_number(v.r), write_number(v.g), write_number(v.b));
  };
  const Color before = stage.value<Color>(from, fn::color), after = stage.value<Color>(to, fn::color);
  if (before != after) stage.move(from.name + ".color", color(before), color(after), "ease-in-out");
  // B may be below something else, and code may tell its place, which may change until the end.
  const Measured first_place = measured(s, {a}, start)[0], last_place = measured(s, {b}, start + length)[0];
  const auto inward = inverse(first_place.to_world);
  const Vec3 here = first_place.position, way = translation_of(last_place.world) - translation_of(first_place.world);
  const Vec3 there = inward ? here + transform_vector(*inward, way) : here;
  if (here != there) stage.move(from.name + ".position", write_vector(here), write_vector(there), "ease-in-out");
  if (start > Time{}) stage.lines += stage.at(Time{}) + "hide " + to.name + "\n";
  stage.lines += stage.at(stage.until) + "hide " + from.name + "\n" + stage.at(stage.until) + "show " + to.name + "\n";
  if (start == Time{}) stage.lines += stage.at(Time{}) + "hide " + to.name + "\n";
  return all_or_none(k, stage.lines, first);
}

constexpr unsigned how = Verb::timed;
constexpr Verb entrances_rows[] = {
    {"write", "at TIME write OBJECTS [for L]",
     "Writes a text letter by letter, and draws lines; nothing is there before.",
     "create title text text=\"Hello\"\nat 12f write title for 2s", how, entrance<draw, true, true>, "OBJECT; for"},
    {"draw", "at TIME draw OBJECTS [for L]",
     "Draws lines from their beginning, with all below the object; fades in what has no line.",
     "create way line to=(3 0)\nat 12f draw way", how, entrance<draw, true, true>, "OBJECT; for"},
    {"erase", "at TIME erase OBJECTS [for L]", "Takes away letters and lines as `write` and `draw` bring them.",
     "create way line to=(3 0)\nat 48f erase way", how, entrance<draw, false, true>, "OBJECT; for"},
    {"grow", "at TIME grow OBJECTS [for L]", "Lets an object grow from nothing.", "at 12f grow ball for 12f", how,
     entrance<grow, true, false>, "OBJECT; for"},
    {"shrink", "at TIME shrink OBJECTS [for L]", "Lets an object shrink to nothing.", "at 48f shrink ball", how,
     entrance<grow, false, false>, "OBJECT; for"},
    {"fade-in", "at TIME fade-in OBJECTS [for L]", "Fades an object in, with all below it.", "at 12f fade-in ball", how,
     entrance<fade, true, true>, "OBJECT; for"},
    {"fade-out", "at TIME fade-out OBJECTS [for L]", "Fades an object out, with all below it.", "at 48f fade-out ball",
     how, entrance<fade, false, true>, "OBJECT; for"},
    {"flip", "at TIME flip OBJECTS [for L]", "Turns an object in about its y axis, like a card.", "at 12f flip ball",
     how, entrance<flip, true, false>, "OBJECT; for"},
    {"wipe", "at TIME wipe OBJECTS [for L]", "Opens an object along its x axis.", "at 12f wipe ball", how,
     entrance<wipe, true, false>, "OBJECT; for"},
    {"morph", "at TIME morph A into B [for L]", "Turns A into B: its shape, colour and place. Then B replaces it.",
     "create a rectangle\ncreate b circle position=(3 0)\nat 12f morph a into b", how, morph,
     "OBJECT; into; OBJECT; for"},
};

}  // namespace

std::span<const Verb> entrances_verbs() { return entrances_rows; }

}  // namespace betwixt

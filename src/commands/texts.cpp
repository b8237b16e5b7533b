// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// split: divides a text into letters, words or lines. Also reports fonts without letters of the chosen look.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/command.h"
#include "exchange/fonts.h"
#include "exchange/typefaces.h"
#include "scene/formula_parts.h"
#include "scene/own_font.h"
#include "scene/text_functions.h"

namespace betwixt {
namespace {

constexpr std::array<std::string_view, 3> part_names{"letters", "words", "lines"};

// The settings that place a text's parts. They must be constant through the film, or the parts would have no fixed
// places.
struct Setting {
  std::string text;
  FontName font = "";
  Letters letters;
  double size = 1;
};
constexpr std::array<std::string_view, 10> settled{"text",  "font",  "size", "align",  "weight",
                                                   "slant", "typed", "wrap", "anchor", "tex"};

bool is_settled(const Object& o, FunctionId f) {
  return std::all_of(o.slots.begin(), o.slots.end(), [&](const Slot& slot) {
    const bool plain = !slot.layer && slot.track->events.empty() && slot.components.empty() && slot.filters.empty() &&
                       slot.velocity.track->events.empty() && slot.velocity.components.empty();
    return slot.function != f || (plain && !(slot.set && std::holds_alternative<Procedure>(*slot.set)));
  });
}

Value settled_value(const Scene& s, const Object& o, FunctionId f) {
  const Slot* slot = o.find(f);
  return slot && slot->set ? *slot->set : spec_of(s, f).rest;
}

bool setting_of(Command& k, const Object& o, std::string_view about, Setting& out) {
  if (o.kind != Kind::text)
    return k.cursor.fail(ErrorCode::type, fmt::format("'{}' is {}; only texts can be split", o.name, a_kind(o.kind)),
                         about);
  Shape shape;
  for (const std::string_view name : settled) {
    const FunctionId f = *find_built_in(Kind::text, name);
    if (!is_settled(o, f))
      return k.cursor.fail(
          ErrorCode::type,
          fmt::format("'{}.{}' changes in the film; only a text that does not change can be split", o.name, name),
          about, name == "typed" ? "use stagger to show its letters one by one" : "");
    spec_of(k.scene, f).shape(shape, settled_value(k.scene, o, f), k.scene);
  }
  if (shape.formula)
    return k.cursor.fail(ErrorCode::type, fmt::format("'{}' is a formula; formulas cannot be split", o.name), about,
                         "mark parts with double braces: {{a}}^2; or use 'typed' to show its signs one by one");
  out = {*shape.text, font_of(shape), letters_of(shape), shape.size.y};
  return true;
}

// Makes an object with the look of the whole text; its own place becomes the origin of its position.
Object part_object(const Scene& s, const Object& whole, ObjectId id, const TextPart& part, double size) {
  Object o;
  o.kind = Kind::text;
  for (const Slot& slot : whole.slots)
    if (slot.function == fn::display || !spec_of(s, slot.function).place) o.slots.push_back(slot);
  for (const char* of_the_whole : {"align", "typed", "wrap", "anchor"})
    std::erase_if(o.slots, [f = *find_built_in(Kind::text, of_the_whole)](const Slot& x) { return x.function == f; });
  o.slot(fn::text).set = Text(part.text);
  o.slot(fn::attach_position).set = size * part.at;
  o.slot(fn::attachment).set = Attachment{AttachmentKind::couple, id, false};
  return o;
}

bool split_one(Command& k, ObjectId id, SplitInto into, std::string_view about, std::size_t& made) {
  auto& [s, c, time, layer, script] = k;
  const Object whole = s.objects[id.index];
  Setting setting;
  if (!setting_of(k, whole, about, setting)) return false;
  const auto parts = text_parts(setting.text, setting.font, setting.letters, into);
  if (parts.empty())
    return c.fail(ErrorCode::range, fmt::format("'{}' has no letters that could be split", whole.name), about);
  if (s.objects.size() + parts.size() > most_objects)
    return c.fail(ErrorCode::range, fmt::format("a film can have at most {} objects", most_objects), about);
  const auto name = [&](std::size_t i) { return fmt::format("{}/{}", whole.name, i + 1); };
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!free_name(k, name(i), about)) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Object part = part_object(s, whole, id, parts[i], setting.size);
    part.name = name(i);
    add_object(s, std::move(part));
  }
  Object& stays = s.objects.edit(id.index);
  stays.leads = true;
  std::erase_if(stays.slots, [](const Slot& slot) { return slot.function == fn::display; });
  stays.slot(fn::display).set = false;
  made += parts.size();
  return true;
}

bool split(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  std::vector<ObjectId> texts;
  if (!objects(k, word, texts)) return false;
  if (!c.accept_word("into"))
    return c.fail_here(ErrorCode::syntax, "'into' is missing here", "as in split title into letters, words or lines");
  const std::string_view into = c.next_word();
  const auto at = std::find(part_names.begin(), part_names.end(), into);
  if (at == part_names.end())
    return no_choice(c, into, "a text can be split into letters, words or lines",
                     did_you_mean(into, {part_names.begin(), part_names.end()}));
  if (!finish(c)) return false;
  Rollback all(s);
  std::size_t made = 0;
  for (const ObjectId id : texts)
    if (!split_one(k, id, static_cast<SplitInto>(at - part_names.begin()), word, made)) return false;
  all.keep();
  script.touched = made;
  return true;
}

constexpr Verb texts_rows[] = {
    {"split", "split TITLE into letters|words|lines",
     "Splits a text into objects TITLE/1, TITLE/2 … at the same places; the text is their parent and is hidden.",
     "create title text text=\"The end\"\nsplit title into letters\nat 1f title/*.position (0 5 0)\n"
     "at 24f title/*.position (0 0 0)\nstagger title/*.position by 2f",
     Verb::makes_parts, split, "OBJECT; into; letters words lines"},
};

}  // namespace

void say_missing_style(Command& k, const Object& o, FunctionId f, const Value& v, std::string_view about) {
  const std::string_view name = spec_of(k.scene, f).name;
  const Text* const text = f == fn::text ? std::get_if<Text>(&v) : nullptr;
  if (o.kind != Kind::text || (name != "font" && name != "weight" && name != "slant" && !text)) return;
  const auto value = [&](std::string_view of) {
    const FunctionId at = *find_built_in(Kind::text, of);
    return at == f ? v : settled_value(k.scene, o, at);
  };
  const Value font = value("font");
  const Typeface face{std::holds_alternative<Text>(font) ? *std::get<Text>(font) : "", weight_of(value("weight")),
                      is_italic(value("slant"))};
  if (text && !names_font_file(face.family))
    if (const std::string lacks = missing_letter(face, **text); !lacks.empty())
      k.script.note(Severity::warning,
                    fmt::format("the font \"{}\" has no letter '{}'; a box is shown",
                                face.family.empty() ? "DejaVu Sans" : face.family, lacks),
                    about, "font= names another one; fc-list shows those of this machine");
  if (text || (face.weight == Weight::regular && !face.italic)) return;  // the default look
  if (const Status known = find_style(face); !known)
    k.script.note(Severity::warning, known.error().message, about, known.error().hint);
}

bool make_parts(Command& k, ObjectId id, FunctionId f, const Value& v, std::string_view about) {
  Scene& s = k.scene;
  const auto* const tex = std::get_if<Text>(&v);
  if (spec_of(s, f).name != "tex" || !tex || (*tex)->find("{{") == std::string::npos) return true;
  const auto formula = s.formulas->find(**tex);
  if (formula == s.formulas->end() || shown_part(s.objects[id.index])) return true;
  const std::string name = s.objects[id.index].name;
  std::vector<std::string> wanted = parts_of_formula(*formula->second);
  std::size_t next = 1;
  for (; const ObjectId other = s.names.find(fmt::format("{}/{}", name, next)); ++next)
    if (const std::string* const key = shown_part(s.objects[other.index])) std::erase(wanted, *key);
  if (s.objects.size() + wanted.size() > most_objects)
    return k.cursor.fail(ErrorCode::range, fmt::format("a film can have at most {} objects", most_objects), about);
  for (const std::string& key : wanted) {
    Object part;
    part.kind = Kind::text;
    part.name = fmt::format("{}/{}", name, next++);
    if (!free_name(k, part.name, about)) return false;
    part.slot(part_function()).set = Text(key);
    add_child(s, std::move(part), id);
  }
  return true;
}

std::span<const Verb> texts_verbs() { return texts_rows; }

}  // namespace betwixt

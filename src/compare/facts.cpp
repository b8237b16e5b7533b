// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "language/values.h"
#include "language/written_scenes.h"
#include "scene/document.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

// Calls f for each command of a canonical text with the rows below it.
template <class F>
void each_statement(std::string_view text, F&& f) {
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at < end;) {
    const char* const from = at;
    do at = logical_line({at, end}).next(end);
    while (at < end && indented({at, end}));
    std::string_view statement = between(from, at);
    if (statement.ends_with('\n')) statement.remove_suffix(1);
    if (!statement.empty()) f(statement);
  }
}

template <std::size_t n>
bool is_one_of(std::string_view word, const std::array<std::string_view, n>& words) {
  return std::ranges::find(words, word) != words.end();
}

constexpr std::array<std::string_view, 6> definitions{"procedure", "let", "define", "alias", "dial", "section"};
// What other facts say: objects and their values, events, cuts and notes, lists, environments.
constexpr std::array<std::string_view, 19> said_elsewhere{
    "create", "layer", "rename", "set",  "at",   "look", "clear",   "couple", "attach", "hang",
    "detach", "letgo", "make",   "edit", "kill", "halt", "animate", "cancel", "delete"};

class FactFinder {
 public:
  explicit FactFinder(const Document& d) : document_(d), s_(d.scene()), files_(s_) {}

  Facts all() {
    for (std::uint32_t i = 0; i < s_.objects.size(); ++i)
      if (!s_.objects[i].removed && !s_.objects[i].derived) object(i);
    for (const auto& [time, camera] : *s_.cuts) {
      const auto way = s_.cut_ways->find(time);
      facts_.said[{FactPart::camera, "", "", "", time}] =
          document_.name(camera) + (way == s_.cut_ways->end() ? "" : " " + write_cut_way(way->second, s_.rate));
    }
    for (const auto& [time, note] : *s_.notes)
      add({FactPart::note, "", "", "", time},
          write_text(note.text) + (note.color ? " color=" + write_color(*note.color) : ""));
    for (const auto& [time, pause] : *s_.pauses)
      add({FactPart::definition, "", "step " + write_time(time, s_.rate), "", {}}, write_pause(pause, s_.rate));
    for (const auto& [time, said] : *s_.descriptions)
      add({FactPart::definition, "", "describe " + write_time(time, s_.rate), "", {}},
          write_description(said, s_.rate));
    each_statement(write_lists(s_), [&](std::string_view statement) {
      std::string_view rest = statement;
      std::string_view word = take_piece(rest);
      if (word == "at") take_piece(rest), word = take_piece(rest);
      add({FactPart::list, "", std::string(take_piece(rest)), "", {}}, statement);
    });
    each_statement(write(document_), [&](std::string_view statement) { read(statement); });
    return std::move(facts_);
  }

 private:
  void add(FactKey key, std::string_view said) {
    std::string& there = facts_.said[std::move(key)];
    if (!there.empty()) there += '\n';
    there += said;
  }

  // Reads a command that no other fact stands for.
  void read(std::string_view statement) {
    std::string_view rest = statement;
    std::string_view word = take_piece(rest);
    std::string layer;
    if (word == "on") layer = take_piece(rest), word = take_piece(rest);
    if (word == "twerper" || word == "extend" || word == "filter") {
      const std::string_view target = take_piece(rest);
      const std::size_t dot = first_dot(target);
      const FactPart part = word == "filter" ? FactPart::filters : FactPart::manner;
      // Filters of a function and of its components are one list.
      std::string_view about = target.substr(dot + 1);
      if (part == FactPart::filters) about = about.substr(0, first_dot(about));
      add({part, std::string(target.substr(0, dot)), std::string(about), layer, {}}, statement);
    } else if (is_one_of(word, definitions)) {
      define(word, statement);
    } else if (statement.starts_with('#')) {
      add({FactPart::definition, "", std::string(statement), "", {}}, statement);
    } else if (layer.empty() && !is_one_of(word, said_elsewhere) && first_dot(word) == std::string_view::npos) {
      add({FactPart::setting, "", std::string(word), "", {}}, statement);
    }
  }
  void define(std::string_view word, std::string_view statement) {
    std::string_view rest = statement;
    take_piece(rest);
    std::string name(take_piece(rest));
    if (word == "define" && name == "kind") word = "kind", name = take_piece(rest);
    add({FactPart::definition, "", fmt::format("{} {}", word == "define" ? "function" : word, name), "", {}},
        statement);
  }

  void object(std::uint32_t i) {
    const Object& o = s_.objects[i];
    facts_.objects.push_back(o.name);
    const std::string* command = files_.command(i);
    facts_.said[{FactPart::object, o.name, "", "", {}}] = command ? *command : std::string(name_of(o.kind));
    if (o.environment)
      facts_.said[{FactPart::environment, o.name, "", "", {}}] = write_environment(o.name, *o.environment);
    for (const Slot& slot : o.slots) {
      Target t{{i}, slot.function};
      t.layer = slot.layer;
      if (slot.layer && !find_object(s_, slot.layer)) continue;
      if (slot.set) value(t, *slot.set);
      strand(slot, t);
      t.velocity = true;
      strand(slot.velocity, t);
    }
  }

  FactKey key(FactPart part, const Target& t, Time time = {}) const {
    const std::string& object = s_.objects[t.object.index].name;
    return {part, object, document_.name(t).substr(object.size() + 1), t.layer ? document_.name(t.layer) : "", time};
  }

  // A reference to an object that is gone is no content.
  bool refers_to_nothing(const Value& v) const {
    const auto* id = std::get_if<ObjectId>(&v);
    const auto* a = std::get_if<Attachment>(&v);
    return (id && *id && !find_object(s_, *id)) ||
           (a && a->kind >= AttachmentKind::hang && !find_object(s_, a->parent));
  }
  void value(const Target& t, const Value& v) {
    if (refers_to_nothing(v)) return;
    const auto name = [&](ObjectId o) { return find_object(s_, o) ? document_.name(o) : std::string(); };
    const auto* m = std::get_if<Moves>(&v);
    facts_.said[key(FactPart::value, t)] =
        write_value(m ? Value(Moves(about_what_is_there(s_, **m))) : v, spec_of(s_, t.function), -1, name);
  }

  void strand(const Strand& of, Target t) {
    track(*of.track, t);
    for (std::size_t k = 0; k < of.components.size(); ++k) {
      t.component = static_cast<int>(k);
      track(*of.components[k], t);
    }
  }
  void track(const Track& of, const Target& t) {
    if (of.events.empty()) return;
    FactKey k = key(FactPart::event, t);
    auto at = facts_.said.lower_bound(k);
    const auto put = [&](Time time, std::string said) {
      k.time = time;
      at = std::next(facts_.said.insert_or_assign(at, k, std::move(said)));
    };
    if (spec_of(s_, t.function).type != Type::motion || t.velocity)
      return of.events.each([&](const Event& e) { put(e.time, write_event(document_, t, e)); });
    // A motion's row has its end in it: "1f..97f T(1 0)".
    const std::string rows = write_rows(document_, t);
    std::string_view left = rows;
    while (!left.empty()) {
      const LogicalLine line = logical_line(left);
      std::string_view row = without_indent(between(left.data(), line.end));
      left.remove_prefix(static_cast<std::size_t>(line.next(left.data() + left.size()) - left.data()));
      const std::string_view time = row.substr(0, row.find(' '));
      const auto from = parse_time(time.substr(0, time.find("..")), document_);
      if (from) put(*from, std::string(row));
    }
  }

  const Document& document_;
  const Scene& s_;
  FilesObjects files_;
  Facts facts_;
};

// A motion's row begins with its segment.
bool has_segment(std::string_view said) { return said.substr(0, said.find(' ')).find("..") != std::string_view::npos; }

}  // namespace

std::string_view word_of(FactPart part) {
  constexpr std::array<std::string_view, 11> words{"setting", "definition", "object", "list",   "environment", "value",
                                                   "twerper", "event",      "filter", "camera", "note"};
  return words[static_cast<std::size_t>(part)];
}

std::string FactKey::name() const {
  std::string out = object;
  if (!about.empty()) out += (object.empty() ? "" : ".") + about;
  if (!layer.empty()) out += " on " + layer;
  return out;
}

Facts facts_of(const Document& d) { return FactFinder(d).all(); }

TrackEvents events_of(const std::map<FactKey, std::string>& said, FactKey track) {
  TrackEvents all;
  track.time = earliest_time;
  for (auto at = said.lower_bound(track); at != said.end() && at->first.track() == track.track(); ++at)
    all.emplace(at->first.time, at->second);
  return all;
}

std::vector<std::string> commands_for(const FactKey& k, const std::string& said, const Document& d) {
  const std::string on = k.layer.empty() ? "" : "on " + k.layer + " ", target = k.object + "." + k.about;
  const std::string at = k.time == earliest_time ? "" : "at " + write_time(k.time, d.rate()) + " ";
  std::vector<std::string> all;
  switch (k.part) {
    case FactPart::object:
      if (said == "environment") return {};
      return {said == "layer" ? fmt::format("layer {} add", k.object) : fmt::format("create {} {}", k.object, said)};
    case FactPart::value:
      if (k.about == "attachment") {
        const std::size_t space = std::min(said.find(' '), said.size());
        return {said.substr(0, space) + " " + k.object + said.substr(space)};
      }
      return {on + "set " + target + " " + said};
    case FactPart::event:
      if (has_segment(said))
        return {
            fmt::format("{}at {} {} {}", on, said.substr(0, said.find(' ')), target, said.substr(said.find(' ') + 1))};
      return {at + on + target + " " + said};
    case FactPart::camera:
      return {at + "look through " + said};
    case FactPart::note:
      each_statement(said, [&](std::string_view one) { all.push_back(at + "note " + std::string(one)); });
      return all;
    case FactPart::filters:
      all.push_back(on + "filter " + target + " none");
      [[fallthrough]];
    case FactPart::manner:
      if (k.part == FactPart::manner) all = {on + "twerper " + target + " none", on + "extend " + target + " hold"};
      [[fallthrough]];
    default:
      each_statement(said, [&](std::string_view one) {
        if (!one.starts_with('#')) all.emplace_back(one);
      });
      return all;
  }
}

std::vector<std::string> commands_without(const FactKey& k, const Document& d) {
  const std::string on = k.layer.empty() ? "" : "on " + k.layer + " ", target = k.object + "." + k.about;
  const std::string at = write_time(k.time, d.rate());
  switch (k.part) {
    case FactPart::object:
      return {"remove " + k.object};
    case FactPart::event:
      return {fmt::format("{}clear {} {}", on, target, at)};
    case FactPart::note:
      return {"clear notes " + at};
    case FactPart::filters:
      return {on + "filter " + target + " none"};
    case FactPart::manner:
      return {on + "twerper " + target + " none", on + "extend " + target + " hold"};
    default:
      return {};
  }
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Completion of the last word of a line.
#include "editor/completion.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands/command.h"
#include "commands/parts.h"
#include "commands/plugins.h"
#include "commands/verbs.h"
#include "editor/completion_names.h"
#include "editor/help.h"
#include "editor/said_line.h"
#include "editor/session_state.h"
#include "language/moments.h"
#include "scene/colors.h"
#include "scene/names.h"
#include "scene/own_kinds.h"
#include "syntax/tokens.h"
#include "track/filter.h"

namespace betwixt {
namespace {

// A line, split into its last word and the words before it, without `at TIME` and `on LAYER`.
struct Begun {
  Words words;
  std::string verb;  // may be empty
  std::string_view last;
  std::string key;  // of key=, if the last word is its value
  bool timed = false, layered = false;
  bool row = false, in_list = false;
  bool time_next() const { return (row && !in_list && words.empty()) || (!words.empty() && words.back() == "at"); }
  bool in_moment() const { return last.find(":\"") != std::string_view::npos; }  // in voice:"the sq
  std::size_t place() const { return words.empty() ? 0 : words.size() - 1; }     // index after the verb
};

void split(std::string_view words, char between, Words& all) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(between), words.size());
    all.emplace_back(words.substr(0, end));
    words.remove_prefix(std::min(words.size(), end + 1));
  }
}

// Splits a line into words. Brackets belong to the word before them.
Words whole_words(std::string_view text) {
  Words all;
  for (std::string_view word = take_piece(text); !word.empty(); word = take_piece(text)) all.emplace_back(word);
  return all;
}

// Returns the words that can follow a verb, or a word of the shell, at a place.
std::string_view words_after(std::string_view verb, std::size_t place) {
  if (const Verb* known = find_verb(verb); known && !known->words.empty()) return words_at(known->words, place);
  const Session::State::Word* word = Session::State::find_word(verb);
  return word ? words_at(word->words, place) : std::string_view();
}

// Completes functions after the first dot of a target, components after the second.
void parts_of_target(const Document& d, std::string_view last, bool asking, Words& all) {
  const Scene& s = d.scene();
  const std::size_t dot = first_dot(last);
  const std::string_view object = last.substr(0, dot);
  const std::size_t behind = last.find('.', dot + 1);
  for (const ObjectId id : select(s, object)) {
    const Kind kind = s.objects[id.index].kind;
    if (behind == std::string_view::npos) {
      for (const auto f : function_names(s, kind)) all.push_back(fmt::format("{}.{}", object, f));
      for (const char* query : {"world", "touching", "in-view", "loudness", "onsets", "by", "every", "count"})
        if (asking && find_query(kind, query)) all.push_back(fmt::format("{}.{}", object, query));
      continue;
    }
    const std::string_view name = last.substr(dot + 1, behind - dot - 1);
    const std::string whole(last.substr(0, behind));
    const auto f = find_function(s, kind, name);
    const Type type = f ? spec_of(s, *f).type : Type::vector;
    if (!f && !(asking && name == "world")) continue;
    const bool below = last.substr(behind + 1).find('.') != std::string_view::npos;  // after a component
    if (!below)
      for (int i = 0; i < component_count(type); ++i)
        all.push_back(fmt::format("{}.{}", whole, component_name(type, i)));
    if (f && row_of(type).rate)
      all.push_back(fmt::format("{}.velocity", below ? last.substr(0, last.rfind('.')) : std::string_view(whole)));
  }
}

// The words with which a value of the function can begin.
void value_words(const Document& d, const FunctionSpec& spec, Words& all) {
  const auto words = [&](std::string_view these) { split(these, ' ', all); };
  split(spec.words, '|', all);
  switch (spec.type) {
    case Type::color: {
      const auto named = color_names();
      all.insert(all.end(), named.begin(), named.end());
      let_names(d.scene(), true, all);
      return words("rgb hsv");
    }
    case Type::boolean:
      return words("on off");
    case Type::rotation:
    case Type::orientation:
      return words("euler axis quat matrix");
    case Type::shape:
      return words("shape none");
    case Type::attachment:
      return words("attach couple hang detach letgo");
    case Type::motion:
      return words("T R S");
    case Type::names:
      words("none");
      return objects_of(d.scene(), Kind::environment, all);
    case Type::aim:
      words("none");
      for (const std::string& name : d.names()) all.push_back(name);
      return;
    case Type::text:
      return;
    default:
      return let_names(d.scene(), false, all);
  }
}

// The twerpers that can follow an event's value.
void ways(const Scene& s, Type type, Words& all) {
  for (const TwerperRow& t : twerpers())
    if (const auto known = find_twerper(t.name); known && fits(*known, type)) all.emplace_back(t.name);
  own_words(s, Role::twerper, all);
  if (row_of(type).computed) own_words(s, Role::tween, all);
  split("ease-in= ease-out= cut", ' ', all);
  if (row_of(type).tangents) split("tangent= tangent-in= tangent-out= handle-in= handle-out=", ' ', all);
}

// The words after an event's target: a value, then its twerper.
void event_words(const Document& d, const std::string& target, bool value_due, Words& all) {
  const auto found = find_targets(target, d);
  if (!found || found->empty() || found->front().query()) return;
  const Target& t = found->front();
  FunctionSpec spec = spec_of(d.scene(), t.function);
  if (t.component >= 0) spec.type = component_type(spec.type);
  if (!value_due) return ways(d.scene(), spec.type, all);
  if (t.velocity) all.emplace_back("release");
  if (!t.velocity) value_words(d, spec, all);
  all.emplace_back("keep");
}

void object_names(const Document& d, Words& all) {
  for (const std::string& name : d.names()) all.push_back(name);
}

std::optional<Kind> kind_called(const Scene& s, std::string_view word) {
  const OwnKind* own = s.kinds->find(word);
  return own ? std::optional(s.objects[own->model().index].kind) : find_kind(word);
}

// The kind that a line names before its parameters.
std::optional<Kind> kind_before(const Scene& s, const Begun& b) {
  for (std::size_t i = 1; i < b.words.size(); ++i)
    if (has_word(words_after(b.verb, i - 1), "KIND")) return kind_called(s, b.words[i]);
  return std::nullopt;
}

const NamedProcedure* command_with_parameters(const Scene& s, std::string_view word) {
  const NamedProcedure* own = find_procedure(s, word);
  return own && own->role == Role::command && !own->parameters.empty() ? own : nullptr;
}

void behind_key(const Document& d, const Begun& b, Words& all) {
  if (const NamedProcedure* own = command_with_parameters(d.scene(), b.verb)) {
    const auto p = std::ranges::find(own->parameters, b.key, &CommandParameter::name);
    if (p == own->parameters.end()) return;
    if (p->type.starts_with("object")) return object_names(d, all);
    if (p->type == "color") return value_words(d, spec_of(d.scene(), fn::color), all);
    if (p->type == "boolean") split("on off", ' ', all);
    return;
  }
  if (!has_word(words_after(b.verb, b.place()), "PARAMETER")) return;
  if (const auto f = find_function(d.scene(), kind_before(d.scene(), b).value_or(Kind::sphere), b.key))
    value_words(d, spec_of(d.scene(), *f), all);
}

void parameters(const Document& d, const Begun& b, Words& all) {
  if (parameters_of_part(d.scene(), b.words.size() > 2 ? b.words[2] : "", all)) return;
  const auto kind = kind_before(d.scene(), b);
  if (!kind) return object_names(d, all);
  for (const auto name : function_names(d.scene(), *kind)) all.push_back(fmt::format("{}=", name));
}

void settings(const Begun& b, Words& all) {
  const FilterSpec* f = b.words.size() > 2 ? find_filter(b.words[2]) : nullptr;
  for (std::size_t i = 0; f && i < f->parameters.size(); ++i) all.push_back(fmt::format("{}=", f->parameters[i].name));
  if (f) all.emplace_back("off");
}

// The first words of a command or of a shell line.
void first_words(const Begun& b, bool in_shell, Words& all) {
  const unsigned wanted = (b.timed ? Verb::timed : 0u) | (b.layered && !b.timed ? Verb::layered : 0u);
  for (const std::string_view w : verb_words(wanted)) all.emplace_back(w);
  if (b.timed || b.layered || !in_shell) return;
  for (const HelpEntry& e : help_entries())
    if (e.group == HelpGroup::shell) all.emplace_back(e.word);
}

void words_of_help(Words& all) {
  for (const HelpEntry& e : help_entries())
    if (e.group != HelpGroup::verb || is_verb(e.word)) all.emplace_back(e.word);
}

// A place in a line, and the words that can be there.
struct Offer {
  const Document& d;
  const Begun& b;
  const LineAround& around;
  Words& all;
};
// What the words in capitals of Verb::words stand for.
struct ArgumentKind {
  std::string_view word;
  void (*offer)(const Offer&);
};
constexpr ArgumentKind argument_kinds[] = {
    {"NEW", [](const Offer&) {}},     // a name that does not exist yet
    {"NUMBER", [](const Offer&) {}},  // a number, a time or a text
    {"OBJECT", [](const Offer& o) { object_names(o.d, o.all); }},
    {"TARGET", [](const Offer& o) { object_names(o.d, o.all); }},
    {"QUERY", [](const Offer& o) { object_names(o.d, o.all); }},  // a target that can be read only
    {"CAMERA", [](const Offer& o) { objects_of(o.d.scene(), Kind::camera, o.all); }},
    {"LAYER", [](const Offer& o) { objects_of(o.d.scene(), Kind::layer, o.all); }},
    {"KIND",
     [](const Offer& o) {
       for (const KindRow& k : kinds()) o.all.emplace_back(k.name);
       for (const OwnKind& k : o.d.scene().kinds->all) o.all.push_back(k.name);
       for (std::string& name : plugin_kinds()) o.all.push_back(std::move(name));
       for (const std::string_view name : part_names(o.d.scene())) o.all.emplace_back(name);
     }},
    {"SECTION",
     [](const Offer& o) {
       for (const Section& s : o.d.sections()) o.all.push_back(s.name);
     }},
    {"PARAMETER", [](const Offer& o) { parameters(o.d, o.b, o.all); }},
    {"TYPE",
     [](const Offer& o) {
       for (const std::string_view w : type_words()) o.all.emplace_back(w);
     }},
    {"FILTER", [](const Offer& o) { filters(o.d.scene(), o.all); }},
    {"SETTING", [](const Offer& o) { settings(o.b, o.all); }},
    {"TWERPER", [](const Offer& o) { ways(o.d.scene(), Type::vector, o.all); }},
    {"COLOR", [](const Offer& o) { value_words(o.d, spec_of(o.d.scene(), fn::color), o.all); }},
    {"VALUE", [](const Offer& o) { event_words(o.d, o.b.words[1], true, o.all); }},
    {"WAY", [](const Offer& o) { event_words(o.d, o.b.words[1], false, o.all); }},
    {"FILE", [](const Offer& o) { files(o.around.folder, o.all); }},
    {"STYLE", [](const Offer& o) { o.all.insert(o.all.end(), o.around.styles.begin(), o.around.styles.end()); }},
    {"COLUMN", [](const Offer& o) { columns_of_tables(o.d.scene(), o.all); }},
    {"WORD", [](const Offer& o) { words_of_help(o.all); }},
};

// Adds the words that the verb's row has for a place. Returns false if it has none: then names of objects can be there.
bool by_row(const Offer& o) {
  std::string_view rest = words_after(o.b.verb, o.b.place());
  bool any = false;
  for (std::string_view word = take_piece(rest); !word.empty(); word = take_piece(rest), any = true) {
    const auto kind = std::ranges::find(argument_kinds, word, &ArgumentKind::word);
    if (kind != std::end(argument_kinds))
      kind->offer(o);
    else
      o.all.emplace_back(word);
  }
  return any;
}

void offered(const Document& d, const Begun& b, const LineAround& around, Words& all) {
  if (!b.key.empty()) return behind_key(d, b, all);
  if (b.in_list && b.words.empty()) {
    for (const HelpEntry& e : help_entries())
      if (e.group == HelpGroup::row) all.emplace_back(e.word);
    return;
  }
  if (b.row && !b.in_list && !b.words.empty()) return event_words(d, around.sheet, b.words.size() == 1, all);
  if (b.time_next()) return let_names(d.scene(), false, all);
  if (b.words.empty()) first_words(b, around.in_shell, all);
  const bool target = first_dot(b.verb) != std::string_view::npos;
  if (b.timed && target) return event_words(d, b.verb, b.words.size() == 1, all);
  if (const NamedProcedure* own = command_with_parameters(d.scene(), b.verb)) {
    for (const CommandParameter& p : own->parameters) all.push_back(p.name + "=");
    return object_names(d, all);
  }
  if (b.in_list || !by_row({d, b, around, all})) object_names(d, all);
}

// Removes `at TIME` and `on LAYER`.
void take_off(Begun& b) {
  while (b.words.size() >= 2) {
    const Verb* const verb = find_verb(b.words[0]);
    if (!verb || !(verb->flags & Verb::prefix)) return;
    (verb->flags & Verb::timed ? b.layered : b.timed) = true;
    b.words.erase(b.words.begin(), b.words.begin() + 2);
  }
}

Begun begun(std::string_view line, const LineAround& around) {
  Begun b;
  b.last = line.substr(begun_word(line));
  const std::string_view before = line.substr(0, line.size() - b.last.size());
  b.words = whole_words(before);
  if (before.ends_with('=') && !b.words.empty()) {
    b.key = b.words.back().substr(0, b.words.back().size() - 1);
    b.words.pop_back();
  }
  // At a shell a row need not be indented.
  b.row = around.sheet_open && !line.empty() && (indented(line) || (around.in_shell && starts_like_time(line[0])));
  b.in_list = b.row && around.list;
  if (!b.row) take_off(b);
  if (!b.words.empty()) b.verb = b.words[0];
  return b;
}

}  // namespace

std::size_t begun_word(std::string_view line) {
  const auto last = token_before(line, line.size());
  const bool begun =
      last && last->end() == line.size() &&
      (last->kind == TokenKind::word || last->kind == TokenKind::text || last->kind == TokenKind::comment);
  if (!begun) return line.size();
  if (last->kind == TokenKind::text && last->at > 0 && line[last->at - 1] == ':') {  // voice:"the sq is one word
    const std::size_t name = token_before(line, last->at)->at, dots = line.rfind("..", last->at);
    return dots != std::string_view::npos && dots >= name ? dots + 2 : name;
  }
  const std::string_view word = line.substr(last->at);
  const std::size_t open = word.rfind('{'), close = word.rfind('}');
  const bool in_braces = open != std::string_view::npos && (close == std::string_view::npos || close < open);
  return in_braces ? last->at + word.find_last_of("{,") + 1 : last->at;
}

bool takes_target(std::string_view line) {
  const Begun b = begun(line, {});
  const std::string_view words = words_after(b.verb, b.place());
  if (without_indent(words).empty()) return true;
  return (has_word(words, "TARGET") || has_word(words, "QUERY")) && !has_word(words, "OBJECT");
}

std::optional<Kind> kind_at(std::string_view line, const Document& d) {
  const Begun b = begun(line, {});
  const std::size_t dot = first_dot(b.last);
  if (dot == std::string_view::npos) return kind_before(d.scene(), b);
  const auto all = select(d.scene(), b.last.substr(0, dot));
  return all.empty() ? std::nullopt : std::optional(kind(d, all.front()));
}

std::vector<std::string> completions(std::string_view line, const Document& d, const LineAround& around) {
  const Begun b = begun(line, around);
  Words all;
  if (b.time_next()) all = moment_names(d.scene());
  if (b.in_moment())
    all = moments_like(d.scene(), b.last);
  else if (first_dot(b.last) != std::string_view::npos)
    parts_of_target(d, b.last, has_word(words_after(b.verb, b.place()), "QUERY"), all);
  else
    offered(d, b, around, all);
  std::erase_if(all, [&](const std::string& w) { return !w.starts_with(b.last); });
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<std::string> Session::complete(std::string_view line) const {
  const auto& sheet = state_->editor.now().script.left;
  LineAround around{.in_shell = true, .styles = state_->callbacks.styles};
  if (sheet) around.sheet_open = true, around.list = !sheet->sheet.list.empty(), around.sheet = sheet->pattern;
  return completions(line, document(), around);
}

}  // namespace betwixt

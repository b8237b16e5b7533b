// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Completion of the last word of a line.
#include "editor/completion.h"

#include <fmt/format.h>

#include <algorithm>

#include "commands/command.h"
#include "commands/verbs.h"
#include "editor/help.h"
#include "editor/said_line.h"
#include "editor/session_state.h"
#include "language/line_words.h"
#include "scene/colors.h"
#include "scene/names.h"
#include "track/filter.h"

namespace betwixt {
namespace {

using Words = std::vector<std::string>;

// A line, split into its last word and the words before it, without `at TIME` and `on LAYER`.
struct Begun {
  Words words;
  std::string verb;  // may be empty
  std::string_view last;
  std::string key;  // of key=, if the last word is its value
  bool timed = false, layered = false;
  bool row = false, in_list = false;
  bool timed_next() const { return !words.empty() && words.back() == "at"; }
  std::size_t place() const { return words.empty() ? 0 : words.size() - 1; }  // index after the verb
};

// Words that depend only on the verb and on the place after it.
struct Following {
  std::string_view verb;
  std::size_t place;
  std::string_view words;  // separated by blanks
};
constexpr Following following[] = {
    {"policy", 0, "translate ignore ask"},
    {"notes", 0, "on off"},
    {"record", 0, "on off"},
    {"background", 0, "none transparent"},
    {"background", 1, "to"},
    {"film", 0, "flat solid"},
    {"ambient", 0, "off"},
    {"fog", 0, "off"},
    {"fog", 1, "from"},
    {"fog", 3, "to"},
    {"ground", 0, "on off"},
    {"sky", 0, "on off"},
    {"contact", 0, "on off"},
    {"size", 0, "1280x720 1920x1080 3840x2160"},
    {"extend", 1, "hold linear cycle bounce"},
    {"extend", 2, "before after"},
    {"twerper", 2, "in=light in=srgb"},
    {"layer", 1, "add mix"},
    {"procedure", 1, "twerper filter command lua"},
    {"procedure", 2, "lua"},
    {"create", 1, "like scene"},
    {"look", 0, "through"},
    {"couple", 1, "to"},
    {"attach", 1, "to"},
    {"hang", 1, "on"},
    {"couple", 3, "keep-world"},
    {"attach", 3, "keep-world"},
    {"hang", 3, "keep-world"},
    {"copy", 2, "to"},
    {"copy", 4, "on shift times"},
    {"copy", 6, "on shift times"},
    {"copy", 8, "on shift times"},
    {"move", 2, "by"},
    {"stretch", 2, "by"},
    {"clear", 1, "before"},
    {"stagger", 1, "by"},
    {"stagger", 3, "from per random"},
    {"stagger", 4, "first last centre edges random"},
    {"bake", 2, "every within"},
    {"bake", 4, "within"},
    {"split", 1, "into"},
    {"split", 2, "letters words lines"},
    {"arrange", 1, "in"},
    {"arrange", 2, "row column grid circle"},
    {"arrange", 3, "gap= centre= columns= radius="},
    {"place", 1, "next-to"},
    {"place", 3, "side= gap= align="},
    {"spread", 1, "from"},
    {"spread", 3, "to"},
    {"samples", 0, "1 4 9 16"},
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
  long open = 0;
  for (std::string& w : line_words(text)) {
    if (open > 0)
      all.back() += " " + w;
    else
      all.push_back(std::move(w));
    open =
        std::count(all.back().begin(), all.back().end(), '(') - std::count(all.back().begin(), all.back().end(), ')');
  }
  return all;
}

// Completes functions after the first dot of a target, components after the second.
void parts_of_target(const Document& d, std::string_view last, bool asking, Words& all) {
  const Scene& s = d.scene();
  const std::size_t dot = last.find('.');
  const std::string_view object = last.substr(0, dot);
  const std::size_t behind = last.find('.', dot + 1);
  for (const ObjectId id : select(s, object)) {
    const Kind kind = s.objects[id.index].kind;
    if (behind == std::string_view::npos) {
      for (const auto f : function_names(s, kind)) all.push_back(fmt::format("{}.{}", object, f));
      for (const char* query : {"world", "touching", "in-view", "loudness", "onsets"})
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

void own_words(const Scene& s, Role role, Words& all) {
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == role) all.push_back(p.name);
}

void filters(const Scene& s, Words& all) {
  all.emplace_back("none");
  for (const FilterSpec& f : built_in_filters()) all.emplace_back(f.name);
  own_words(s, Role::filter, all);
}

void files(const std::filesystem::path& folder, Words& all) {
  std::error_code why;
  for (const auto& e : std::filesystem::directory_iterator(folder, why)) all.push_back(e.path().filename().string());
}

void objects_of(const Scene& s, Kind kind, Words& all) {
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    if (!s.objects[i].removed && s.objects[i].kind == kind) all.push_back(s.objects[i].name);
}

// The names defined by `let`: those of colours, or all others.
void let_names(const Scene& s, bool colors, Words& all) {
  for (const auto& [name, value] : *s.lets)
    if (std::holds_alternative<Color>(value) == colors) all.push_back(name);
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
      return words("euler axis quat");
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

void behind_key(const Document& d, const Begun& b, Words& all) {
  const Kind kind = b.words.size() > 2 ? find_kind(b.words[2]).value_or(Kind::sphere) : Kind::sphere;
  if (b.verb == "create")
    if (const auto f = find_function(d.scene(), kind, b.key)) value_words(d, spec_of(d.scene(), *f), all);
}

void parameters(const Document& d, const Begun& b, Words& all) {
  if (b.verb == "create" && b.place() >= 2)
    if (const auto kind = find_kind(b.words[2]))
      for (const auto name : function_names(d.scene(), *kind)) all.push_back(fmt::format("{}=", name));
  if (b.verb == "filter" && b.place() >= 2)
    if (const FilterSpec* f = find_filter(b.words[2]))
      for (const FilterParameter& p : f->parameters) all.push_back(fmt::format("{}=", p.name));
  if (b.verb == "fall" && b.place() >= 1) split("delay= gravity= ground= bounce= for", ' ', all);
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

bool takes_color(const Begun& b) {
  const bool first = b.verb == "background" || b.verb == "ambient" || b.verb == "fog" || b.verb == "ground";
  return (first && b.place() == 0) || (b.verb == "background" && b.place() == 2);
}

// Adds the words that depend on the verb. Returns false if names of objects can come there too.
bool by_verb(const Document& d, const Begun& b, const LineAround& around, Words& all) {
  const Scene& s = d.scene();
  const std::size_t before = all.size();
  for (const Following& f : following)
    if (f.verb == b.verb && f.place == b.place()) split(f.words, ' ', all);
  if (b.verb == "create" && b.place() == 1)
    for (const KindRow& k : kinds()) all.emplace_back(k.name);
  if (b.verb == "define" && b.place() == 1)
    for (const std::string_view w : type_words()) all.emplace_back(w);
  if (takes_color(b)) value_words(d, spec_of(s, fn::color), all);
  if (b.verb == "filter" && b.place() == 1) filters(s, all);
  if (b.verb == "twerper" && b.place() == 1) ways(s, Type::vector, all), all.emplace_back("none");
  if (b.verb == "look" && b.place() == 1) objects_of(s, Kind::camera, all);
  if (b.verb == "on" && b.place() == 0) objects_of(s, Kind::layer, all);
  if (b.verb == "style") all.insert(all.end(), around.styles.begin(), around.styles.end());
  if (b.verb == "help") words_of_help(all);
  if (b.verb == "save" || b.verb == "open" || b.verb == "use" || b.verb == "load") files(around.folder, all);
  parameters(d, b, all);
  return all.size() > before || (b.verb == "create" && b.place() < 2);
}

// Returns true if a time, a number or nothing comes next.
bool nothing_known(const Begun& b) {
  static constexpr std::string_view of_numbers[] = {"at",   "rate", "ticks", "range", "note",    "play",
                                                    "undo", "redo", "exit",  "quit",  "exposure"};
  if (b.row || b.words.empty()) return false;
  return std::find(std::begin(of_numbers), std::end(of_numbers), b.verb) != std::end(of_numbers);
}

void offered(const Document& d, const Begun& b, const LineAround& around, Words& all) {
  if (!b.key.empty()) return behind_key(d, b, all);
  if (b.in_list && b.words.empty()) {
    for (const HelpEntry& e : help_entries())
      if (e.group == HelpGroup::row) all.emplace_back(e.word);
    return;
  }
  if (b.row && !b.in_list && !b.words.empty()) return event_words(d, around.sheet, b.words.size() == 1, all);
  if ((b.row && !b.in_list) || b.timed_next()) return let_names(d.scene(), false, all);
  if (nothing_known(b)) return;
  if (b.words.empty()) first_words(b, around.in_shell, all);
  const bool target = b.verb.find('.') != std::string::npos;
  if (b.timed && target) return event_words(d, b.verb, b.words.size() == 1, all);
  if (b.verb == "set" && b.place() >= 1) return event_words(d, b.words[1], b.place() == 1, all);
  if (by_verb(d, b, around, all)) return;
  for (const std::string& name : d.names()) all.push_back(name);
}

// Removes `at TIME` and `on LAYER`.
void take_off(Begun& b) {
  while (b.words.size() >= 2 && (b.words[0] == "at" || b.words[0] == "on")) {
    (b.words[0] == "at" ? b.timed : b.layered) = true;
    b.words.erase(b.words.begin(), b.words.begin() + 2);
  }
}

}  // namespace

std::size_t begun_word(std::string_view line) {
  const std::size_t blank_at = line.find_last_of(" \t,(=");
  return blank_at == std::string_view::npos ? 0 : blank_at + 1;
}

std::vector<std::string> completions(std::string_view line, const Document& d, const LineAround& around) {
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
  static constexpr std::string_view askers[] = {"eval", "plot", "describe"};
  const bool asking = std::find(std::begin(askers), std::end(askers), b.verb) != std::end(askers);
  Words all;
  if (b.last.find('.') != std::string_view::npos)
    parts_of_target(d, b.last, asking, all);
  else
    offered(d, b, around, all);
  std::erase_if(all, [&](const std::string& w) { return !w.starts_with(b.last); });
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<std::string> Session::complete(std::string_view line) const {
  const auto& sheet = state_->editor.now().script.left;
  LineAround around{.in_shell = true, .styles = state_->doors.styles};
  if (sheet) around.sheet_open = true, around.list = !sheet->sheet.list.empty(), around.sheet = sheet->pattern;
  return completions(line, document(), around);
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <vector>

#include "base/names.h"
#include "commands/command_parameters.h"
#include "commands/foreign_words.h"
#include "commands/list_rows.h"
#include "commands/parts.h"
#include "commands/plugins.h"
#include "commands/verbs.h"
#include "scene/own_kinds.h"

namespace betwixt {
namespace {

using enum HelpGroup;

constexpr HelpEntry other_words[] = {
    {function, "world",
     "Its matrix in the world; of an environment, the product of its updates until the time; read only.", "", ""},
    {function, "by", "The matrix of one update of an environment; read only.", "", ""},
    {function, "every", "How many ticks there are from one update of an environment to the next; read only.", "", ""},
    {function, "count", "How many updates an environment has made until the time; read only.", "", ""},
    {function, "loudness", "The loudness of a sound at a time, 0 to 1; read only.", "", ""},
    {function, "onsets", "How many onsets (beats, strokes) a sound has had up to a time; read only.", "", ""},
    {function, "touching", "The names of the objects that it touches; read only.", "", ""},
    {function, "in-view", "Whether any part of it is in view; read only.", "", ""},

    {kind, "scene",
     "The contents of a file (glTF, BVH, FBX, Collada, SVG): nodes become objects, animation becomes tracks.",
     "file=\"…\" animation=… start=TIME, then settings of the whole", ""},
    {kind, "disc", "Another name of `circle`.", "radius=1", "create dot disc radius=3"},

    {option, "cut", "A jump: the track arrives at the first value and continues from the second.", "VALUE cut VALUE",
     "at 12f ball.radius 2 cut 1"},
    {option, "keep", "Changes only the twerper; the value stays as it would be without the event.", "keep TWERPER",
     "at 12f ball.radius keep linear"},
    {option, "ease-in",
     "For this length of time before the event the track slows down, so that it arrives slowly. (The twerper "
     "`ease-in`, without a length, begins slowly.)",
     "ease-in=LENGTH", "at 12f ball.radius 2 ease-in=4f"},
    {option, "ease-out",
     "For this length of time after the event the track speeds up, so that it leaves slowly. (The twerper `ease-out`, "
     "without a length, ends slowly.)",
     "ease-out=LENGTH", "at 12f ball.radius 2 ease-out=4f"},
    {option, "tangent", "The tangents of hermite, per second; also tangent-in, tangent-out.", "tangent=VALUE",
     "at 12f ball.radius 2 hermite tangent=1"},
    {option, "velocity", "The velocity of a target, on a track of its own; it overrides the values until a release.",
     "TARGET.velocity", "at 12f ball.position.velocity (1 0 0)"},
    {option, "release", "Ends a velocity; from here the track goes to its next event.",
     "at TIME TARGET.velocity release", "at 12f ball.position.velocity (1 0 0)\nat 24f ball.position.velocity release"},
    {option, "keep-world", "The attached object keeps its place in the world at that moment.",
     "attach A to B keep-world", "at 20f attach ball to hand keep-world"},
};

struct GroupRow {
  HelpGroup group;
  std::string_view word, title;  // `word`: the argument of `help` that lists the group
};
constexpr GroupRow groups[] = {
    {shell, "shell", "Shell commands"},
    {verb, "commands", "Commands"},
    {row, "rows", "Rows of display lists (make NAME)"},
    {kind, "kinds", "Kinds of objects (create NAME KIND …)"},
    {function, "functions", "Functions (NAME.function)"},
    {twerper, "twerpers", "Twerpers (interpolation from one event to the next)"},
    {filter, "filters", "Filters (filter TARGET NAME …)"},
    {option, "options", "Options of events and attachments"},
};

// In the order of the enumeration.
const GroupRow& row_of(HelpGroup group) { return groups[static_cast<std::size_t>(group)]; }

void list_group(const GroupRow& row, std::string& out) {
  out += fmt::format("{}\n", row.title);
  for (const HelpEntry& e : help_entries())
    if (e.group == row.group) out += fmt::format("  {:16} {}\n", e.word, e.sentence);
}

// Returns whether the word is only used with a sign: "tangent=VALUE".
bool is_key(const HelpEntry& e) { return e.group == option && e.usage.starts_with(std::string(e.word) + "="); }

// Describes a word that exists under another name.
std::string signpost(const ForeignWord& r) {
  std::string out = fmt::format("{}: {}\n", r.word, r.leads);
  std::string_view rest = r.see;
  for (std::size_t end = 0; !rest.empty(); rest.remove_prefix(std::min(rest.size(), end + 1))) {
    end = std::min(rest.find(' '), rest.size());
    out += fmt::format("{}help {}", rest.size() == r.see.size() ? "  see: " : ", ", rest.substr(0, end));
  }
  return out + "\n";
}

constexpr std::string_view what(HelpGroup g) {
  return g == shell      ? "a shell command"
         : g == verb     ? "a command"
         : g == row      ? "a row of a display list"
         : g == kind     ? "a kind of object"
         : g == function ? "a function"
         : g == twerper  ? "a twerper"
         : g == filter   ? "a filter"
                         : "an event option";
}

// Describes a procedure: its role, and its author's sentence.
std::string about(const NamedProcedure& p) {
  static constexpr std::array<std::string_view, role_names.size()> roles{
      "A procedure", "A twerper", "A filter", "A command", "A stepped procedure", "A tween"};
  const bool plugin = p.code && p.code->language == "plug-in";
  std::string out = fmt::format("{} {}", roles[static_cast<std::size_t>(p.role)],
                                plugin ? fmt::format("of the plug-in {}", p.code->source) : "of this film");
  std::string says = plugin ? plugin_help(p.name) : p.help;
  if (says.ends_with('.')) says.pop_back();
  if (!says.empty()) out += ": " + says;
  return out + ".";
}

// Returns "frequency=2 damping=0.3"; an infinite default is left out.
std::string written_parameters(const FilterSpec& f) {
  std::string out;
  for (const FilterParameter& p : f.parameters) {
    const std::string rest = std::isfinite(p.rest) ? fmt::format("{}{}", p.rest, p.time ? "s" : "") : "";
    out += fmt::format("{}{}={}", out.empty() ? "" : " ", p.name, rest);
  }
  return out;
}

}  // namespace

std::string_view word_of(HelpGroup group) { return row_of(group).word; }

std::span<const HelpEntry> help_entries() {
  static const std::vector<HelpEntry> all = [] {
    std::vector<HelpEntry> entries = shell_entries();
    for (const Verb& v : verbs()) entries.push_back({verb, v.word, v.sentence, v.usage, v.example});
    for (const ListRow& r : list_rows()) entries.push_back({row, r.word, r.sentence, r.usage, r.example});
    static std::deque<std::string> written;  // of kinds and filters
    for (const KindRow& k : kinds())
      entries.push_back({HelpGroup::kind, k.name, k.sentence, written.emplace_back(written_of(k)), k.example});
    for (const bool common : {true, false})  // common functions first
      for (const FunctionSpec& f : built_in_functions())
        if (!f.sentence.empty() && common == ((f.kinds & bit(Kind::group)) != 0))
          entries.push_back({HelpGroup::function, f.name, f.sentence, f.written, f.example, &f});
    entries.insert(entries.end(), std::begin(other_words), std::end(other_words));
    for (const TwerperRow& t : twerpers())
      if (!t.sentence.empty()) entries.push_back({HelpGroup::twerper, t.name, t.sentence, t.written, t.example});
    for (const FilterSpec& f : built_in_filters())
      entries.push_back(
          {HelpGroup::filter, f.name, f.sentence, written.emplace_back(written_parameters(f)), f.example});
    return entries;
  }();
  return all;
}

std::vector<std::string_view> words_with_help() {
  std::vector<std::string_view> all;
  for (const HelpEntry& e : help_entries()) all.push_back(e.word);
  for (const ForeignWord& r : foreign_words()) all.push_back(r.word);
  for (const GroupRow& g : groups) all.push_back(g.word);
  return all;
}

std::string owners_of(const FunctionSpec& f) {
  if (f.kinds == bit(Kind::group)) return "a group";
  if (f.kinds & bit(Kind::group)) return "every object";
  std::string out;
  for (const KindRow& k : kinds())
    if (f.kinds & bit(k.kind)) out += (out.empty() ? "" : ", ") + std::string(k.name);
  return out;
}

std::string_view sentence_of(std::string_view word, std::optional<Kind> of) {
  const std::size_t dot = word.rfind('.');
  const bool key = word.ends_with('='), part = of && dot != std::string_view::npos;
  if (key) word.remove_suffix(1);
  if (part) word.remove_prefix(dot + 1);
  for (const HelpEntry& e : help_entries()) {
    if (e.word != word) continue;
    const bool of_kind = of && (!e.function || (e.function->kinds & bit(*of)));
    if (key || part ? e.group == option || (e.group == HelpGroup::function && of_kind)
                    : e.group != HelpGroup::function && !is_key(e))
      return e.sentence;
  }
  return {};
}

std::string_view sentence_of(const FunctionView& f) {
  return f.id < built_in_functions().size() ? built_in_functions()[f.id].sentence : std::string_view();
}

std::string help_overview(const Scene& scene, bool of_the_shell) {
  std::string out =
      "A line is a command; a line that is only a target (ball.position) opens a sheet, whose rows are indented:\n"
      "  TIME VALUE [TWERPER] [ease-in=LENGTH] [ease-out=LENGTH]\n";
  for (const GroupRow& group : groups) {
    if (group.group == shell && !of_the_shell) continue;
    out += "\n";
    list_group(group, out);
  }
  if (!scene.defined->empty() || !scene.procedures->empty() || !scene.kinds->all.empty() || !scene.parts->empty())
    out += "\nOf this film and of plug-ins\n";
  for (const OwnKind& kind : scene.kinds->all)
    out += fmt::format("  {:16} A kind, like {}.\n", kind.name, scene.objects[kind.model().index].name);
  for (const auto& [name, part] : *scene.parts)
    if (part.help.empty()) out += fmt::format("  {:16} A part: {}.\n", name, usage_of(name, part));
  for (const FunctionSpec& f : *scene.defined)
    out += fmt::format("  {:16} A function: {}.\n", f.name, to_string(f.type));
  for (const NamedProcedure& p : *scene.procedures) out += fmt::format("  {:16} {}\n", p.name, about(p));
  out += "\nParts (create NAME PART …)\n";
  for (const PartRow& part : part_rows()) out += fmt::format("  {:16} {}\n", part.name, part.sentence);
  return out +
         "\nhelp WORD explains a word and gives an example; help commands, help kinds, help twerpers … list a part of "
         "this.\n";
}

namespace {

// Usage that ends in … is about a few of the words that a function takes.
std::string whole_usage(const HelpEntry& e) {
  if (!e.function || e.function->words.empty() || !e.usage.ends_with("…")) return std::string(e.usage);
  std::string all(e.function->words);
  for (std::size_t at = 0; (at = all.find('|', at)) != std::string::npos; at += 2) all.replace(at, 1, ", ");
  return all;
}

bool is_material(std::string_view word) {
  for (const FunctionSpec& f : built_in_functions())
    if (f.name == "material") return fmt::format("|{}|", f.words).find(fmt::format("|{}|", word)) != std::string::npos;
  return false;
}

}  // namespace

std::string help_text(std::string_view word, const Scene& scene, std::optional<Kind> of_kind) {
  const bool shared =
      std::ranges::count_if(help_entries(), [&](const HelpEntry& e) { return e.function && e.word == word; }) > 1;
  std::string out;
  static constexpr std::array<std::string_view, 2> factors[] = {
      {"T", "a translation, T(6 0) or T(6 0 0)"},
      {"R", "a rotation about a point, R(90deg @ 0 1), an object, R(1turn @ sun), or an axis, R(1turn @ 0 1 0 axis y)"},
      {"S", "a scaling about a point, S(2), S(2 0.5 @ 0 1), or by the linear law, S(2 2 @ 0 0 linear)"}};
  for (const auto& [letter, sentence] : factors)
    if (letter == word)
      out = fmt::format("{}, a factor of a motion: {}\n  example: at 1f..48f ball.motion T(6 0) R(-1turn @ ball)\n",
                        letter, sentence);
  for (const GroupRow& group : groups)
    if (group.word == word) list_group(group, out);
  for (const ForeignWord& r : foreign_words())
    if (same_letters(r.word, word)) out += signpost(r);
  for (const HelpEntry& e : help_entries()) {
    if (e.word != word || (of_kind && e.function && !(e.function->kinds & bit(*of_kind)))) continue;
    if (!out.empty()) out += "\n";
    const std::string of = shared && e.function ? " of " + owners_of(*e.function) : "";
    out += fmt::format("{}, {}{}: {}\n", e.word, what(e.group), of, e.sentence);
    if (!e.usage.empty()) out += fmt::format("  {}: {}\n", e.group <= row ? "usage" : "written", whole_usage(e));
    if (!e.example.empty()) {
      std::string lines(e.example);
      for (std::size_t at = 0; (at = lines.find('\n', at)) != std::string::npos; at += 12)
        lines.insert(at + 1, 11, ' ');
      out += fmt::format("  example: {}\n", lines);
    }
  }
  if (out.empty() && is_material(word))
    out = fmt::format("{0}, a material: see material\n  example: create ball sphere material={0}\n", word);
  const OwnKind* const kind = scene.kinds->find(word);
  if (!kind && plugin_kind(word))
    out += fmt::format("{}, a kind of a plug-in: {}\n  example: create NAME {}\n", word, plugin_help(word), word);
  if (kind)
    out += fmt::format("{}, a kind of this film, like {}: describe {}\n  example: create NAME {}\n", word,
                       scene.objects[kind->model().index].name, word, word);
  if (const auto part = part_called(scene, word))
    out += fmt::format("{}, a part{}: {}\n  written: {}\n  example: create NAME {}\n", word,
                       part->help.empty() ? " of this film" : "",
                       part->help.empty() ? "create NAME PART carries out its lines." : part->help,
                       usage_of(std::string(word), *part), word);
  for (const FunctionSpec& f : *scene.defined)
    if (f.name == word) out += fmt::format("{}, a function of this film: {}\n", f.name, to_string(f.type));
  for (const NamedProcedure& p : *scene.procedures) {
    if (p.name != word) continue;
    out += fmt::format("{}: {}\n", p.name, about(p));
    if (!p.parameters.empty()) {
      out += fmt::format("  usage: {}\n", usage_of(p));
      continue;
    }
    static constexpr std::array<std::string_view, role_names.size()> examples{
        "set ball.radius = \"{0}()\"", "at 12f ball.radius 2 {0}", "filter ball.radius {0}", "{0}",
        "set ball.radius = \"{0}()\"", "at 12f ball.radius 2 {0}"};
    out +=
        fmt::format("  example: {}\n", fmt::format(fmt::runtime(examples[static_cast<std::size_t>(p.role)]), p.name));
  }
  return out;
}

}  // namespace betwixt

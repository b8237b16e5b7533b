// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts: `part lamp height=1` with indented lines, and `create street{1..5} lamp height=i`.
#include "commands/parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/furnishing.h"
#include "commands/given_lets.h"
#include "language/formula.h"
#include "scene/colors.h"
#include "scene/own_kinds.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

constexpr std::size_t most_parts = 1000, most_part_parameters = 30, deepest_part = 32;
constexpr std::string_view too_deep_in_parts = "contains itself, or parts are more than 32 levels deep";

bool name_of_part(Command& k, std::string_view& name) {
  auto& [s, c, time, layer, script] = k;
  if (!new_name(c, name, "part's name", "/")) return false;
  if (name == "scene" || name == "like" || find_kind(name) || s.kinds->find(name))
    return c.fail(ErrorCode::name, fmt::format("a kind '{}' already exists", name), name);
  if (s.parts->contains(name) && !script.live)
    return c.fail(ErrorCode::name, fmt::format("a part '{}' already exists", name), name);
  for (const PartRow& row : part_rows())
    if (row.name == name && !s.parts->contains(name))
      script.note(Severity::warning, fmt::format("the part '{}' of the program is not used from here on", name), name,
                  "give this one another name, or leave it out");
  return s.parts->size() < most_parts ||
         c.fail(ErrorCode::range, fmt::format("a script can have at most {} parts", most_parts), name);
}

// Reads NAME=VALUE.
bool parameter_of_part(Command& k, Part& part) {
  Cursor& c = k.cursor;
  const std::string_view name = c.next_word();
  const auto fits = [](char ch) { return is_letter(ch) || is_digit(ch) || ch == '_'; };
  if (name.empty() || !is_letter(name[0]) || name.size() > 100 || !std::all_of(name.begin(), name.end(), fits))
    return c.fail(ErrorCode::syntax,
                  name.empty() ? "expected NAME=VALUE here"
                               : fmt::format("'{}' cannot be a parameter's name", name.substr(0, 60)),
                  name.empty() ? std::string_view(c.at, c.at < c.end ? 1 : 0) : name,
                  "a name is a letter, then letters, digits and '_'");
  if (is_formula_word(name) || named_color(name) || name == "self" || name == "row")
    return c.fail(ErrorCode::name, fmt::format("'{}' already has a meaning in formulas", name), name);
  for (const PartParameter& p : part.parameters)
    if (p.name == name) return c.fail(ErrorCode::name, fmt::format("there are two parameters '{}'", name), name);
  if (part.parameters.size() >= most_part_parameters)
    return c.fail(ErrorCode::range, fmt::format("a part can have at most {} parameters", most_part_parameters), name);
  if (!c.accept('='))
    return c.fail_here(ErrorCode::syntax, fmt::format("the parameter '{}' needs a default", name),
                       fmt::format("as in {}=1", name));
  c.space();
  const char* const start = c.at;
  PartParameter p{std::string(name), {}, {}};
  if (!let_value(k, p.value)) return false;
  p.said = c.since(start);
  part.parameters.push_back(std::move(p));
  return true;
}

bool part(Command& k) {
  auto& [s, c, time, layer, script] = k;
  Part made;
  std::string_view name;
  if (!name_of_part(k, name)) return false;
  while (!c.at_line_end())
    if (!parameter_of_part(k, made)) return false;
  made.at = script.source.diagnose(Severity::notice, {}, {c.at, 0}).what.place;
  script.open_block(script.verb).part = name;
  s.parts.edit()[std::string(name)] = std::move(made);
  return true;
}

// The lets of a part's lines: those of the script, and the parameters. What the lines add is gone behind them.
struct OwnLets {
  Scene& s;
  const Cow<Lets> before;
  OwnLets(Scene& scene, const std::vector<PartParameter>& values) : s(scene), before(scene.lets) {
    Lets& lets = s.lets.edit();
    for (const PartParameter& p : values) lets.insert_or_assign(p.name, p.value);
  }
  ~OwnLets() { s.lets = before; }
  OwnLets(const OwnLets&) = delete;
  OwnLets& operator=(const OwnLets&) = delete;
};

// Reads the parameters of the part, and display functions of its group.
bool arguments_of_part(Command& k, const Part& part, std::vector<PartParameter>& values, Object& group) {
  Cursor& c = k.cursor;
  values = part.parameters;
  while (!c.at_line_end()) {
    Cursor ahead = c;
    const std::string_view key = ahead.word();
    const auto p =
        std::find_if(values.begin(), values.end(), [&](const PartParameter& one) { return one.name == key; });
    if (p != values.end() && ahead.accept('=')) {
      c = ahead;
      if (!let_value(k, p->value)) return false;
      continue;
    }
    const std::string_view function = key.substr(0, key.find('.'));
    if (!key.empty() && !find_function(k.scene, Kind::group, function)) {
      std::vector<std::string_view> names = function_names(k.scene, Kind::group);
      for (const PartParameter& one : values) names.push_back(one.name);
      Hint hint = did_you_mean(key, names);
      if (hint.empty() && !values.empty()) {
        std::string all;
        for (const PartParameter& one : values) all += " " + one.name;
        hint = "its parameters are" + all;
      }
      return c.fail(ErrorCode::name, fmt::format("this part has no '{}'", key.substr(0, 40)), key, std::move(hint));
    }
    if (!one_parameter(k, group)) return false;
  }
  return true;
}

}  // namespace

bool take_part_line(Command& k, const char* start) {
  auto& [s, c, time, layer, script] = k;
  const char* const end = logical_line(between(start, c.end)).end;
  Part& part = s.parts.edit()[script.blocks.back().part];
  // Lines without a command keep their numbers.
  const int number = script.source.diagnose(Severity::notice, {}, {start, 0}).what.place.line;
  for (auto has = std::count(part.lines.begin(), part.lines.end(), '\n'); part.at.line + has + 1 < number; ++has)
    part.lines += '\n';
  part.lines.append(start, end);
  part.lines += '\n';
  return c.at = end, true;
}

std::vector<std::string_view> part_names(const Scene& s) {
  std::vector<std::string_view> names;
  for (const auto& [name, part] : *s.parts) names.push_back(name);
  for (const PartRow& row : part_rows())
    if (!s.parts->contains(row.name)) names.push_back(row.name);
  return names;
}

std::optional<Part> part_called(const Scene& s, std::string_view name) {
  if (const auto known = s.parts->find(name); known != s.parts->end()) return known->second;
  Scene other;
  Diagnostics said;
  Script script(other, said, {});
  Cursor c("");
  Command k{other, c, {}, {}, script};
  const Part* const row = find_part(k, name);
  return row ? std::optional(*row) : std::nullopt;
}

const Part* find_part(Command& k, std::string_view name) {
  Scene& s = k.scene;
  if (const auto known = s.parts->find(name); known != s.parts->end()) return &known->second;
  const auto rows = part_rows();
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const PartRow& one) { return one.name == name; });
  if (row == rows.end()) return nullptr;
  const std::string text = fmt::format("part {}{}\n{}", row->name, row->head, row->lines);
  if (!carry_out_lines(k, text, name)) return nullptr;
  Part& part = s.parts.edit().find(name)->second;
  // What has no ground of its own has the color of texts of the film's theme.
  const auto ink = s.lets->find("ink");
  for (PartParameter& p : part.parameters)
    if (p.name == "ink" && row->on_background && ink != s.lets->end()) p.value = ink->second;
  part.help = row->sentence, part.at = {};
  return &part;
}

bool create_parts(Command& k, const std::vector<std::string>& names, const std::vector<ObjectId>& parents,
                  std::string_view name) {
  auto& [s, c, time, layer, script] = k;
  const Part part = *find_part(k, name);  // a copy, because its lines may change the parts
  Object group;
  std::vector<PartParameter> values;
  if (!arguments_of_part(k, part, values, group) || !finish(c)) return false;
  if (part.lines.empty())
    return c.fail(ErrorCode::syntax, fmt::format("the part '{}' has no lines", name), name,
                  "write them below its first line, indented");
  if (script.depth >= static_cast<int>(deepest_part))
    return c.fail(ErrorCode::range, fmt::format("the part '{}' {}", name, too_deep_in_parts), name);
  Rollback rollback(s);
  for (std::size_t i = 0; i < names.size(); ++i) {
    group.name = names[i];
    add_child(s, group, parents[i]);
    const OwnLets lets(s, values);
    for (const Diagnostic& d : carried_out(k, lines_for(part, names[i]), true)) {
      if (d.severity != Severity::error) continue;
      if (d.what.message.ends_with(too_deep_in_parts)) return c.fail(d.what.code, d.what.message, name);
      const int line = d.what.place.line;
      const std::string where = part.at.line > 0 && !part.at.file.empty()
                                    ? fmt::format("{}:{}", part.at.file, part.at.line + line)
                                    : fmt::format("line {} of the part", line);
      return c.fail(d.what.code, fmt::format("{}: {}: {}", name, where, d.what.message), name, d.what.hint);
    }
  }
  return rollback.keep(), true;
}

static constexpr Verb parts_rows[] = {
    {"part", "part NAME [PARAMETER=DEFAULT] …, and its lines below, indented",
     "Makes a kind of your own from lines. `create NAME PART` carries them out; what they create is below NAME, and "
     "the "
     "parameters are names in their formulas. In the lines `self` is the object itself.",
     "part lamp height=1 color=gold\n  create pole box size=(0.1 height 0.1) position=(0 height/2 0)\n  create bulb "
     "sphere "
     "radius=0.2 position=(0 height 0) color=color\ncreate street{1..5} lamp height=i position=(2*i 0 0)",
     Verb::opens_block | Verb::makes_kind, part, "NEW"},
};
std::span<const Verb> parts_verbs() { return parts_rows; }

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/subcommand.h"
#include "editor/help.h"
#include "language/values.h"
#include "scene/functions.h"
#include "scene/kinds.h"

namespace betwixt {
namespace {

// ---- Markdown

// Escapes a sentence. Code between backticks stays as it is.
std::string prose(std::string_view text) {
  std::string out;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (c == '|' || (!code && (c == '*' || c == '_' || c == '<'))) out += '\\';
    out += c;
  }
  return out;
}

// Returns code for a cell of a table. A cell cannot hold lines, so each line is code of its own.
std::string code(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    for (std::size_t at = 0; (at = line.find('|', at)) != std::string::npos; at += 2) line.insert(at, "\\");
    out += (out.empty() ? "`" : "<br>`") + line + "`";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string block(std::string_view text) { return fmt::format("```\n{}\n```\n", text); }

std::string generated(std::string_view title, std::string_view page) {
  return fmt::format("# {}\n\n<!-- `betwixt help --print {}` writes this page from the rows of the program. -->\n\n",
                     title, page);
}

// ---- Words of the language

std::vector<const HelpEntry*> of_group(HelpGroup group) {
  std::vector<const HelpEntry*> all;
  for (const HelpEntry& e : help_entries())
    if (e.group == group) all.push_back(&e);
  std::ranges::stable_sort(all, {}, &HelpEntry::word);
  return all;
}

// Writes a heading, the usage and an example for each word.
void add_entries(std::string& out, HelpGroup group) {
  for (const HelpEntry* e : of_group(group)) {
    out += fmt::format("\n### {}\n\n{}\n", e->word, prose(e->sentence));
    if (!e->usage.empty()) out += "\n" + block(e->usage);
    if (!e->example.empty()) out += "\nExample:\n\n" + block(e->example);
  }
}

// Writes a row for each word.
void add_table(std::string& out, HelpGroup group) {
  out += "\n| word | | written | example |\n|---|---|---|---|\n";
  for (const HelpEntry* e : of_group(group))
    out += fmt::format("| `{}` | {} | {} | {} |\n", e->word, prose(e->sentence), code(e->usage), code(e->example));
}

std::string rest_of(const FunctionSpec& f) {
  return write_value(f.rest, f, -1, [](ObjectId) { return std::string(); });
}

// Returns "`point|sun`", "a number, 0 to 1", or "a length of time, 0 to 60, in seconds".
std::string values_of(const FunctionSpec& f) {
  if (!f.words.empty()) return code(f.words);
  const bool length = f.unit == Unit::seconds || f.unit == Unit::opening, time = f.unit == Unit::moment || length;
  std::string out(length ? "a length of time" : time ? "a time" : to_string(f.type));
  const bool bounded = f.low > -1e300 && f.high < 1e300 && f.type != Type::angle;
  if (bounded) out += fmt::format(", {} to {}", f.low, f.high);
  if (f.unit == Unit::metres) out += ", in metres";
  if (f.unit == Unit::millimetres) out += ", in millimetres";
  if (time) out += ", in seconds";
  return out;
}

void add_kinds(std::string& out) {
  for (const HelpEntry* e : of_group(HelpGroup::kind)) {
    out += fmt::format("\n### {}\n\n{}\n", e->word, prose(e->sentence));
    const auto kind = find_kind(e->word);
    std::string own;
    for (const FunctionSpec& f : built_in_functions())
      if (kind && (f.kinds & bit(*kind)) && !(f.kinds & bit(Kind::group)))
        own += fmt::format("{}`{}`", own.empty() ? "" : ", ", f.name);
    if (!e->usage.empty()) out += "\n" + block(e->usage);
    if (!own.empty()) out += fmt::format("\nFunctions of its own: {}.\n", own);
    if (!e->example.empty()) out += "\nExample:\n\n" + block(e->example);
  }
}

void add_functions(std::string& out) {
  std::vector<const FunctionSpec*> all;
  for (const FunctionSpec& f : built_in_functions())
    if (owners_of(f) != "") all.push_back(&f);
  std::ranges::stable_sort(all, {}, [](const FunctionSpec* f) { return std::string_view(f->name); });
  out += "\n| function | of | value | default | |\n|---|---|---|---|---|\n";
  for (const FunctionSpec* f : all)
    out += fmt::format("| `{}` | {} | {} | {} | {} |\n", f->name, owners_of(*f), values_of(*f), code(rest_of(*f)),
                       prose(f->sentence));
  out += "\nYou can read these, but not set them:\n\n| function | |\n|---|---|\n";
  for (const HelpEntry* e : of_group(HelpGroup::function))
    if (e->sentence.ends_with("read only.")) out += fmt::format("| `{}` | {} |\n", e->word, prose(e->sentence));
}

// ---- The command line

// "-o, --output OUT"
std::string spelled(const Parameter& p) {
  std::string out = p.name;
  if (const std::size_t comma = out.find(','); comma != out.npos) out.insert(comma + 1, " ");
  return p.value.empty() ? out : out + " " + p.value;
}

std::string usage(const Subcommand& s) {
  std::string out = "betwixt " + s.name;
  for (const Parameter& p : s.takes) {
    if (p.hidden || (p.is_option() && !p.required)) continue;
    std::string text = p.is_option() ? spelled(p) : p.name;
    if (std::holds_alternative<std::vector<std::string>*>(p.into) && !p.is_option()) text += "…";
    out += p.required ? " " + text : " [" + text + "]";
  }
  return out + " [options]";
}

void add_parameters(std::string& out, const std::vector<Parameter>& parameters) {
  bool any = false;
  for (const Parameter& p : parameters) {
    if (p.hidden) continue;
    if (!any) out += "\n| | |\n|---|---|\n";
    any = true;
    out += fmt::format("| {} | {} |\n", code(spelled(p)), prose(p.sentence));
  }
}

}  // namespace

std::string language_reference() {
  std::string out = generated("Reference", "reference");
  out +=
      "This page lists every word of the language. [The guide](language.md) explains how to use them. "
      "`betwixt help WORD` prints the same.\n\n"
      "[How the lines are written](#how-the-lines-are-written) · [Commands](#commands) · [Rows of display "
      "lists](#rows-of-display-lists) · [Kinds](#kinds-of-objects) · "
      "[Functions](#display-functions) · [Twerpers](#twerpers) · [Filters](#filters) · "
      "[Words of events](#words-of-events) · [Words of the shell](#words-of-the-shell)\n";
  out +=
      "\n## How the lines are written\n\nA word in capitals stands for what you write in its place.\n\n"
      "| | |\n|---|---|\n"
      "| `A` `B` | objects: a name, or a pattern such as `wheel*` for several |\n"
      "| `NAME` | the name of one object, or of what the line makes |\n"
      "| `TARGET` | a function of an object, `ball.position`, or a component of it, `ball.position.x` |\n"
      "| `TARGETS` | one or several targets, also by patterns: `wheel*.position` |\n"
      "| `ENV` `LAYER` `LIST` | the name of an environment, a layer, a display list |\n"
      "| `TIME` | a time: `24f` (a frame), `2.5s` (seconds), `90t` (ticks) |\n"
      "| `A..B` | a segment, from one time to another: `1f..24f` |\n"
      "| `LENGTH` | a length of time: `12f`, `0.5s` |\n"
      "| `METRES` | a length in space: `0.5`, `10cm` |\n"
      "| `N` | a whole number |\n"
      "| `VALUE` | a value of the target's type: a number, a vector, a color, … |\n"
      "| `(X Y Z)` | a point or a vector |\n"
      "| `[ ]` | this part can be left out; a value in it, as in `[margin=0.1]`, is the default |\n"
      "| `\\|` | one of these |\n"
      "| `…` | more of the same |\n";
  out +=
      "\n## Commands\n\nThe first word of a line. The examples belong to a film with a `ball`, a `hand` and a camera "
      "`eye`.\n";
  add_entries(out, HelpGroup::verb);
  out += "\n## Rows of display lists\n\nRows below `make NAME` and `edit NAME`.\n";
  add_table(out, HelpGroup::row);
  out +=
      "\n## Kinds of objects\n\n`create NAME KIND [function=value …]`. Every object has the functions of "
      "[every object](#display-functions) too.\n";
  add_kinds(out);
  out += "\n## Display functions\n\n`NAME.function` is a target: you can set it, and animate it.\n";
  add_functions(out);
  out += "\n## Twerpers\n\nHow the values go from an event to the next one.\n";
  add_table(out, HelpGroup::twerper);
  out +=
      "\n## Filters\n\n`filter TARGET NAME [parameter=value …]`. The table shows the parameters with their defaults.\n";
  add_table(out, HelpGroup::filter);
  out += "\n## Words of events\n\nIn the rows of a sheet, and after `at TIME`.\n";
  add_table(out, HelpGroup::option);
  out += "\n## Words of the shell\n\nOnly [the shell](shell.md) has these words. A script cannot use them.\n";
  add_table(out, HelpGroup::shell);
  return out;
}

std::string command_line_reference() {
  std::string out = generated("The command line", "command-line");
  out +=
      "This page lists the commands of the program `betwixt` and their options. `betwixt COMMAND --help` prints the "
      "same.\n\n| command | |\n|---|---|\n";
  for (const Subcommand& s : subcommands()) out += fmt::format("| [{0}](#{0}) | {1} |\n", s.name, prose(s.sentence));
  for (const Subcommand& s : subcommands()) {
    out += fmt::format("\n## {}\n\n{} {}.\n", s.name, s.name, prose(s.sentence));
    if (!s.manual.empty()) out += "\n" + prose(s.manual) + "\n";
    out += "\n" + block(usage(s));
    add_parameters(out, s.takes);
    if (!s.note.empty()) out += "\n" + prose(s.note) + "\n";
    if (!s.example.empty()) out += "\nExample:\n\n" + block(s.example);
  }
  out += "\n## Options of all commands\n";
  add_parameters(out, common_parameters());
  return out;
}

}  // namespace betwixt

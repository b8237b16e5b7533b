// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The words of the language for programs (JSON) and for assistants (llms.txt), from the rows.
#include <fmt/format.h>

#include <algorithm>

#include "app/first_film.h"
#include "app/reference.h"
#include "app/subcommand.h"
#include "base/json.h"
#include "editor/help.h"
#include "language/values.h"
#include "scene/functions.h"

namespace betwixt {
namespace {

std::string field(std::string_view name, std::string_view value, bool last = false) {
  return fmt::format("\"{}\": {}{}", name, json_words(value), last ? "" : ", ");
}

std::string json_of(const HelpEntry& e) {
  std::string out = "{" + field("word", e.word) + field("group", word_of(e.group)) + field("sentence", e.sentence) +
                    field("usage", e.usage);
  if (e.function) {
    const FunctionSpec& f = *e.function;
    out += field("of", owners_of(f)) + field("type", to_string(f.type)) +
           field("default", write_value(f.rest, f, -1, [](ObjectId) { return std::string(); }));
    if (!f.words.empty()) out += field("values", f.words);
  }
  return out + field("example", e.example, true) + "}";
}

std::string json_of(const Parameter& p) {
  return "{" + field("name", p.name) + field("value", p.value) + field("sentence", p.sentence, true) + "}";
}

std::string json_of(const Subcommand& s) {
  std::string takes;
  for (const Parameter& p : s.takes)
    if (!p.hidden) takes += (takes.empty() ? "" : ", ") + json_of(p);
  return "{" + field("name", s.name) + field("sentence", s.sentence) + "\"takes\": [" + takes + "], " +
         field("example", s.example, true) + "}";
}

template <class All>
std::string listed_json(const All& all) {
  std::string out;
  for (const auto& one : all) out += (out.empty() ? "\n  " : ",\n  ") + json_of(one);
  return "[" + out + "\n]";
}

// A line for each word of a group: how it is written, and its sentence.
void add_lines(std::string& out, HelpGroup group, std::string_view title) {
  out += fmt::format("\n## {}\n\n", title);
  std::vector<std::string_view> seen;
  for (const HelpEntry& e : help_entries()) {
    if (e.group != group || e.sentence.empty() || std::ranges::find(seen, e.word) != seen.end()) continue;
    seen.push_back(e.word);
    std::string_view written = e.usage.empty() || group == HelpGroup::function ? e.word : e.usage;
    written = written.substr(0, written.find('\n'));
    out += fmt::format("- `{}`: {}\n", written, e.sentence);
  }
}

}  // namespace

std::string words_json() {
  return "{\"words\": " + listed_json(help_entries()) + ",\n\"commands\": " + listed_json(subcommands()) + "}\n";
}

std::string words_for_assistants() {
  std::string out =
      "# Betwixt\n\n"
      "> Betwixt makes animated films from text. A script says which value a property has at which time, and how it "
      "gets from one value to the next. Every frame depends on the script and the time alone.\n\n"
      "`betwixt help --print llms` writes this page. `betwixt help WORD` explains a word with an example, and "
      "`betwixt help --json` gives all of them. `betwixt check FILE --json` gives all errors with their places and "
      "corrections. `betwixt frame FILE --at 24f -o FILE.png` draws a picture, `betwixt render FILE -o FILE.mp4` makes "
      "the film. `betwixt mcp` is a server of the Model Context Protocol.\n\n"
      "## A film\n\n```\n";
  out += bounce_bx;
  out +=
      "```\n\n"
      "## Rules\n\n"
      "- One command is one line. `#` begins a comment.\n"
      "- `NAME.function` is a target. Indented rows below it are its events: a time, a value, a twerper "
      "(interpolation).\n"
      "- Times: `24f` is a frame, `2.5s` seconds. Frame 1 is time 0.\n"
      "- Values: numbers, `(X Y Z)`, `30deg` or `1turn`, `gold` or `#ffcc00`, `\"text\"`.\n"
      "- Patterns such as `wheel*` name several objects. `create ball{1..5} sphere` makes five.\n"
      "- Metres, y is up. Cameras look at `look-at`. A film needs a camera only if the first view does not fit.\n";
  add_lines(out, HelpGroup::verb, "Commands");
  add_lines(out, HelpGroup::kind, "Kinds of objects");
  add_lines(out, HelpGroup::function, "Functions of objects");
  add_lines(out, HelpGroup::twerper, "Twerpers");
  add_lines(out, HelpGroup::filter, "Filters");
  add_lines(out, HelpGroup::option, "Options of events");
  return out;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the last word of a line can become.
#include <algorithm>
#include <filesystem>

#include "editor/help.h"
#include "editor/said_line.h"
#include "editor/session_state.h"
#include "track/filter.h"

namespace betwixt {
namespace {

using Words = std::vector<std::string>;

// A line up to its last word, and that.
struct Begun {
  Words words;
  std::string verb;  // may be empty
  std::string_view last;
  bool row = false, in_list = false;
};

void functions(const Scene& s, std::string_view last, Words& all) {
  const std::string_view object = last.substr(0, last.find('.'));
  for (const ObjectId id : select(s, object))
    for (const auto f : function_names(s, s.objects[id.index].kind)) all.push_back(fmt::format("{}.{}", object, f));
}

bool fits_here(const HelpEntry& e, const Begun& b) {
  const bool verb = e.group == HelpGroup::verb && is_verb(e.word);
  const bool first = verb || e.group == HelpGroup::shell;
  if (b.in_list) return e.group == HelpGroup::row && b.words.empty();
  if (b.verb == "help") return e.group != HelpGroup::verb || verb;
  if (b.words.empty() && !b.row) return first;
  if (b.verb == "create") return e.group == HelpGroup::kind && b.words.size() == 2;
  if (!b.row && b.verb != "at" && b.verb != "twerper") return false;
  return e.group == HelpGroup::twerper || (b.verb == "at" && b.words.size() == 2 && first);
}

void own_words(const Scene& s, Role role, Words& all) {
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == role) all.push_back(p.name);
}

void names_and_words(const Document& d, const Begun& b, Words& all) {
  for (const HelpEntry& e : help_entries())
    if (fits_here(e, b)) all.emplace_back(e.word);
  if (b.verb != "help" && !(b.verb == "create" && b.words.size() < 3))
    for (const std::string& name : d.names()) all.push_back(name);
  if (b.row || b.verb == "at" || b.verb == "twerper") own_words(d.scene(), Role::twerper, all);
}

void filters(const Scene& s, Words& all) {
  all.emplace_back("none");
  for (const FilterSpec& f : built_in_filters()) all.emplace_back(f.name);
  own_words(s, Role::filter, all);
}

void files(Words& all) {
  std::error_code why;
  for (const auto& e : std::filesystem::directory_iterator(".", why)) all.push_back(e.path().filename().string());
}

}  // namespace

std::vector<std::string> Session::complete(std::string_view line) const {
  Begun b;
  const std::size_t blank_at = line.find_last_of(" \t,(=");
  b.last = blank_at == std::string_view::npos ? line : line.substr(blank_at + 1);
  b.words = line_words(line.substr(0, line.size() - b.last.size()));
  if (!b.words.empty()) b.verb = b.words[0];
  const auto& sheet = state_->editor.now().script.left;
  b.row = sheet && !line.empty() && (indented(line) || starts_like_time(line[0]));
  b.in_list = b.row && !sheet->sheet.list.empty();
  Words all;
  if (b.last.find('.') != std::string_view::npos)
    functions(document().scene(), b.last, all);
  else if (b.verb == "filter" && b.words.size() == 2)
    filters(document().scene(), all);
  else if (b.verb == "save" || b.verb == "open" || b.verb == "use" || b.verb == "load")
    files(all);
  else
    names_and_words(document(), b, all);
  std::erase_if(all, [&](const std::string& w) { return !w.starts_with(b.last); });
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace betwixt

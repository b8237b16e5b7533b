// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The command `rename`: all references follow the new name, by number or by name, in code and in aliases.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/command.h"
#include "commands/following.h"
#include "commands/own_kinds.h"
#include "scene/names.h"

namespace betwixt {
namespace {

// The objects that a pattern in an alias matches. They stay in the alias under their new names.
struct Matched {
  std::string alias, pattern;
  std::vector<ObjectId> all;
};
std::vector<Matched> matched_by_patterns(const Scene& s, const std::vector<ObjectId>& of) {
  std::vector<Matched> out;
  for (const auto& [alias, elements] : *s.aliases)
    for (const std::string& e : elements) {
      if (!is_pattern(e)) continue;
      std::vector<ObjectId> all = select(s, e, of);
      if (!all.empty()) out.push_back({alias, e, std::move(all)});
    }
  return out;
}

void rename_in_aliases(Scene& s, const Following& names, const std::vector<Matched>& matched) {
  const Aliases before = *s.aliases;
  for (const auto& [alias, elements] : before)
    for (std::size_t i = 0; i < elements.size(); ++i)
      if (!is_pattern(elements[i]))
        if (std::string now = names.name(elements[i]); now != elements[i]) s.aliases.edit()[alias][i] = std::move(now);
  for (const Matched& m : matched) {
    std::vector<bool> named(s.objects.size());
    for (const ObjectId id : select(s, m.alias)) named[id.index] = true;
    std::vector<std::string> lost;
    for (const ObjectId id : m.all)
      if (!named[id.index]) lost.push_back(s.objects[id.index].name);
    if (lost.empty()) continue;
    auto& elements = s.aliases.edit()[m.alias];
    elements.insert(std::find(elements.begin(), elements.end(), m.pattern) + 1, lost.begin(), lost.end());
  }
}

// Renames references by name, also in code and in lists of environments.
void rename_in_values(Scene& s, const Following& names, const std::vector<std::uint32_t>& speaking) {
  for (std::size_t i = 0; i < s.procedures->size(); ++i)
    if (auto code = names.code((*s.procedures)[i].role, (*s.procedures)[i].code))
      s.procedures.edit()[i].code = std::move(code);
  for (std::size_t i = 0; i < s.defined->size(); ++i)
    if (auto now = names.value((*s.defined)[i].rest)) s.defined.edit().set_default(i, *std::move(now));
  for (const std::uint32_t i : speaking)
    if (names.concerns(s.objects[i])) names.apply(s.objects.edit(i));
}

// Renames an object and everything below it.
bool rename_whole(Command& k, ObjectId id, const std::string& name, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  const std::string old = s.objects[id.index].name;
  const Following names(old, name);
  std::vector<ObjectId> all = script.below(s, old, false);
  for (const ObjectId part : all)
    if (!free_name(k, names.name(s.objects[part.index].name), about)) return false;
  all.insert(all.begin(), id);
  if (all.size() > 1) script.touched = all.size();
  const std::vector<Matched> matched = matched_by_patterns(s, all);
  const std::vector<std::uint32_t> speaking = script.speakers(s, {id});
  for (const ObjectId one : all) s.names.erase(s.objects[one.index].name);
  for (const ObjectId one : all) {
    std::string& its = s.objects.edit(one.index).name;
    its = names.name(its);
    s.names.put(its, one);
  }
  rename_in_values(s, names, speaking);
  for (const ObjectId one : all)
    if (const Object& o = s.objects[one.index]; o.environment)
      rename_environment(s, old + o.name.substr(name.size()), o.name);
  rename_in_aliases(s, names, matched);
  return true;
}

bool rename(Command& k) {
  auto& [s, c, time, layer, script] = k;
  ObjectId id;
  c.space();
  if (!versions(s, c.peek_word()).empty()) return rename_list(k);
  if (is_pattern(c.peek_word()))
    return c.fail_here(ErrorCode::syntax, "only one object can be renamed, not a pattern", "as in rename ball planet");
  const char* start = c.at;
  if (!values(k).object(id) || !own(k, id, c.since(start))) return false;
  const std::string_view word = c.next_word();
  const std::string name(word);
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the new name is missing here");
  if (!free_name(k, name, word) || !finish(c)) return false;
  if (s.kinds->all.empty()) return rename_whole(k, id, name, word);
  Rollback whole(s);
  if (!rename_whole(k, id, name, word) || !no_circles(k, word)) return false;
  whole.keep();
  return true;
}

constexpr Verb renaming_rows[] = {
    {"rename", "rename OLD NEW",
     "Renames an object with everything below it, or a display list; all references follow.", "rename ball planet", 0,
     rename, "OBJECT; NEW"},
};

}  // namespace

std::span<const Verb> renaming_verbs() { return renaming_rows; }

}  // namespace betwixt

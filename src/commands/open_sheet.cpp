// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sheets that stay open while lines come one by one, possibly from several authors.
#include <algorithm>

#include "commands/script.h"

namespace betwixt {
namespace {

const Cow<DisplayList>* find_list(const DisplayLists& all, const std::string& name) {
  const auto at = all.find(name);
  return at == all.end() ? nullptr : &at->second;
}

bool same_list(const DisplayLists& a, const DisplayLists& b, const std::string& name) {
  const auto *x = find_list(a, name), *y = find_list(b, name);
  return x && y ? x->same(*y) : x == y;
}

// Returns whether all versions of the list are unchanged.
bool as_left(const Scene& s, const OpenSheet& left) {
  const std::string& name = left.sheet.list;
  if (!same_list(*s.lists, *left.lists, name)) return false;
  if (s.later_lists.same(left.later_lists)) return true;
  const LaterLists &is = *s.later_lists, &was = *left.later_lists;
  const auto holds = [&](const auto& later) { return find_list(later.second, name) != nullptr; };
  return std::count_if(is.begin(), is.end(), holds) == std::count_if(was.begin(), was.end(), holds) &&
         std::all_of(was.begin(), was.end(), [&](const auto& later) {
           const auto at = is.find(later.first);
           return !holds(later) || (at != is.end() && same_list(at->second, later.second, name));
         });
}

}  // namespace

void keep_shown(const Scene& s, Sheet& sheet) {
  if (s.main.empty() || sheet.list.empty() || !ever_calls(s, s.main, sheet.list)) return;
  sheet.before = s.lists, sheet.later_before = s.later_lists;
}

void find_tracks(Scene& s, Sheet& sheet) {
  sheet.tracks.clear();
  if (!sheet.on.spec) return;  // the pattern names nothing, so its rows are skipped
  for (const Target& t : sheet.on.targets)
    if (Track* track = edit_track(s, t)) sheet.tracks.push_back(track);
  if (sheet.tracks.size() != sheet.on.targets.size()) sheet.tracks.clear();
  sheet.fresh = !sheet.tracks.empty() && sheet.tracks[0]->events.empty();
}

std::shared_ptr<const OpenSheet> left_open(const Scene& s, const Script& script) {
  if (!script.sheet.open || script.sheet.broken) return nullptr;
  auto left = std::make_shared<OpenSheet>();
  left->opener = opener(s, script.sheet, script.margin());
  left->pattern = script.sheet.on.text;
  left->sheet = script.sheet;
  // Clear pointers into this line or this scene.
  left->sheet.tracks.clear(), left->sheet.spots.clear();
  left->sheet.place = {}, left->sheet.on.text = {}, left->sheet.on.spec = nullptr;
  left->sheet.before.reset(), left->sheet.later_before.reset();
  left->names = s.names, left->defined = s.defined, left->aliases = s.aliases;
  left->lists = s.lists, left->later_lists = s.later_lists;
  return left;
}

bool go_on(Scene& s, Script& script, const OpenSheet& left) {
  const bool list = !left.sheet.list.empty();
  if (list ? !as_left(s, left)
           : !s.names.same(left.names) || !s.defined.same(left.defined) || !s.aliases.same(left.aliases))
    return false;
  Sheet& sheet = script.sheet = left.sheet;
  keep_shown(s, sheet);
  sheet.changed = false;
  if (!sheet.on.targets.empty()) sheet.on.spec = &spec_of(s, sheet.on.targets[0].function);
  find_tracks(s, sheet);
  return true;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Commands on display lists: make, edit, delete, start. (Animation Imaging Model, 2.2.1, 3.3.3)
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/names.h"
#include "commands/command.h"
#include "commands/list_rows.h"

namespace betwixt {
namespace {

Time list_time(const Command& k) { return k.time.value_or(earliest_time); }

// Reads the name of a list that exists at the command's time or, without a time, at any time.
bool list_name(Command& k, std::string_view& word) {
  auto& [s, c, time, layer, script] = k;
  word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the name of a display list is missing here");
  if (time ? list_at(s, word, *time) != nullptr : !versions(s, word).empty()) return true;
  const std::string_view before(script.verb, static_cast<std::size_t>(word.data() - script.verb));
  if (const ObjectId id = s.names.find(word); id && versions(s, word).empty())
    return c.fail(ErrorCode::name,
                  fmt::format("'{}' is {}, not a display list", word, a_kind(s.objects[id.index].kind)), word,
                  before.starts_with("delete") ? fmt::format("to remove the object: remove {}", word)
                                               : "make NAME makes a display list; objects need no start");
  return c.fail(ErrorCode::name,
                fmt::format("there is no display list '{}'{}", word.substr(0, 60),
                            versions(s, word).empty() ? "" : " at that time"),
                word, did_you_mean(word, list_names(s)));
}

void open(Command& k, std::string_view word) {
  auto& [s, c, time, layer, script] = k;
  Sheet& sheet = script.sheet;
  sheet = {};
  sheet.open = true;
  sheet.list = word;
  sheet.place = word;
  sheet.from = time;
  for (const Time from : time ? std::vector{*time} : versions(s, word))
    sheet.versions.push_back({from, Sheet::at_end, {}, {}});
  keep_shown(s, sheet);
}

bool make(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  const std::string name(word);
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the name of the new display list is missing here");
  const bool known = !versions(s, name).empty();
  if (known && !time)
    return c.fail(ErrorCode::name, fmt::format("a display list '{}' already exists", name), word,
                  fmt::format("to add to it: edit {}", name));
  if ((!known && !free_name(k, name, word)) || !finish(c)) return false;
  Sheet was;
  was.list = name;
  keep_shown(s, was);
  edit_list(s, name, list_time(k)) = {};
  open(k, word);
  script.sheet.before = was.before, script.sheet.later_before = was.later_before;
  script.sheet.changed = known;  // its former contents are no longer shown
  return true;
}

bool edit(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  if (!list_name(k, word) || !finish(c)) return false;
  open(k, word);
  return true;
}

bool delete_it(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  if (!list_name(k, word) || !finish(c)) return false;
  const std::string name(word);
  delete_list(s, name, list_time(k));
  std::erase_if(script.unfinished,
                [&](const auto& u) { return u.first.first == name && (!k.time || u.first.second == *k.time); });
  std::vector<std::string> callers;
  for (const std::string_view other : list_names(s)) {
    const DisplayList* list = list_at(s, other, list_time(k));
    for (std::size_t i = 0; list && i < list->commands.size(); ++i)
      if (const DisplayCommand& command = list->commands[i];
          command.what == Drawing::call && *std::get<Text>(command.value) == name) {
        callers.push_back(fmt::format("'{}'", other));
        break;
      }
  }
  const char* since = time ? "from then on" : "now";
  if (!callers.empty())
    script.note(Severity::warning,
                fmt::format("{} still call{} '{}', which draws nothing {}", fmt::join(callers, ", "),
                            callers.size() == 1 ? "s" : "", name, since),
                word);
  const bool shown = !s.main.empty() && ever_calls(s, s.main, name);
  if (s.main == name) {
    script.note(Severity::warning,
                time ? fmt::format("'{}' is the main object, so from then on no display list is visible", name)
                     : fmt::format("'{}' was the main object, so now no display list is visible", name),
                word, time ? "" : "to show another one: start NAME");
    if (!time) s.main.clear();
  }
  if (shown) (void)expand(s);  // always possible: there are fewer objects
  return true;
}

// Fails if other objects have names that the list's drawing may need.
bool free_below(Command& k, std::string_view name, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  const std::string below = fmt::format("{}/", name);
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    if (const Object& o = s.objects[i]; !o.removed && !o.derived && o.name.starts_with(below))
      return c.fail(ErrorCode::name,
                    fmt::format("the display list '{}' may need the name of the object '{}'", name, o.name), about,
                    fmt::format("rename {} first", o.name));
  return true;
}

bool start(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  if (!list_name(k, word) || !finish(c) || !free_below(k, word, word)) return false;
  const std::string name(word);
  const std::string before = std::exchange(s.main, name);
  const Status done = expand(s);
  if (done) {
    for (const std::string_view other : script.live ? list_names(s) : std::vector<std::string_view>())
      for (const Time from : versions(s, other)) {  // in a script this is reported at the end
        const DisplayList& list = *list_at(s, other, from);
        const auto wrong = unbalanced(list);
        if (!wrong || !ever_calls(s, name, std::string(other))) continue;
        script.note(Severity::warning, fmt::format("in '{}': {}", other, without_half(list.commands[*wrong])), word);
        break;
      }
    return true;
  }
  s.main = before;
  return c.fail(done.error(), word);
}

constexpr Verb display_lists_rows[] = {
    {"make", "[at TIME] make LIST", "Opens a new display list; its commands are the indented rows below.",
     "make star\n  color gold\n  polygon (0 1) (-0.3 0) (0.3 0)\nstart star",
     Verb::timed | Verb::opens_sheet | Verb::makes_thing, make, "NEW"},
    {"edit", "[at TIME] edit LIST",
     "Opens a display list again: the indented rows below are added at its end; after `replace TAG` they replace the "
     "rows from that tag on, one by one.",
     "make star\n  tag first\n  color gold\nedit star\n  replace first\n  color red", Verb::timed | Verb::opens_sheet,
     edit},
    {"delete", "[at TIME] delete LIST", "Deletes a display list.", "make star\n  point (0 0)\ndelete star", Verb::timed,
     delete_it},
    {"start", "start LIST", "Shows a display list, as the main object, with all lists that it calls.",
     "make star\n  point (0 0)\nstart star", Verb::starts_show, start},
};

}  // namespace

// Runs `rename OLD NEW` where OLD is a display list.
bool rename_list(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view old;
  if (!list_name(k, old)) return false;
  const std::string_view word = c.next_word();
  if (word.empty()) return c.fail_here(ErrorCode::syntax, "the new name is missing here");
  const std::string from(old), to(word);
  if (!free_name(k, to, word) || !free_below(k, to, word) || !finish(c)) return false;
  rename_list(s, from, to);
  std::vector<decltype(script.unfinished)::value_type> open;
  for (auto& u : script.unfinished)
    if (u.first.first == from) open.emplace_back(std::pair(to, u.first.second), std::move(u.second));
  std::erase_if(script.unfinished, [&](const auto& u) { return u.first.first == from; });
  script.unfinished.insert(open.begin(), open.end());
  return true;
}

std::span<const Verb> display_lists_verbs() { return display_lists_rows; }

}  // namespace betwixt

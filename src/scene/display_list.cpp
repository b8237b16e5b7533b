// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/display_list.h"

#include <algorithm>
#include <unordered_set>

#include "scene/document.h"

namespace betwixt {

void DisplayCommands::put(std::size_t i, DisplayCommand command) {
  if (i < size_) {
    chunks_[i / chunk].edit()[i % chunk] = std::move(command);
    return;
  }
  if (size_ % chunk == 0) chunks_.emplace_back();
  chunks_.back().edit().push_back(std::move(command));
  ++size_;
}

namespace {

const std::string& name_in(const DisplayCommand& c) { return *std::get<Text>(c.value); }

template <class F>
void each_call(const DisplayList& list, F&& f) {
  for (std::size_t i = 0; i < list.commands.size(); ++i)
    if (list.commands[i].what == Drawing::call) f(name_in(list.commands[i]));
}

// Calls f for all versions of the lists, with the time of each.
template <class F>
void each_version(const Scene& s, F&& f) {
  for (const auto& [name, list] : *s.lists) f(earliest_time, name, *list);
  for (const auto& [from, changed] : *s.later_lists)
    for (const auto& [name, list] : changed) f(from, name, *list);
}

// Returns the path from one list to another; `calls_of` returns the calls of a list.
template <class F>
std::vector<std::string> way(const std::string& from, const std::string& to, F&& calls_of) {
  std::vector<std::pair<std::string_view, std::size_t>> steps{{from, 0}};  // and the step before
  std::unordered_set<std::string_view> seen{from};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (steps[i].first == to) {
      std::vector<std::string> names{to};
      for (std::size_t k = i; k != 0; k = steps[k].second) names.emplace_back(steps[steps[k].second].first);
      std::reverse(names.begin(), names.end());
      return names;
    }
    calls_of(steps[i].first, [&](const std::string& name) {
      if (seen.insert(name).second) steps.emplace_back(name, i);
    });
  }
  return {};
}

// Replaces a name in all commands of a kind; returns false if there is none.
bool respell(Scene& s, Drawing what, const std::string& old, const std::string& name) {
  struct Spoken {
    Time from;
    std::string in;
    std::size_t command;
  };
  std::vector<Spoken> all;
  each_version(s, [&](Time from, const std::string& in, const DisplayList& list) {
    for (std::size_t i = 0; i < list.commands.size(); ++i)
      if (list.commands[i].what == what && name_in(list.commands[i]) == old) all.push_back({from, in, i});
  });
  for (const Spoken& at : all) {
    DisplayCommands& commands = edit_list(s, at.in, at.from).commands;
    DisplayCommand command = commands[at.command];
    command.value = Text(name);
    commands.put(at.command, std::move(command));
  }
  return !all.empty();
}

}  // namespace

const DisplayList* list_at(const Scene& s, std::string_view name, Time t) {
  const auto there = [](const Cow<DisplayList>& list) { return list->there ? &*list : nullptr; };
  for (auto next = s.later_lists->upper_bound(t); next != s.later_lists->begin();) {
    --next;
    if (const auto at = next->second.find(name); at != next->second.end()) return there(at->second);
  }
  const auto at = s.lists->find(name);
  return at == s.lists->end() ? nullptr : there(at->second);
}

DisplayList& edit_list(Scene& s, const std::string& name, Time from) {
  if (from == earliest_time) return s.lists.edit()[name].edit();
  const DisplayList* before = list_at(s, name, from);
  const DisplayList copy = before ? *before : DisplayList{};
  const auto [at, fresh] = s.later_lists.edit()[from].try_emplace(name, copy);
  return at->second.edit();
}

std::vector<Time> versions(const Scene& s, std::string_view name) {
  std::vector<Time> all;
  if (s.lists->contains(name)) all.push_back(earliest_time);
  for (const auto& [from, changed] : *s.later_lists)
    if (const auto at = changed.find(name); at != changed.end() && at->second->there) all.push_back(from);
  return all;
}

std::vector<std::string_view> list_names(const Scene& s) {
  std::vector<std::string_view> all;
  each_version(s, [&](Time, const std::string& name, const DisplayList&) { all.push_back(name); });
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

void delete_list(Scene& s, const std::string& name, Time from) {
  if (from == earliest_time) s.lists.edit().erase(name);
  if (from == earliest_time && s.later_lists->empty()) return;
  LaterLists& later = s.later_lists.edit();
  if (from == earliest_time) {
    for (auto& [time, changed] : later) changed.erase(name);
  } else {
    DisplayList gone;
    gone.there = false;
    later[from][name] = Cow(std::move(gone));
    bool there = s.lists->contains(name);  // a list that does not exist is not deleted again
    for (auto& [time, changed] : later)
      if (const auto at = changed.find(name); at != changed.end()) {
        const bool stays = at->second->there;
        if (!stays && !there) changed.erase(at);
        there = stays;
      }
  }
  std::erase_if(later, [](const auto& at) { return at.second.empty(); });
}

void change(DisplayLists& lists, const DisplayLists& changed) {
  for (const auto& [name, list] : changed)
    if (list->there)
      lists[name] = list;
    else
      lists.erase(name);
}

std::vector<std::string> calls(const DisplayLists& lists, const std::string& from, const std::string& to) {
  return way(from, to, [&](std::string_view name, auto&& call) {
    if (const auto list = lists.find(name); list != lists.end()) each_call(*list->second, call);
  });
}

std::vector<std::string> calls(const Scene& s, const std::string& from, const std::string& to,
                               const std::vector<Time>& versions_of_to) {
  const auto meant = [&](Time t) {
    return std::find(versions_of_to.begin(), versions_of_to.end(), t) != versions_of_to.end();
  };
  bool looking = meant(earliest_time);
  if (looking)
    if (auto found = calls(*s.lists, from, to); !found.empty()) return found;
  if (s.later_lists->empty() && looking) return {};
  DisplayLists now = *s.lists;
  LaterLists later = *s.later_lists;
  for (const Time t : versions_of_to)  // a list that is only about to be made changes nothing yet
    if (t != earliest_time) later[t];
  for (const auto& [time, changed] : later) {
    change(now, changed);
    if (changed.contains(to) || meant(time)) looking = meant(time);
    if (looking)
      if (auto found = calls(now, from, to); !found.empty()) return found;
  }
  return {};
}

bool ever_calls(const Scene& s, const std::string& from, const std::string& to) {
  return !way(from, to, [&](std::string_view name, auto&& call) {
            if (const auto list = s.lists->find(name); list != s.lists->end()) each_call(*list->second, call);
            for (const auto& [time, changed] : *s.later_lists)
              if (const auto list = changed.find(name); list != changed.end()) each_call(*list->second, call);
          }).empty();
}

std::optional<std::size_t> unbalanced(const DisplayList& list) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < list.commands.size(); ++i) {
    const Drawing what = list.commands[i].what;
    if (what == Drawing::push || what == Drawing::begin) open.push_back(i);
    if (what != Drawing::pop && what != Drawing::end) continue;
    const Drawing opener = what == Drawing::pop ? Drawing::push : Drawing::begin;
    if (open.empty() || list.commands[open.back()].what != opener) return i;
    open.pop_back();
  }
  return open.empty() ? std::nullopt : std::optional(open.back());
}

void rename_environment(Scene& s, const std::string& old, const std::string& name) {
  if (respell(s, Drawing::begin, old, name)) expand_renamed(s);
}

void rename_list(Scene& s, const std::string& old, const std::string& name) {
  const auto move = [&](DisplayLists& lists) {
    if (auto list = lists.extract(old)) {
      list.key() = name;
      lists.insert(std::move(list));
    }
  };
  move(s.lists.edit());
  if (!s.later_lists->empty())
    for (auto& [from, changed] : s.later_lists.edit()) move(changed);
  respell(s, Drawing::call, old, name);
  if (s.main == old) s.main = name;
  expand_renamed(s);
}

}  // namespace betwixt

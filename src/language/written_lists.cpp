// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Display lists as text: their rows, and all versions of them as commands.
#include <algorithm>
#include <set>
#include <utility>

#include "language/values.h"
#include "scene/display_list.h"

namespace betwixt {
namespace {

// The rows that are written like values of these functions.
constexpr std::pair<Drawing, FunctionId> written_as[] = {
    {Drawing::text, fn::text},         {Drawing::color, fn::color},     {Drawing::texture, fn::texture},
    {Drawing::font, fn::font},         {Drawing::perspective, fn::fov}, {Drawing::orthographic, fn::camera_height},
    {Drawing::multiply, fn::transform}};

std::string write_row(const DisplayCommand& c) {
  const auto word = std::string(drawing_names[static_cast<std::size_t>(c.what)]);
  for (const auto& [what, f] : written_as)
    if (what == c.what) return word + " " + write_value(c.value, built_in_functions()[f], -1, {});
  switch (c.what) {
    case Drawing::point:
    case Drawing::vector:
    case Drawing::polygon: {
      std::string out = word;
      for (const Vec3& p : *std::get<Points>(c.value)) out += " " + write_vector(p, p.z == 0 ? 2 : 3);
      return out;
    }
    case Drawing::call:
      return word + " " + *std::get<Text>(c.value);
    case Drawing::begin:
      return word + " " + *std::get<Text>(c.value) + (c.since ? " since " + std::to_string(*c.since) + "t" : "");
    case Drawing::view: {
      const auto& ends = *std::get<Points>(c.value);
      return word + " from " + write_vector(ends[0]) + " to " + write_vector(ends[1]);
    }
    default:
      return word;
  }
}

// Writes called lists before their callers.
std::string called_first(const DisplayLists& meant, const DisplayLists& now, const std::string& make) {
  std::string out;
  std::set<std::string, std::less<>> written;
  std::vector<std::pair<const std::string*, bool>> todo;
  for (auto list = meant.rbegin(); list != meant.rend(); ++list) todo.push_back({&list->first, false});
  while (!todo.empty()) {
    const auto [name, called] = todo.back();
    todo.pop_back();
    const auto list = now.find(*name);
    if (list == now.end() || written.contains(*name)) continue;
    if (called) {
      written.insert(*name);
      if (meant.contains(*name)) out += make + *name + "\n" + write_rows(*list->second);
      continue;
    }
    todo.push_back({name, true});
    const DisplayCommands& commands = list->second->commands;
    for (std::size_t i = 0; i < commands.size(); ++i)
      if (commands[i].what == Drawing::call) todo.push_back({&*std::get<Text>(commands[i].value), false});
  }
  return out;
}

}  // namespace

std::string write_rows(const DisplayList& list) {
  std::string out;
  std::size_t depth = 1;
  const auto tags = [&](std::size_t i) {
    for (const auto& [tag, at] : list.tags)
      if (at == i) out += std::string(2 * depth, ' ') + "tag " + tag + "\n";
  };
  for (std::size_t i = 0; i < list.commands.size(); ++i) {
    const Drawing what = list.commands[i].what;
    if ((what == Drawing::pop || what == Drawing::end) && depth > 1) --depth;
    tags(i);
    out += std::string(2 * std::min<std::size_t>(depth, 40), ' ') + write_row(list.commands[i]) + "\n";
    if (what == Drawing::push || what == Drawing::begin) ++depth;
  }
  tags(list.commands.size());
  return out;
}

std::string write_lists(const Scene& s) {
  std::string out = called_first(*s.lists, *s.lists, "make ");
  DisplayLists now = *s.lists;
  for (const auto& [from, changed] : *s.later_lists) {
    change(now, changed);
    const std::string at = "at " + write_time(from, s.rate) + " ";
    out += called_first(changed, now, at + "make ");
    for (const auto& [name, list] : changed)
      if (!list->there) out += at + "delete " + name + "\n";
  }
  if (!s.main.empty()) out += "start " + s.main + "\n";
  return out;
}

}  // namespace betwixt

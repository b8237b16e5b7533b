// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the rows of display lists. (Animation Imaging Model, 2.2.1)
#include "commands/list_rows.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/memory_budget.h"
#include "base/names.h"
#include "commands/verbs.h"

namespace betwixt {
namespace {

// A command of a list while its row is read. `about`: its word.
struct Drawn {
  Command& k;
  std::string_view about;
  DisplayCommand command;
};

bool nothing(Drawn&) { return true; }

template <std::size_t least>
bool points(Drawn& d) {
  Cursor& c = d.k.cursor;
  std::vector<Vec3> list;
  while (!c.at_line_end()) {
    Vec3 p;
    if (!values(d.k).point(p)) return false;
    MemoryBudget::charge(sizeof p);
    list.push_back(p);
  }
  if (list.size() < least)
    return c.fail_here(ErrorCode::syntax,
                       least == 1 ? "a point (x y) or (x y z) is missing here"
                                  : fmt::format("expected at least {} points here, not {}", least, list.size()));
  d.command.value = Points(std::move(list));
  return true;
}

template <FunctionId f>
bool text(Drawn& d) {
  return values(d.k).value(spec_of(d.k.scene, f), -1, d.command.value, f);
}

bool color(Drawn& d) {
  Color color;
  if (!values(d.k).color(color)) return false;
  d.command.value = color;
  return true;
}

bool transform(Drawn& d) {
  Mat4 m;
  if (!values(d.k).transform(m)) return false;
  d.command.value = Matrix(m);
  return true;
}

bool name(Drawn& d, const char* of_what) {
  Cursor& c = d.k.cursor;
  const std::string_view word = c.next_word();
  if (!is_name(word))
    return c.fail(ErrorCode::syntax,
                  word.empty() ? fmt::format("the name of {} is missing here", of_what)
                               : fmt::format("'{}' cannot be a name", word.substr(0, 60)),
                  word.empty() ? std::string_view(c.at, 0) : word);
  d.command.value = Text(std::string(word));
  return true;
}

template <FunctionId f>
bool more_than_zero(Drawn& d) {
  Cursor& c = d.k.cursor;
  c.space();
  const char* start = c.at;
  FunctionSpec spec = spec_of(d.k.scene, f);
  spec.name = d.about;
  if (!values(d.k).value(spec, -1, d.command.value, f)) return false;
  return std::get<double>(d.command.value) > 0 ||
         c.fail(ErrorCode::range, "this must be greater than 0", c.since(start));
}

bool view(Drawn& d) {
  Cursor& c = d.k.cursor;
  std::vector<Vec3> ends(2);
  if (!c.accept_word("from")) return c.fail_here(ErrorCode::syntax, "'from' and a point are missing here");
  if (!values(d.k).point(ends[0])) return false;
  if (!c.accept_word("to")) return c.fail_here(ErrorCode::syntax, "'to' and a point are missing here");
  c.space();
  const char* start = c.at;
  if (!values(d.k).point(ends[1])) return false;
  if (ends[0] == ends[1]) return c.fail(ErrorCode::range, "a view needs two different points", c.since(start));
  d.command.value = Points(std::move(ends));
  return true;
}

std::string path(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, " → ")); }

bool callable(Command& k, const std::string& name) {
  auto& [s, c, time, layer, script] = k;
  const std::string& self = script.sheet.list;
  const std::string_view about(c.at - name.size(), name.size());
  std::vector<Time> into;
  for (const Sheet::Version& v : script.sheet.versions)
    if (!v.passed_over) into.push_back(v.from);
  if (const auto way = calls(s, name, self, into); !way.empty())
    return c.fail(ErrorCode::name,
                  name == self ? fmt::format("'{}' cannot call itself", self)
                               : fmt::format("this would make a cycle: {} → {}", self, path(way)),
                  about);
  if (!versions(s, name).empty()) return true;
  if (s.names.find(name))
    return c.fail(ErrorCode::type, fmt::format("'{}' is an object of the film, not a display list", name), about);
  script.note(Severity::warning,
              fmt::format("there is no display list '{}' yet, so this draws nothing until then", name), about,
              did_you_mean(name, list_names(s)));
  return true;
}

// The `begin` of a live host, or of an edit at a time, belongs to the environment that has the name then or that gets
// it next.
bool since(Command& k, DisplayCommand& command) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view behind(c.at, 0);  // the name; a comment may follow
  if (c.accept_word("since")) {
    Time t;
    if (!c.time(t)) return false;
    c.ticks_read = true;
    command.since = s.ticks.whole(t);
  } else if (script.sheet.from) {
    command.since = s.ticks.whole(*script.sheet.from);
  } else if (script.options.now) {
    c.ticks_read = true;
    command.since = tick(k);
    script.stamp(s, behind, " since ", "");
  }
  return true;
}

bool call(Drawn& d) { return name(d, "a display list") && callable(d.k, *std::get<Text>(d.command.value)); }
bool begin(Drawn& d) { return name(d, "an environment") && since(d.k, d.command); }

struct ReadRow {
  ListRow row;
  bool (*read)(Drawn&);  // nullptr for rows that say where later rows go
};
constexpr ReadRow rows[] = {
    {{"point", "point (x y z) …", "Draws points.", "make list\n  point (0 0) (1 0 0)"}, points<1>},
    {{"vector", "vector (x y z) (x y z) …", "Draws a line through points.", "make list\n  vector (0 0 0) (1 1 1)"},
     points<2>},
    {{"polygon", "polygon (x y z) (x y z) (x y z) …", "Draws a filled outline.",
      "make list\n  polygon (0 0) (2 0) (1 2)"},
     points<3>},
    {{"text", "text \"…\"", "Draws letters.", "make list\n  text \"Hello\""}, text<fn::text>},
    {{"color", "color COLOR", "The color of everything drawn from here on.", "make list\n  color gold\n  point (0 0)"},
     color},
    {{"texture", "texture \"FILE\"", "The texture of everything drawn from here on; \"\" is none.",
      "make list\n  texture \"\""},
     text<fn::texture>},
    {{"font", "font \"…\"", "The font of letters from here on.", "make list\n  font \"DejaVu Sans\"\n  text \"Hello\""},
     text<fn::font>},
    {{"push", "push", "Saves the matrix, until its pop.",
      "make list\n  push\n  translate(1 0 0)\n  point (0 0)\n  pop"},
     nothing},
    {{"pop", "pop", "Restores the matrix of the last push.", "make list\n  push\n  scale(2)\n  point (1 0)\n  pop"},
     nothing},
    {{"multiply", "multiply TRANSFORM, or the transform alone",
      "Transforms everything drawn from here on; the last transform is applied first.",
      "make list\n  multiply translate(1 0 0)\n  rotate(90deg, z)\n  point (1 0)"},
     transform},
    {{"call", "call NAME", "Draws another list: an instance, which keeps its matrices and colors to itself.",
      "make star\n  point (0 0)\nmake list\n  call star\n  translate(1 0 0)\n  call star"},
     call},
    {{"begin", "begin ENV [since TIME]",
      "Puts everything drawn from here on into an environment, until its end. `since`: into that which has the name at "
      "TIME, "
      "or gets it next.",
      "make list\n  begin wind\n  point (0 0)\n  end"},
     begin},
    {{"end", "end", "Ends the environment that was begun last.", "make list\n  begin wind\n  end"}, nothing},
    {{"view", "view from (x y z) to (x y z)",
      "The camera of the main list: its position, and the point that it looks at.",
      "make list\n  view from (0 2 9) to (0 0 0)"},
     view},
    {{"perspective", "perspective ANGLE", "The horizontal angle of view.", "make list\n  perspective 50deg"},
     more_than_zero<fn::fov>},
    {{"orthographic", "orthographic HEIGHT", "A view without perspective, with its height in metres.",
      "make list\n  orthographic 10"},
     more_than_zero<fn::camera_height>},
    {{"tag", "tag NAME", "Labels the next row, for replace.", "make list\n  tag place\n  translate(0 0 0)"}, nullptr},
    {{"replace", "replace TAG [OFFSET]",
      "The rows below replace those from a tag on, or from OFFSET rows behind it (before it, if less than 0).",
      "make list\n  tag place\n  translate(0 0 0)\nedit list\n  replace place\n  translate(1 0 0)"},
     nullptr},
};
static_assert(std::size(rows) == drawing_names.size() + 2);

constexpr std::string_view factors[] = {"translate", "rotate", "scale", "matrix"};

bool tag(Command& k) {
  auto& [s, c, time, layer, script] = k;
  std::string_view word;
  if (!new_name(c, word, "name")) return false;
  Sheet& sheet = script.sheet;
  for (const Sheet::Version& v : sheet.versions)
    if (!v.passed_over && list_at(s, sheet.list, v.from)->tags.contains(word))
      return c.fail(ErrorCode::name, fmt::format("the tag '{}' already exists in '{}'", word, sheet.list), word);
  if (!finish(c)) return false;
  for (const Sheet::Version& v : sheet.versions) {
    if (v.passed_over) continue;
    DisplayList& list = edit_list(s, sheet.list, v.from);
    list.tags[std::string(word)] = std::min(v.next, list.commands.size());
  }
  return true;
}

// Selects the rows to replace. Skips versions without the tag, and versions with too few rows after it.
bool replace(Command& k) {
  auto& [s, c, time, layer, script] = k;
  const std::string_view word = c.next_word();
  Sheet& sheet = script.sheet;
  std::vector<Sheet::Version> versions = sheet.versions;
  long least = 0, most = -1;
  std::vector<std::string_view> known;
  for (Sheet::Version& v : versions) {
    const DisplayList& list = *list_at(s, sheet.list, v.from);
    for (const auto& tag : list.tags) known.push_back(tag.first);
    const auto at = list.tags.find(word);
    v.passed_over = at == list.tags.end();
    if (v.passed_over) continue;
    v.next = at->second;
    least = std::min(least, -static_cast<long>(v.next));
    most = std::max(most, static_cast<long>(list.commands.size()) - static_cast<long>(v.next));
  }
  if (most < 0)
    return c.fail(ErrorCode::name,
                  word.empty() ? "a tag is missing here"
                               : fmt::format("there is no tag '{}' in '{}'", word.substr(0, 60), sheet.list),
                  word.empty() ? std::string_view(c.at, 0) : word, did_you_mean(word, known));
  long offset = 0;
  if (!c.at_line_end() && (!c.whole_number(least, most, "an offset", offset) || !finish(c))) return false;
  for (Sheet::Version& v : versions) {
    if (v.passed_over) continue;
    const long next = static_cast<long>(v.next) + offset;
    v.passed_over = next < 0 || next > static_cast<long>(list_at(s, sheet.list, v.from)->commands.size());
    v.next = static_cast<std::size_t>(next);
  }
  sheet.versions = std::move(versions);
  sheet.tag = word;
  return true;
}

// Reads one command of the list and puts it at the end, or in place of another, in all versions that receive the rows.
bool draw(Command& k, std::size_t index, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  Drawn d{k, about, {}};
  d.command.what = static_cast<Drawing>(index);
  if (!rows[index].read(d) || !finish(c) || !in_order(k, d.command, about)) return false;
  Sheet& sheet = script.sheet;
  for (Sheet::Version& v : sheet.versions) {
    if (v.passed_over) continue;
    DisplayCommands& commands = edit_list(s, sheet.list, v.from).commands;
    const std::size_t place = std::min(v.next, commands.size());
    if (&v == &sheet.versions[0]) {
      if (sheet.spots.size() <= place) sheet.spots.resize(place + 1);
      sheet.spots[place] = about;
    }
    commands.put(place, d.command);
    if (v.next != Sheet::at_end) ++v.next;
  }
  sheet.changed = true;
  return true;
}

bool no_row(Command& k, std::string_view word) {
  std::vector<std::string_view> words(std::begin(factors), std::end(factors));
  for (const ReadRow& r : rows) words.push_back(r.row.word);
  Hint hint = did_you_mean(word, words);
  if (hint.empty()) hint = "drawing rows are point, vector, polygon, text and call; for all rows: help make";
  if (!versions(k.scene, word).empty()) hint = fmt::format("to draw that list: call {}", word.substr(0, 40));
  if (find_verb(word)) hint = "a command that follows a display list is not indented";
  Cursor& c = k.cursor;
  return c.fail_here(ErrorCode::name,
                     word.empty()
                         ? fmt::format("a row of a display list must begin with a word, not with '{}'", c.peek())
                         : fmt::format("there is no row '{}' in display lists", word.substr(0, 40)),
                     hint);
}

}  // namespace

std::span<const ListRow> list_rows() {
  static const auto all = [] {
    std::array<ListRow, std::size(rows)> only;
    std::transform(std::begin(rows), std::end(rows), only.begin(), [](const ReadRow& r) { return r.row; });
    return only;
  }();
  return all;
}

bool list_row(Command& k) {
  Cursor& c = k.cursor;
  c.space();
  const std::string_view word = c.peek_word();
  const bool factor = std::find(std::begin(factors), std::end(factors), word) != std::end(factors);
  const auto at = std::find_if(std::begin(rows), std::end(rows),
                               [&](const ReadRow& r) { return r.row.word == (factor ? "multiply" : word); });
  if (at == std::end(rows)) return no_row(k, word);
  if (!factor) c.word();
  const bool done = at->read                ? draw(k, static_cast<std::size_t>(at - rows), word)
                    : at->row.word == "tag" ? tag(k)
                                            : replace(k);
  if (!done && c.error && c.error->hint.empty() && c.error->code == ErrorCode::syntax)
    c.error->hint = fmt::format("usage: {}", at->row.usage);
  return done;
}

}  // namespace betwixt

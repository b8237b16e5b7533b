// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sheet of a display list: its open commands, and the work at the end of its rows.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "commands/list_rows.h"

namespace betwixt {
namespace {

std::string said(const DisplayCommand& c) {
  const auto* name = std::get_if<Text>(&c.value);
  const auto word = drawing_names[static_cast<std::size_t>(c.what)];
  return name && c.what != Drawing::text ? fmt::format("{} {}", word, **name) : std::string(word);
}

// Returns the commands that are open at the end of the list, as far as they match.
std::vector<Drawing> nested(const DisplayList& list) {
  std::vector<Drawing> open;
  for (std::size_t i = 0; i < list.commands.size(); ++i) {
    const Drawing what = list.commands[i].what;
    if (what == Drawing::push || what == Drawing::begin) open.push_back(what);
    if ((what == Drawing::pop || what == Drawing::end) && !open.empty()) open.pop_back();
  }
  return open;
}

}  // namespace

// Returns the message for a command whose other half is missing.
std::string without_half(const DisplayCommand& c) {
  const bool closes = c.what == Drawing::pop || c.what == Drawing::end;
  const bool stack = c.what == Drawing::pop || c.what == Drawing::push;
  return closes ? fmt::format("this '{}' has no '{}' before it", said(c), stack ? "push" : "begin")
                : fmt::format("the '{}' of this '{}' is missing", stack ? "pop" : "end", said(c));
}

// Fails if a command at the end of the list does not match the commands before it. A command inserted in between may be
// completed later.
bool in_order(Command& k, const DisplayCommand& command, std::string_view about) {
  auto& [s, c, time, layer, script] = k;
  const bool closes = command.what == Drawing::pop || command.what == Drawing::end;
  const bool opens = command.what == Drawing::push || command.what == Drawing::begin;
  const Drawing opener = command.what == Drawing::pop ? Drawing::push : Drawing::begin;
  std::vector<Sheet::Version> versions = script.sheet.versions;
  for (Sheet::Version& v : versions) {
    if (v.passed_over) continue;
    const DisplayList& list = *list_at(s, script.sheet.list, v.from);
    if (v.next < list.commands.size()) {
      v.nested.reset();
      continue;
    }
    if (!v.nested) v.nested = nested(list);
    if (closes && (v.nested->empty() || v.nested->back() != opener))
      return c.fail(ErrorCode::syntax, without_half(command), about,
                    v.nested->empty() ? ""
                                      : fmt::format("the last one that was opened is a '{}'",
                                                    drawing_names[static_cast<std::size_t>(v.nested->back())]));
    if (closes) v.nested->pop_back();
    if (opens) v.nested->push_back(command.what);
  }
  script.sheet.versions = std::move(versions);
  return true;
}

// Returns the lines that must precede rows that come alone.
std::string opener(const Scene& s, const Sheet& sheet, std::size_t margin) {
  if (sheet.list.empty()) return sheet.opener;
  const std::string edit =
      std::string(margin, ' ') + (sheet.from ? "at " + write_seconds(*sheet.from) + " " : "") + "edit " + sheet.list;
  const auto v = std::find_if(sheet.versions.begin(), sheet.versions.end(),
                              [](const Sheet::Version& each) { return !each.passed_over; });
  if (v->next == Sheet::at_end) return edit;
  const auto offset =
      static_cast<long>(v->next) - static_cast<long>(list_at(s, sheet.list, v->from)->tags.find(sheet.tag)->second);
  return fmt::format("{}\n{:{}}replace {} {}", edit, "", margin + 2, sheet.tag, offset);
}

namespace {

// Expands the list again where it is shown.
void show(Scene& s, Script& script, const std::string& name) {
  const Sheet& sheet = script.sheet;
  if (!sheet.changed || s.main.empty() || !ever_calls(s, s.main, name)) return;
  script.unshown.push_back({sheet.before, sheet.later_before, sheet.place});
}

}  // namespace

// Ends the rows of a display list and expands it where it is shown.
void close_list(Scene& s, Script& script) {
  Sheet& sheet = script.sheet;
  if (sheet.list.empty()) return;
  const std::string name = std::exchange(sheet.list, {});
  for (const Sheet::Version& v : sheet.versions) {
    script.unfinished.erase({name, v.from});
    const DisplayList& list = *list_at(s, name, v.from);
    const auto wrong = script.live ? std::nullopt : unbalanced(list);
    if (!wrong) continue;
    const DisplayCommand& command = list.commands[*wrong];
    const bool here = &v == &sheet.versions[0] && *wrong < sheet.spots.size();
    const std::string_view spot = here ? sheet.spots[*wrong] : std::string_view();
    auto d = script.withheld(
        Severity::error, spot.data() ? without_half(command) : fmt::format("in '{}': {}", name, without_half(command)),
        spot.data() ? spot : sheet.place);
    if (d) script.unfinished[{name, v.from}] = *std::move(d);  // later rows may still complete it
  }
  show(s, script, name);
}

void show_list(Scene& s, Script& script) {
  Sheet& sheet = script.sheet;
  if (!sheet.open || sheet.list.empty()) return;
  show(s, script, sheet.list);
  show_lists(s, script);
}

// If the expansion is too large, drops the rows of the first sheet that made it so, and those of all later sheets.
void show_lists(Scene& s, Script& script) {
  const auto sheets = std::exchange(script.unshown, {});
  if (sheets.empty()) return;
  Status done = expand(s);
  if (done) return;
  // Finds, by bisection, the number of sheets that can be expanded.
  std::size_t possible = 0, impossible = sheets.size();
  while (impossible - possible > 1) {
    const std::size_t half = (possible + impossible) / 2;
    s.lists = sheets[half].before, s.later_lists = sheets[half].later_before;
    if (const Status then = expand(s); then)
      possible = half;
    else
      impossible = half, done = then;
  }
  s.lists = sheets[possible].before, s.later_lists = sheets[possible].later_before;
  (void)expand(s);  // cannot fail: it has succeeded before
  script.report(Severity::error, done.error(), sheets[possible].place);
}

void say_unfinished_lists(Script& script) {
  std::vector<Diagnostic> all;
  for (auto& [name, what] : script.unfinished) all.push_back(std::move(what));
  script.unfinished.clear();
  std::stable_sort(all.begin(), all.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.what.place.line < b.what.place.line; });
  for (Diagnostic& d : all) script.diagnostics.push_back(std::move(d));
}

}  // namespace betwixt

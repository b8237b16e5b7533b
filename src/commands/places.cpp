// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Patterns replace loops. A command whose formulas mention i, the place among the objects that its pattern names, runs
// once for each of them.
#include <unordered_map>

#include "base/cancellation.h"
#include "base/names.h"
#include "commands/command.h"
#include "commands/line_head.h"
#include "language/code_names.h"
#include "language/formula.h"
#include "language/table_formulas.h"
#include "scene/rollback.h"

namespace betwixt {
namespace {

bool speaks_of_any(std::string_view text) { return speaks_of_place(text.data(), text.data() + text.size()); }

// The pattern that a line is about, such as a* in `at T on L move a* …`.
struct LineSubject {
  std::string_view pattern;
  bool creates = false, fills = false;
  bool placed = false;  // the time or the words after the pattern mention a place; the `n` in a name does not count
  bool paired = false;  // names written out by braces after the pattern pair with the pattern's objects
};
LineSubject subject(std::string_view line) {
  const LineHead head = line_head(line);
  const std::string_view rest = between((head.verb ? head.rest : head.name).data(), line.data() + line.size());
  LineSubject out;
  out.pattern = head.verb ? head.name : head.word;
  out.creates = head.word == "create", out.fills = head.word == "fill";
  out.placed = speaks_of_any(head.time) || speaks_of_any(rest);
  out.paired = is_pattern(out.pattern) && writes_out_names(rest);
  return out;
}

// Returns how many braces the pattern has before the first that names a table.
std::size_t ranges_before_table(const Tables& tables, std::string_view pattern) {
  std::size_t count = 0;
  for (std::size_t open = pattern.find('{'); open != pattern.npos; open = pattern.find('{', open + 1), ++count)
    if (const auto close = pattern.find('}', open); close != pattern.npos)
      if (table_of(tables, pattern.substr(open, close + 1 - open))) return count;
  return count;
}

// Returns the place of each of the names: among all of them, and in the ranges that the pattern has in braces.
std::vector<PatternPlace> places(const Tables& tables, const std::vector<std::string>& names, std::string_view said) {
  std::vector<PatternPlace> out(names.size());
  const std::string pattern = with_keys(tables, said);
  const auto table = table_of(tables, said);
  const std::size_t table_range = table ? ranges_before_table(tables, said) : 0;
  const auto sizes = brace_ranges(pattern);
  std::vector<std::string> all;
  if (!sizes.empty())
    if (auto expanded = expand_braces(pattern)) all = *std::move(expanded);
  std::unordered_map<std::string_view, std::size_t> place;  // of each name, its first
  if (names.size() != all.size())
    for (std::size_t k = 0; k < all.size(); ++k) place.emplace(all[k], k);
  for (std::size_t k = 0; k < names.size(); ++k) {
    out[k].i = k + 1, out[k].n = names.size();
    std::size_t at = k;
    if (names.size() != all.size()) {
      const auto found = place.find(names[k]);
      if (found == place.end()) continue;
      at = found->second;
    }
    for (std::size_t r = sizes.size(); r-- > 0; at /= sizes[r]) {
      if (r < out[k].ranges.size()) out[k].ranges[r] = at % sizes[r] + 1;
      if (table && r == table_range)
        out[k].table = table.get(), out[k].row = table->first[at % sizes[r]], out[k].over = table->over;
    }
  }
  return out;
}

struct Alone {  // ends the single runs on every way out
  Command& k;
  explicit Alone(Command& command) : k(command) {}
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;
  ~Alone() { k.script.only.reset(), k.cursor.place = {}; }
};

// Returns whether the line reads cells of a table.
bool reads_cells(const Command& k, const char* from) {
  return !k.scene.tables->empty() && first_table(*k.scene.tables, from, k.cursor.end);
}

bool says_place(const Command& k, const char* from, bool formula = false) {
  if (reads_cells(k, from)) return true;
  if (writes_out_names(between(from, k.cursor.end))) return true;
  return speaks_of_place(from, k.cursor.end) || code_speaks_of_place(from, k.cursor.end, formula);
}

}  // namespace

std::vector<ObjectId> named(Command& k, std::string_view pattern) {
  auto& only = k.script.only;
  if (only && !std::exchange(only->met, true)) return {only->object};
  auto all = select(k.scene, pattern);
  if (!k.script.only && k.script.touched == 0 && all.size() > 1) k.script.touched = all.size();
  return all;
}

bool in_places(Command& k, const std::function<bool()>& command) {
  const char* const start = k.cursor.at;
  if (k.script.only || !says_place(k, start)) return command();
  const LogicalLine line = logical_line(between(start, k.cursor.end));
  const LineSubject about = subject({start, static_cast<std::size_t>(line.end - start)});
  const bool cells = reads_cells(k, start) && table_of(*k.scene.tables, about.pattern) && !about.fills;
  if (!about.placed && !about.paired && !cells && !code_speaks_of_place(start, k.cursor.end)) return command();
  const std::string_view pattern = about.pattern.substr(0, first_dot(about.pattern));
  std::vector<std::string> names;
  std::vector<ObjectId> objects;
  if (about.creates) {
    if (auto expanded = expand_braces(with_keys(*k.scene.tables, pattern))) names = *std::move(expanded);
  } else {
    objects = select(k.scene, pattern);
    for (const ObjectId id : objects) names.push_back(k.scene.objects[id.index].name);
  }
  if (names.empty()) return command();  // reports the error
  if (names.size() > 1) k.script.touched = names.size();
  const std::vector<PatternPlace> all = places(*k.scene.tables, names, pattern);
  const Alone alone(k);
  Rollback rollback(k.scene);
  for (std::size_t i = 0; i < names.size(); ++i) {
    Cancellation::check();
    k.cursor.at = start, k.cursor.depth = 0;
    k.cursor.place = all[i];
    k.script.only = {about.creates ? ObjectId{} : objects[i], names[i], false};
    if (!command()) return false;
  }
  rollback.keep();
  return true;
}

bool in_places(Command& k, const Selected& of, const std::function<bool(const Selected&)>& row) {
  const char* const start = k.cursor.at;
  Sheet& sheet = k.script.sheet;
  const std::vector<Time> above = std::exchange(sheet.each_above, {});
  const bool apart = !above.empty() && (k.cursor.space(), k.cursor.peek() == '+');
  const bool formula = of.spec && of.spec->written == "\"FORMULA\"";
  if (!apart && !says_place(k, start, formula)) return row(of);
  std::vector<Selected> each;
  std::vector<std::string> names;
  for (const Target& t : of.targets) {
    if (each.empty() || each.back().targets[0].object != t.object) {
      each.push_back({{}, of.spec, of.component, of.text, of.velocity});
      names.push_back(k.scene.objects[t.object.index].name);
    }
    each.back().targets.push_back(t);
  }
  if (each.empty()) return row(of);
  const std::vector<PatternPlace> all = places(*k.scene.tables, names, of.text.substr(0, first_dot(of.text)));
  const Alone alone(k);
  const std::optional<Time> before = sheet.above;
  bool done = true;
  {
    Rollback rollback(k.scene);
    for (std::size_t i = 0; done && i < each.size(); ++i) {
      Cancellation::check();
      k.cursor.at = start, k.cursor.depth = 0;
      k.cursor.place = all[i];
      sheet.above = above.size() == each.size() ? above[i] : before;
      done = row(each[i]);
      sheet.each_above.push_back(sheet.above.value_or(Time{}));
    }
    if (done) rollback.keep();
  }
  find_tracks(k.scene, sheet);  // the single runs have replaced them
  return done;
}

}  // namespace betwixt

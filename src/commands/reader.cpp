// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/cancellation.h"
#include "base/memory_budget.h"
#include "base/names.h"
#include "base/utf8.h"
#include "base/work_progress.h"
#include "commands/foreign_words.h"
#include "commands/given_lets.h"
#include "commands/line_head.h"
#include "commands/lint.h"
#include "commands/list_rows.h"
#include "commands/own_kinds.h"
#include "commands/parts.h"
#include "commands/plain_rows.h"
#include "commands/translating.h"
#include "commands/verbs.h"
#include "language/formula.h"
#include "language/moments.h"
#include "syntax/tokens.h"

namespace betwixt {
namespace {

bool open_sheet(Command& k, std::string_view word) {
  auto& [s, c, time, layer, script] = k;
  Selected on;
  if (!targets(k, word, on)) return false;
  if (!c.at_line_end())
    return c.fail_here(
        ErrorCode::syntax, "a target that opens a sheet must be alone on its line",
        fmt::format(
            "write its rows below, indented; for one event write at TIME {0} VALUE, for the whole film set {0} VALUE",
            word));
  Sheet& sheet = script.sheet;
  sheet = {};
  sheet.open = true;
  sheet.on = std::move(on);
  find_tracks(s, sheet);
  return true;
}

// Reports that there is no such command, and suggests similar words.
bool no_command(Command& k, std::string_view w, const char* start) {
  auto& [s, c, time, layer, script] = k;
  const auto fail = [&](ErrorCode code, std::string message, Hint hint = {}) {
    return k.cursor.fail(code, std::move(message), w, std::move(hint));
  };
  const std::string said(w.substr(0, 40));
  if (starts_like_time(w[0]) || moment_length(between(start, c.end)) > 0)
    return c.fail(ErrorCode::syntax, "this looks like a row, but no sheet is open", {start, w.size()},
                  "rows are indented below a line with only a target, as in ball.position");
  if (const auto why = not_of_a_script(w); !why.empty())
    return fail(ErrorCode::name, fmt::format("'{}' {}", w, why),
                w == "load" ? "load it when you show the film: betwixt play --load PLUGIN FILE" : "");
  if (c.at_line_end() && !time) script.sheet.open = script.sheet.broken = true;  // probably meant as a target
  if (s.names.find(w))
    return fail(ErrorCode::name, fmt::format("'{}' is an object, not a command", said),
                fmt::format("to open a sheet, write a target, as in {}.position", said));
  for (const ListRow& row : list_rows())
    if (row.word == w && !time)
      return fail(ErrorCode::name, fmt::format("'{}' is a row of a display list, not a command", w),
                  "rows are indented, below make NAME or edit NAME");
  if (w.starts_with("//") || w.starts_with(";"))
    return fail(ErrorCode::syntax, "a comment starts with '#' and a space");
  const std::string message = fmt::format("there is no command '{}'", said);
  c.space();
  if (c.peek() == '=') return fail(ErrorCode::name, message, fmt::format("to name many objects: alias {} = …", said));
  if (const std::string_view leads = foreign_word_hint(w); !leads.empty())
    return fail(ErrorCode::name, message, std::string(leads));
  std::vector<std::string_view> words = verb_words();
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == Role::command) words.push_back(p.name);
  return fail(ErrorCode::name, message, did_you_mean(w, words));
}

// Reads +12f: a time relative to the row above.
bool since_row_above(Command& k, Time& out) {
  Cursor& c = k.cursor;
  const char* const start = c.at;
  Time later;
  if (!c.length(later)) return false;
  if (!k.script.sheet.above)
    return c.fail(ErrorCode::syntax, "a time with '+' needs a row above it", c.since(start),
                  "write the time of the first row, as in 12f");
  out = *k.script.sheet.above + later;
  c.last = out;
  return c.reaches(out), true;
}

bool row_of(Command& k, const Selected& on) {
  auto& [s, c, time, layer, script] = k;
  Sheet& sheet = script.sheet;
  Time from;
  c.space();
  if (!starts_like_time(c.peek()) && !formula_begins(c) && !section_time_begins(c.at, c.end))
    return c.fail_here(ErrorCode::syntax,
                       fmt::format("a row must begin with a time, not with '{}'",
                                   c.peek_word().empty() ? std::string_view(c.at, 1) : c.peek_word()),
                       "a command that follows a sheet is not indented");
  const char* const start = c.at;
  std::optional<Time> until;
  if (c.peek() == '+') {
    if (!since_row_above(k, from)) return false;
  } else if (!time_or_segment(c, from, until)) {
    return false;
  }
  sheet.above = until.value_or(from);
  const std::string_view times = c.since(start);
  c.space();
  if (until && goes_along(c)) return along_line(k, on, from, until) && finish(c);
  if (until && on.type() != Type::motion) return one_time_only(c, times);
  return (until ? moving(k, on, from, until) : event(k, on, from)) && finish(c);
}

bool row(Command& k) {
  const Sheet& sheet = k.script.sheet;
  if (!sheet.list.empty()) return list_row(k);
  if (!sheet.on.spec) return pass_over(k, k.cursor.at);
  return in_places(k, sheet.on, [&](const Selected& on) { return row_of(k, on); });
}

// Runs one logical line. Returns false if it failed.
bool line(Command& k, const char* line_start) {
  auto& [s, c, time, layer, script] = k;
  if (c.at_line_end()) return true;
  Sheet& sheet = script.sheet;
  const auto indent = static_cast<std::size_t>(c.at - line_start);
  if (script.leave_blocks(indent))
    return c.fail(ErrorCode::syntax, "this line is indented less than the lines of the block above it",
                  {line_start, indent}, "indent it as they are, or not at all");
  if (!script.blocks.empty() && script.blocks.back().skipped) return pass_over(k, line_start);
  if (!script.blocks.empty() && !script.blocks.back().part.empty()) return take_part_line(k, line_start);
  c.clock = script.clock_now();
  if (indent > script.margin() && sheet.open) {
    if (!sheet.broken) return row(k);
    return pass_over(k, line_start);
  }
  close_list(s, script);
  sheet.open = false;
  follow_models(s, script, {line_start, 0});  // for the rows above
  const bool done = in_places(k, [&] { return carry_out(k); });
  if (!sheet.open) follow_models(s, script, {line_start, 0});
  if (sheet.open) sheet.opener = {line_start, c.at};
  return done;
}

// Returns the name that begins here, up to a '/' in it, or "" if none does.
std::string_view name_at(const char* from, const char* end) {
  std::size_t length = 0;
  if (from != nullptr)
    while (from + length < end && is_name({from, length + 1})) ++length;
  return {from, length};
}

// Returns whether an error follows from an earlier line that failed: it is about a name that the line should have made,
// about an object below it, or its marked word is such a name (a missing `let` name is reported as an invalid number).
bool follows(const Script& script, const Error& e, const Cursor& c) {
  if (script.failed.empty() && !script.file_missing) return false;
  const std::string_view missed = name_missed(e);
  const auto failed = [&](std::string_view name) { return script.failed.contains(name); };
  const std::vector<std::string_view> above = with_those_above(missed);
  return (script.file_missing && !missed.empty()) || std::any_of(above.begin(), above.end(), failed) ||
         failed(name_at(c.where.data(), c.end));
}

// Reports the error of the line that began there. Reading continues after the line.
void complain(Scene& s, Cursor& c, Script& script, const char* line_start) {
  Error e = c.error.value_or(fail(ErrorCode::syntax, "this command failed"));
  const LogicalLine one = logical_line(between(line_start, c.end));
  const char* next = one.next(c.end);
  // An unclosed bracket is the cause, not the words that the lines below seem to lack.
  if (one.depth > 0 && c.depth > 0 && c.where.data() >= next) {
    e = fail(ErrorCode::syntax, "this bracket is never closed");
    c.where = {c.brackets[std::min(static_cast<std::size_t>(c.depth), c.brackets.size()) - 1], 1};
  }
  const std::string_view whole(line_start, static_cast<std::size_t>(one.end - line_start));
  const bool followed = !script.live && follows(script, e, c);
  const bool ignored = e.code == ErrorCode::type && s.policy == Policy::ignore;
  if (ignored) e.message = "ignored: " + e.message;
  for (std::string& name : ignored ? std::vector<std::string>() : names_missed(s, whole))
    script.failed.insert(std::move(name));
  script.file_missing |= Cursor(whole).next_word() == "use";
  if (!followed) script.report(ignored ? Severity::warning : Severity::error, std::move(e), c.where);
  c.at = next;
}

// Reports the number of objects that a command was about.
void say_touched(Script& script, const char* line_start) {
  if (script.touched > 1) script.note(Severity::notice, fmt::format("{} objects", script.touched), {line_start, 0});
}

// Runs one logical line. A line that would make too much fails; what it has changed is not kept by its caller.
bool line_within_limits(Command& k, const char* line_start, bool& too_much) {
  try {
    return line(k, line_start);
  } catch (const OverBudget& limit) {
    too_much = true;
    const Error e = too_many_bytes(limit.most);
    return k.cursor.fail(e, Cursor(between(line_start, k.cursor.end)).next_word());
  }
}

void run(Scene& s, Script& script, std::size_t from = 0) {
  Cursor c(script.source.text);
  c.at += from;
  c.latest = earliest_time;
  const SectionTimes sections = [&](std::string_view name, bool end) { return section_time(s, script, name, end); };
  c.sections = &sections;
  const bool author = script.open_files.size() < 2;  // a used file counts as one line of it
  const std::size_t size = script.source.text.size();
  while (c.at < c.end && !script.given_up) {
    Cancellation::check();
    if (author) WorkProgress::report(size - static_cast<std::size_t>(c.end - c.at), size);
    const char* line_start = c.at;
    const char* p = c.at;
    while (p < c.end && blank(*p)) ++p;
    if (p < c.end && *p == '\n') {
      c.at = p + 1;
      continue;
    }
    c.rate = s.rate, c.ticks = s.ticks, c.lets = &*s.lets, c.tables = &*s.tables, c.moments = &s;
    c.clock = script.clock_now(), c.last.reset(), script.latest = earliest_time;
    c.frames_read = script.frames_read, c.ticks_read = script.ticks_read;
    c.depth = 0;
    Command k{s, c, {}, {}, script};
    script.touched = 0;
    if (p > line_start && !(script.watch && script.depth == 0) && plain_rows(k)) {
      script.frames_read = c.frames_read, script.ticks_read = c.ticks_read;
      if (!script.blocks.empty()) grow_section(s, script, c.latest);
      continue;
    }
    bool too_much = false;
    const bool done = line_within_limits(k, line_start, too_much);
    c.reaches(script.latest);
    if (done && !script.blocks.empty()) grow_section(s, script, c.latest);
    if (done && script.options.counts) say_touched(script, p);
    if (done && script.watch && script.depth == 0) script.watch->look(s, script.source, between(line_start, c.at));
    if (done && !script.failed.empty())  // its names exist now
      for (const std::string& name : names_made(between(line_start, c.at))) script.failed.erase(name);
    script.frames_read = c.frames_read, script.ticks_read = c.ticks_read;
    if (!done) {
      complain(s, c, script, line_start);
      c.error.reset(), c.where = {};
      script.given_up |= too_much;  // no later line could make anything
    } else if (c.at < c.end && *c.at == '\n') {
      ++c.at;
    }
  }
  script.latest = c.latest;
}

}  // namespace

bool finish(Cursor& c) {
  if (c.at_line_end()) return true;
  const std::string_view w = c.peek_word();
  return c.fail_here(ErrorCode::syntax, w.empty() ? "nothing more is expected here"
                                                  : fmt::format("'{}' is not expected here", w.substr(0, 40)));
}

bool no_choice(Cursor& c, std::string_view word, std::string message, Hint hint) {
  if (word.empty()) return c.fail_here(ErrorCode::syntax, std::move(message), std::move(hint));
  return c.fail(ErrorCode::type, std::move(message), word, std::move(hint));
}

bool on_or_off(Cursor& c, const char* otherwise, bool& out) {
  const std::string_view w = c.next_word();
  if (w != "on" && w != "off") return no_choice(c, w, otherwise);
  if (!finish(c)) return false;
  out = w == "on";
  return true;
}

bool pass_over(Command& k, const char* from) {
  k.cursor.at = logical_line(between(from, k.cursor.end)).end;
  return true;
}

std::string_view not_of_a_script(std::string_view word) {
  if (word == "load") return "is not a script command: a script may not start programs such as plug-ins";
  const auto shell = reserved_words();
  if (std::find(shell.begin(), shell.end(), word) == shell.end()) return {};
  return "is a shell command; a script does not need it";
}

bool carry_out(Command& k) {
  auto& [s, c, time, layer, script] = k;
  c.space();
  const char* start = c.at;
  const std::string_view w = c.word();
  if (w.empty())
    return c.fail_here(ErrorCode::syntax, fmt::format("a command must begin with a verb, not with '{}'", c.peek()));
  script.verb = start;
  const Verb* const known = find_verb(w);
  if (!known || !(known->flags & (Verb::opens_sheet | Verb::prefix))) show_lists(s, script);
  if (const Verb* v = known) {
    if ((v->flags & Verb::stamped) && !time && script.options.now) {
      script.stamp(s, {start, 0}, "at ", " ");
      c.ticks_read = true;
    }
    if (v->run(k) && finish(c)) return true;
    if (v->flags & Verb::opens_sheet) script.sheet.breaks();
    if (v->flags & Verb::opens_block) script.skip_block(start);
    if (c.error && c.error->hint.empty() && c.error->code == ErrorCode::syntax)
      c.error->hint = fmt::format("usage: {}", v->usage);
    return false;
  }
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == Role::command && p.name == w) return own_command(k, p);
  if (w[0] == '#') return c.fail(ErrorCode::syntax, "a comment starts with '#' and a space", w);
  if (first_dot(w) == std::string_view::npos || starts_like_time(w[0])) return no_command(k, w, start);
  if (time) return c.fail(ErrorCode::syntax, "a verb is missing here", w);
  if (open_sheet(k, w)) return true;
  script.sheet.breaks();
  return false;
}

void read_text(Scene& s, Script& script, std::string_view text, const std::string& name) {
  const bool outermost = !script.source.text.data();
  Source outer = std::exchange(script.source, {});
  Sheet outer_sheet = std::exchange(script.sheet, {});
  const SectionClock outer_clock = std::exchange(script.clock, script.clock_now());
  const bool outer_in = std::exchange(script.in_section, script.in_section || !script.blocks.empty());
  std::vector<OpenBlock> outer_blocks = std::exchange(script.blocks, {});
  const std::filesystem::path outer_folder = std::exchange(script.folder, std::filesystem::path(name).parent_path());
  const std::size_t outer_touched = script.touched;
  text = without_mark(text);
  script.source = {text, name};
  std::error_code ignored;
  if (outermost) script.whole = true, begin_translation(script);
  if (script.root.empty())
    script.root = std::filesystem::weakly_canonical(script.folder.empty() ? "." : script.folder, ignored);
  if (const auto bad = unsound(text)) {
    script.report(Severity::error, bad->why, {text.data() + bad->at, 0});
    script.diagnostics.back().line.clear();
  } else {
    run(s, script, program_line(text));
  }
  close_list(s, script);
  show_lists(s, script);
  follow_models(s, script, {});
  if (outermost) {
    say_masked_events(s, script), say_idle_releases(s, script);
    say_unfinished_lists(script), say_turned_falls(s, script), say_overlaps(s, script);
    say_unknown_lets(s, script);
  }
  script.source = std::move(outer);
  script.sheet = std::move(outer_sheet);
  script.clock = outer_clock, script.in_section = outer_in;
  script.blocks = std::move(outer_blocks);
  script.folder = outer_folder;
  script.touched = outer_touched;
}

void read_line(Scene& s, Script& script, std::string_view line, const std::string& name) {
  script.folder = std::filesystem::path(name).parent_path();
  std::shared_ptr<const OpenSheet> left = std::exchange(script.left, nullptr);
  std::string opener, pattern;  // of the sheet that the row continues
  const bool row = left && indentation(line) > script.margin();
  if (row) opener = left->opener, pattern = left->pattern;
  const bool same = row && go_on(s, script, *left);
  left.reset();  // it shares parts of the scene, which would be copied when they change
  if (same) {
    script.sheet.on.text = pattern;
  } else if (row) {  // the meaning of its names has changed
    const std::size_t said = script.diagnostics.size();
    script.source = {opener, name};
    std::vector<OpenBlock> blocks = std::exchange(script.blocks, {});
    run(s, script);
    script.blocks = std::move(blocks);
    script.sheet.place = {}, script.sheet.spots.clear();
    for (std::size_t i = said; i < script.diagnostics.size(); ++i) script.diagnostics[i].what.place = {};
    std::erase_if(script.diagnostics, [](const Diagnostic& d) { return d.severity != Severity::error; });
  }
  script.source = {line, name};
  if (const auto bad = unsound(line)) {
    script.report(Severity::error, bad->why, {line.data() + bad->at, 0});
    script.diagnostics.back().line.clear();
  } else {
    run(s, script);
  }
  show_list(s, script);
  follow_models(s, script, {});
  say_masked_events(s, script), say_idle_releases(s, script), say_overlaps(s, script);
  script.left = left_open(s, script);
}

}  // namespace betwixt

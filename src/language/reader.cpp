// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "base/names.h"
#include "base/utf8.h"
#include "language/line_words.h"

namespace betwixt {
namespace {

constexpr int most_errors = 1000;  // said; the rest is noise
constexpr std::ptrdiff_t longest_logical_line = 1
                                                << 24;  // how far a bracket may reach before it counts as never closed

}  // namespace

void Reader::report(Severity severity, Error error, std::string_view about) {
  if (severity == Severity::error && ++errors_ > most_errors) {
    if (!given_up_)
      diagnostics_.push_back({Severity::error,
                              fail(Code::syntax, fmt::format("more than {} errors; the rest is not said", most_errors)),
                              {},
                              0});
    given_up_ = true;
    return;
  }
  Diagnostic d{severity, std::move(error), {}, 0};
  const std::string_view text = source_.text;
  const char* begin = text.data();
  const char* spot = about.data() ? std::clamp(about.data(), begin, begin + text.size()) : begin;
  if (!source_.counted) source_.counted = begin;
  const auto [before, after] = std::minmax(source_.counted, spot);
  const auto passed = static_cast<int>(std::count(before, after, '\n'));
  source_.lines += spot < source_.counted ? -passed : passed;
  source_.counted = spot;

  const char* start = spot;
  while (start > begin && start[-1] != '\n') --start;
  const char* stop = line_end(spot, begin + text.size());
  if (stop > start && stop[-1] == '\r') --stop;
  const auto characters = [](const char* a, const char* b) { return static_cast<int>(count_characters({a, b})); };
  Place& at = d.what.place;
  at.file = source_.name;
  at.line = source_.lines;
  at.column = characters(start, spot) + 1;
  at.length = std::max(1, characters(spot, std::min(spot + about.size(), std::max(spot, stop))));
  const char *from = start, *to = stop;
  if (spot - from > 100) {  // long lines are shown around the place
    from = spot - 60;
    while (from < spot && !begins_character(*from)) ++from;
  }
  if (to - from > 160) {
    to = from + 160;
    while (to > spot && to < stop && !begins_character(*to)) --to;
  }
  d.line = std::string(from, std::max(from, to));
  d.caret = characters(from, spot);
  diagnostics_.push_back(std::move(d));
}

void Reader::note(Severity severity, std::string message, std::string_view about, std::string hint) {
  report(severity, fail(Code::syntax, std::move(message), std::move(hint)), about);
}

ValueReader Reader::values(Cursor& c) {
  return {c, s,
          [this, &c](FunctionId f, std::string& path, std::string_view about) { return asset(c, f, path, about); },
          [this](std::string message, std::string_view about, std::string hint) {
            note(Severity::warning, std::move(message), about, std::move(hint));
          }};
}

// The start of the line after the logical line that begins here: brackets and texts in """ hold lines together, unless
// they are never closed.
const char* Reader::after_line(const char* line_start, bool* closed) const {
  if (closed) *closed = true;
  Cursor c(source_.text);
  c.at = line_start;
  while (c.at < c.end && c.at - line_start < longest_logical_line) {
    c.space();
    if (c.at == c.end) break;
    const char ch = *c.at;
    if (ch == '\n') return c.at + 1;  // never seen inside brackets
    if (ch == '"') {
      std::string ignored;
      if (!c.text(ignored)) break;
      continue;
    }
    if (ch == '(') ++c.depth;
    if (ch == ')' && c.depth > 0) --c.depth;
    if (c.depth > 200) break;
    if (c.word().empty()) ++c.at;
  }
  if (c.at == c.end && c.depth == 0) return c.end;
  if (closed) *closed = c.depth == 0;
  const char* nl = line_end(line_start, c.end);
  return nl == c.end ? nl : nl + 1;
}

bool Reader::sound_text(std::string_view text) {
  const auto* p = reinterpret_cast<const unsigned char*>(text.data());
  const std::size_t n = text.size();
  const auto bad = [&](std::size_t i, const char* what) {
    report(Severity::error, fail(Code::file, fmt::format("this is not a text: {} (byte 0x{:02x})", what, p[i])),
           {text.data() + i, 0});
    diagnostics_.back().line.clear();
    return false;
  };
  // Eight plain characters at once: none above 0x7f, and none below 0x20 (a subtraction borrows into its top bit).
  const auto plain = [&](std::size_t i) {
    std::uint64_t w;
    std::memcpy(&w, p + i, 8);
    return ((w | (w - 0x2020202020202020)) & 0x8080808080808080) == 0;
  };
  for (std::size_t i = 0; i < n;) {
    while (i + 8 <= n && plain(i)) i += 8;
    if (i == n) break;
    const unsigned char ch = p[i];
    if (ch < 0x80) {
      if (ch < 0x20 && ch != '\n' && ch != '\t' && ch != '\r') return bad(i, "it holds a control character");
      ++i;
      continue;
    }
    const std::size_t length = character_length(text, i);
    if (length == 0) return bad(i, "it is not UTF-8");
    i += length;
  }
  return true;
}

void Reader::carry(const Carried& from, const std::string& script) {
  rows_read_frames_ = from.frames_read, rows_read_ticks_ = from.ticks_read;
  included_ = from.included, copied_ = from.copied;
  live_ = true;
  std::error_code ignored;
  if (!script.empty()) open_files_.push_back(std::filesystem::weakly_canonical(script, ignored));
}

void Reader::read_text(std::string_view text, const std::string& name) {
  Source outer = std::move(source_);
  source_ = {};
  source_.name = name;
  source_.folder = std::filesystem::path(name).parent_path();
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  source_.text = text;
  std::error_code ignored;
  if (root_.empty()) root_ = std::filesystem::weakly_canonical(source_.folder.empty() ? "." : source_.folder, ignored);
  if (sound_text(text)) run(text);
  left_open_ = source_.sheet.open && !source_.sheet.broken;
  left_sheet_ = left_open_ ? opener(source_.sheet) : "";
  close_list();
  if (!outer.text.data()) {
    masked_events(), idle_releases();
    unfinished_lists();
  }
  source_ = std::move(outer);
}

void Reader::run(std::string_view text) {
  Cursor c(text);
  if (text.starts_with("#!")) {  // a script that the system can start
    const auto nl = text.find('\n');
    c.at = nl == std::string_view::npos ? c.end : text.data() + nl;
  }
  while (c.at < c.end && !given_up_) {
    const char* line_start = c.at;
    const char* p = c.at;
    while (p < c.end && blank(*p)) ++p;
    if (p < c.end && *p == '\n') {
      c.at = p + 1;
      continue;
    }
    line(c, line_start);
  }
}

void Reader::line(Cursor& c, const char* line_start) {
  c.rate = s.rate;
  c.ticks = s.ticks;
  c.frames_read = rows_read_frames_;
  c.ticks_read = rows_read_ticks_;
  c.depth = 0;
  timed_ = false;
  layer_ = {};
  bool ok = true;
  if (!c.at_line_end()) {
    const bool indented = c.at > line_start;
    Sheet& sheet = source_.sheet;
    if (indented && sheet.open) {
      ok = sheet.broken || row(c);
      if (sheet.broken) c.at = after_line(line_start);
    } else {
      close_list();
      sheet.open = false;
      ok = command(c);
      if (sheet.open) sheet.opener = {line_start, c.at};
    }
  }
  rows_read_frames_ = c.frames_read;
  rows_read_ticks_ = c.ticks_read;
  if (ok) {
    if (c.at < c.end && *c.at == '\n') ++c.at;
    return;
  }
  Error e = c.error.value_or(fail(Code::syntax, "this cannot be carried out"));
  bool closed = true;
  const char* next = after_line(line_start, &closed);
  // Where a bracket is never closed, what the lines below seem to lack is not the trouble.
  if (!closed && c.depth > 0 && c.where.data() >= next) {
    e = fail(Code::syntax, "this bracket is never closed");
    c.where = {c.brackets[std::min(static_cast<std::size_t>(c.depth), c.brackets.size()) - 1], 1};
  }
  const bool ignored = e.code == Code::type && s.policy == Policy::ignore;
  if (ignored) e.message = "ignored: " + e.message;
  report(ignored ? Severity::warning : Severity::error, std::move(e), c.where);
  c.error.reset();
  c.where = {};
  c.at = next;
}

bool Reader::finish(Cursor& c) {
  if (c.at_line_end()) return true;
  const std::string_view w = c.peek_word();
  return c.fail_here(Code::syntax, w.empty() ? "nothing more is expected here"
                                             : fmt::format("'{}' is not expected here", w.substr(0, 40)));
}

bool Reader::command(Cursor& c) {
  c.space();
  const char* start = c.at;
  const std::string_view w = c.word();
  if (w.empty()) return c.fail_here(Code::syntax, fmt::format("a command begins with a verb, not with '{}'", c.peek()));
  for (const Verb& v : verbs()) {
    if (v.word != w) continue;
    if (!(this->*v.run)(c) || !finish(c)) {
      if (w == "make" || w == "edit") source_.sheet = {}, source_.sheet.open = source_.sheet.broken = true;
      if (c.error && c.error->hint.empty() && c.error->code == Code::syntax)
        c.error->hint = fmt::format("usage: {}", v.usage);
      return false;
    }
    return true;
  }
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == Role::command && p.name == w) return own_command(c, p);
  if (w[0] == '#') return c.fail(Code::syntax, "a comment starts with '#' and a space", w);
  if (first_dot(w) != std::string_view::npos && !starts_like_time(w[0])) {
    if (timed_) return c.fail(Code::syntax, "a verb is missing here", w);
    if (open_sheet(c, w)) return true;
    // Its rows have nowhere to go; they are passed over rather than complained about one by one.
    source_.sheet = {};
    source_.sheet.open = source_.sheet.broken = true;
    return false;
  }
  if (starts_like_time(w[0]))
    return c.fail(Code::syntax, "this looks like a row, but no sheet is open", {start, w.size()},
                  "rows are indented under a line that is only a target, as in ball.position");
  if (const auto why = not_yet(w); !why.empty())
    return c.fail(Code::name, fmt::format("'{}' {}", w, why), w,
                  w == "load" ? "who shows the film loads it: betwixt play --load PLUGIN FILE" : "");
  if (c.at_line_end() && !timed_) source_.sheet.open = source_.sheet.broken = true;  // meant as a target, it seems
  std::vector<std::string_view> words;
  for (const Verb& v : verbs()) words.push_back(v.word);
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == Role::command) words.push_back(p.name);
  if (s.names.find(w))
    return c.fail(Code::name, fmt::format("'{}' is an object, not a command", w.substr(0, 40)), w,
                  fmt::format("a sheet opens with a target, as in {}.position", w.substr(0, 40)));
  for (const auto& [row, usage] : row_words())
    if (row == w && !timed_)
      return c.fail(Code::name, fmt::format("'{}' is a row of a display list, not a command", w), w,
                    "rows are indented, below make NAME or edit NAME");
  if (w.starts_with("//") || w.starts_with(";"))
    return c.fail(Code::syntax, "a comment starts with '#' and a space", w);
  if (w == "mirror")
    return c.fail(Code::name, "there is no command 'mirror'", w,
                  "scale mirrors: scale ball.position 1f..24f (1 -1 1), or set ball.scale (1 -1 1)");
  c.space();
  if (c.peek() == '=')
    return c.fail(Code::name, fmt::format("there is no command '{}'", w.substr(0, 40)), w,
                  fmt::format("names for many objects are made by: alias {} = …", w.substr(0, 40)));
  return c.fail(Code::name, fmt::format("there is no command '{}'", w.substr(0, 40)), w, did_you_mean(w, words));
}

bool Reader::open_sheet(Cursor& c, std::string_view word) {
  Selected on;
  if (!targets(c, word, on)) return false;
  if (!c.at_line_end())
    return c.fail_here(Code::syntax, "nothing follows the target that opens a sheet",
                       fmt::format("its rows go below, indented; a single event is written: at TIME {} VALUE", word));
  Sheet& sheet = source_.sheet;
  sheet = {};
  sheet.open = true;
  sheet.on = std::move(on);
  if (!sheet.on.spec) return true;  // a pattern that names nothing: rows are read by nobody
  for (const Target& t : sheet.on.targets)
    if (Track* track = edit_track(s, t)) sheet.tracks.push_back(track);
  if (sheet.tracks.size() != sheet.on.targets.size()) sheet.tracks.clear();
  sheet.fresh = !sheet.tracks.empty() && sheet.tracks[0]->events.empty();
  return true;
}

bool Reader::row(Cursor& c) {
  Sheet& sheet = source_.sheet;
  if (!sheet.list.empty()) return list_row(c);
  if (!sheet.on.spec) {
    c.at = after_line(c.at);
    if (c.at > source_.text.data() && c.at[-1] == '\n') --c.at;
    return true;
  }
  Time time;
  const char first = c.peek();
  if (!starts_like_time(first))
    return c.fail_here(Code::syntax,
                       fmt::format("a row begins with a time, not with '{}'",
                                   c.peek_word().empty() ? std::string_view(c.at, 1) : c.peek_word()),
                       "a command that follows a sheet is not indented");
  const char* const start = c.at;
  std::optional<Time> until;
  if (!time_or_segment(c, time, until)) return false;
  if (until && sheet.on.type() != Type::motion) return one_time_only(c, c.since(start));
  return (until ? moving(c, sheet.on, time, until) : event(c, sheet.on, time)) && finish(c);
}

}  // namespace betwixt

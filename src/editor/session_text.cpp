// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sessions in which edits change the author's text.
#include <algorithm>
#include <charconv>

#include "base/files.h"
#include "editor/row_change.h"
#include "editor/session_state.h"
#include "language/cursor.h"
#include "language/values.h"

namespace betwixt {
bool is_rewriting(std::string_view line) { return first_word(line) == "rewrite"; }

std::string Session::rewrite_line(int first, int last, std::string_view others) {
  return fmt::format("rewrite {}..{} {}", first, last, write_text(std::string(others)));
}

void Session::State::go_in_place() {
  if (in_place) return;
  written = {text(), std::vector<TextEdits>(editor.steps().size() + editor.undone().size())};
  in_place = true;
  read_text_again();
}

// Updates the diagnostics of the text.
void Session::State::read_text_again() {
  of_text.clear();
  (void)editor.read(placed().text, of_text);
}

// Places the lines of a step one by one, as if they had been entered one after the other. Returns nullopt if that is
// too much work or does not make the same film.
std::optional<TextEdits> Session::State::place_each(const Point& then, const Step& step) const {
  constexpr std::size_t most_read = 1'000'000;  // bytes: the text is read once for each line
  std::string text = placed().text;
  if (step.rows || !step.sheet.empty() || step.lines.size() * text.size() > most_read ||
      std::ranges::any_of(step.lines, indented))
    return std::nullopt;
  TextEdits all;
  Point at = editor.now();
  at.script.close();
  Diagnostics said;
  for (const std::string& line : step.lines) {
    CommandResult result = editor.carry_out(at, line);
    if (!result.done || result.opens) return std::nullopt;
    const auto makes = [&](const std::string& edited, const TextEdits&) {
      return editor.read(edited, said).document == result.after.document;
    };
    TextEdits edits = place(text, {{result.line}, {}}, at.document, result.after.document, makes);
    put_into(text, edits);
    all.insert(all.end(), std::make_move_iterator(edits.begin()), std::make_move_iterator(edits.end()));
    at = std::move(result.after);
  }
  said.clear();
  const bool same = at.document == then.document && editor.read(text, said).document == then.document;
  return same && !has_errors(said) ? std::optional(std::move(all)) : std::nullopt;
}

Status Session::State::take(Point then, Step step) {
  if (!in_place) return editor.take(std::move(then), std::move(step));
  Diagnostics said;
  const auto makes = [&](const std::string& text, const TextEdits& edits) {
    said.clear();
    const Point made =
        edits.size() == 1 ? after(text, whole_lines(placed().text, edits[0]), said) : editor.read(text, said);
    return made.document == then.document;
  };
  TextEdits edits = place(placed().text, step, document(), then.document, makes);
  const bool at_end = edits.size() == 1 && edits[0].at == placed().text.size() && edits[0].removed.empty();
  if (step.lines.size() > 1 && at_end)
    if (auto each = place_each(then, step)) edits = *std::move(each);
  // An open bracket above would swallow the new line.
  if (has_errors(of_text)) {
    std::string text = placed().text;
    put_into(text, edits);
    const auto wrong = std::ranges::find(of_text, Severity::error, &Diagnostic::severity);
    if (!(editor.read(text, said).document == then.document))
      return fail(ErrorCode::syntax, "an error in the script above hides this line",
                  fmt::format("correct it first: line {}, {}", wrong->what.place.line, wrong->what.message));
    said.clear();
  }
  if (Status s = editor.take(std::move(then), std::move(step)); !s) return s;
  placed().edits.resize(editor.steps().size() - 1);
  placed().edits.push_back(std::move(edits));
  put_into(placed().text, placed().edits.back());
  if (!of_text.empty()) read_text_again();
  return Nothing{};
}

Status Session::State::go_back() {
  if (Status s = editor.undo(); !s || !in_place) return s;
  take_back(placed().text, placed().edits[editor.steps().size()]);
  read_text_again();
  return Nothing{};
}

Status Session::State::go_again() {
  if (Status s = editor.redo(); !s || !in_place) return s;
  put_into(placed().text, placed().edits[editor.steps().size() - 1]);
  read_text_again();
  return Nothing{};
}

// rewrite FIRST..LAST "…"
Result<TextEdit> Session::State::rewriting(std::string_view line) const {
  Cursor c(line);
  (void)c.next_word();
  const std::string_view range = c.next_word();
  const std::size_t dots = range.find("..");
  const auto number = [](std::string_view s) {
    int n = -1;
    const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), n);
    return error == std::errc() && end == s.data() + s.size() ? n : -1;
  };
  const LineRange lines = {number(range.substr(0, dots)),
                           dots == std::string_view::npos ? number(range) : number(range.substr(dots + 2))};
  std::string others;
  c.space();
  if (lines.first < 0 || lines.last < 0 || !c.text(others) || !c.at_line_end())
    return fail(ErrorCode::syntax, "rewrite needs the lines and their new text",
                "usage: rewrite FIRST..LAST \"…\", as in rewrite 2..2 \"create ball sphere\"");
  return replace_lines(in_place ? placed().text : text(), lines, others);
}

// Returns the film after a change of the text. Derives it from the current film if the change allows that.
Point Session::State::after(const std::string& text, const TextEdit& edit, Diagnostics& said) const {
  if (in_place && edit.inserted == edit.removed) return said = of_text, editor.now();  // typed, and taken back
  if (in_place && of_text.empty())
    if (const auto commands = commands_of(placed().text, edit, document())) {
      Point at = editor.now();
      at.script.close();
      bool plain = true;
      for (const std::string& line : *commands) {
        CommandResult result = editor.carry_out(at, line);
        plain = plain && result.done && result.said.empty();
        if (plain) at = std::move(result.after);
      }
      if (plain) return at;
    }
  return editor.read(text, said);
}

Session::Answer Session::State::rewrite(std::string_view line) {
  if (looks_only) return only_looks();
  const Result<TextEdit> edit = rewriting(line);
  if (!edit) return refused(edit.error());
  go_in_place();
  std::string text = placed().text;
  put_into(text, {*edit});
  Diagnostics said;
  Point then = after(text, *edit, said);
  if (Status s = editor.take(std::move(then), {{std::string(line)}, {}}); !s) return refused(s.error());
  placed().edits.resize(editor.steps().size() - 1);
  placed().edits.push_back({*edit});
  placed().text = std::move(text), of_text = std::move(said);
  tally.command(), sheet_refused = false;
  return done(has_errors(of_text) ? "the script has errors\n" : "");
}

// Begins a new journal on the current file, with one record that turns it into the session's text.
Status Session::State::go_on_from_file() {
  if (looks_only || file.empty()) return Nothing{};
  const auto there = read_script(file);
  if (!there) return there.error();
  if (!*there) return no_file(file);
  go_in_place();
  known = fingerprint(**there);
  tally.save();
  journal_knows = journal_undid = 0;
  std::vector<Record> rest;
  if (const LineChange c = change_between(**there, placed().text); placed().text != **there) {
    rest.push_back({Did::command, rewrite_line(c.lines.first, c.lines.last, c.others)});
    tally.gone = 1;  // the file is one command behind
  }
  return journal ? journal->begin(*known, rest) : Status(Nothing{});
}

Status Session::go_on_from_file() { return state_->go_on_from_file(); }

Loaded Session::look_ahead(int first, int last, std::string_view others) const {
  std::string text = state_->text();
  Loaded loaded;
  if (const auto edit = replace_lines(text, {first, last}, others)) {
    put_into(text, {*edit});
    loaded.document = state_->after(text, *edit, loaded.diagnostics).document;
  } else {
    loaded.document = document();
  }
  return loaded;
}

}  // namespace betwixt

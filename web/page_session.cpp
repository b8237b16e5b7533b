// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a page has of a session: a text, tracks from numbers, undo. There is no file, no journal and no shell: pages are
// downloaded while somebody waits.
#include "base/diagnostic.h"
#include "editor/session_state.h"

namespace betwixt {

void Session::State::keep_journal() {}
void Session::State::close(bool) {}
Journal::~Journal() = default;

Session::Answer Session::State::refused(const std::string& message, const std::string& hint) {
  const Diagnostic why{Severity::error, fail(ErrorCode::name, message, hint), {}, 0};
  return {false, false, true, to_string(why), {why}};
}
Session::Answer Session::State::only_looks() const { return refused("this film is read-only"); }
std::string Session::State::told(const Diagnostics& all, std::string_view) const {
  std::string said;
  for (const Diagnostic& d : all) said += to_string(d);
  return said;
}
Diagnostics Session::State::hinted(Diagnostics all, std::string_view) const { return all; }
void Session::State::read_text_again() {
  of_text.clear();
  (void)editor.read(placed().text, of_text);
}

Session::Answer Session::State::undo(const Words&) {
  if (editor.steps().empty()) return refused("there is nothing to undo", "the script is as you opened it");
  if (Status s = editor.undo(); !s) return refused(s.error());
  take_back(placed().text, placed().edits[editor.steps().size()]);
  return done("undone: " + editor.undone().front().lines[0] + "\n");
}
Session::Answer Session::State::redo(const Words&) {
  if (Status s = editor.redo(); !s) return refused(s.error());
  put_into(placed().text, placed().edits[editor.steps().size() - 1]);
  return done("redone: " + editor.steps().back().lines[0] + "\n");
}

Session::Session(Callbacks callbacks, const LoadOptions& options)
    : state_(std::make_unique<State>(std::move(callbacks), options)) {}
Session::~Session() = default;
void Session::begin(std::string text, const std::string& file) {
  state_->in_place = true;
  state_->written = {text, {}};
  state_->of_text = state_->editor.begin(std::move(text), file);
}
// Knows only undo and redo.
Session::Answer Session::enter(std::string_view line) { return line == "undo" ? state_->undo() : state_->redo(); }
const Diagnostics& Session::diagnostics() const { return state_->of_text; }
const Document& Session::document() const { return state_->document(); }
std::string Session::text() const { return state_->placed().text; }

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/session.h"

#include <algorithm>

#include "base/diagnostic.h"
#include "base/message_groups.h"
#include "base/names.h"
#include "commands/line_head.h"
#include "commands/reader.h"
#include "editor/said_line.h"
#include "editor/session_state.h"
#include "language/moments.h"

namespace betwixt {
namespace {

// Returns true if the refused line would have opened a sheet or a block.
bool meant_a_sheet(std::string_view line) {
  const LineHead head = line_head(line);
  if (opens_block(head)) return true;
  if (head.word.empty() || !head.time.empty() || head.verb) return head.verb && head.verb->flags & Verb::opens_sheet;
  return head.name.empty() || first_dot(head.word) != std::string_view::npos;
}

// Returns true if the diagnostic is about the entered line itself, and not about a file that it uses.
bool is_of_line(const Diagnostic& d) { return d.what.place.file.empty() && d.what.place.line != 0; }

}  // namespace

Session::Answer Session::State::refused(const std::string& message, const std::string& hint) {
  const Diagnostic why{Severity::error, fail(ErrorCode::name, message, hint), {}, 0};
  return {false, false, true, to_string(why), {why}};
}

std::string_view trimmed(std::string_view s, bool both) {
  while (both && !s.empty() && (blank(s.front()) || s.front() == '\n')) s.remove_prefix(1);
  while (!s.empty() && (blank(s.back()) || s.back() == '\n')) s.remove_suffix(1);
  return s;
}

std::string Session::State::text() const { return in_place ? placed().text : as_script(editor.base(), editor.steps()); }

// Returns the index of the answer; nullopt if there is no answer.
std::string to_string(const Session::Question& q) {
  std::string out = fmt::format("{}{}: ", q.above, q.text);
  for (std::size_t i = 0; i < q.choices.size(); ++i)
    out += (i == 0 ? "" : i + 1 < q.choices.size() ? ", " : " or ") + q.choices[i];
  return out + "? ";
}

std::optional<std::size_t> Session::State::choose(Question question, const Asking& ask) const {
  const std::vector<std::string>& choices = question.choices;
  while (ask) {
    const auto answer = ask(question);
    if (!answer) break;
    if (*answer == called_off) {  // the last choice is the one that changes nothing, unless it is "show"
      if (choices.back() == "show") break;
      return choices.size() - 1;
    }
    const std::string_view word = trimmed(*answer);
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (!word.empty() && choices[i].starts_with(word)) found = i;  // valid if the count below is 1
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (choices[i] == word) return i;
    const auto begins = [&](std::string_view c) { return !word.empty() && c.starts_with(word); };
    if (std::count_if(choices.begin(), choices.end(), begins) == 1) return found;
    question.above.clear(), question.text = "please answer";
  }
  return std::nullopt;
}

Session::Answer Session::State::only_looks() const {
  return refused(fmt::format("another shell has {} open, so this one is read-only", called()));
}

// Returns the number of the text's first line among all entered lines.
int Session::State::line_of(std::string_view text) const {
  return std::max(1, lines - static_cast<int>(std::count(text.begin(), text.end(), '\n')));
}

// Formats the diagnostics of a line, with its number among all entered lines.
std::string Session::State::told(const Diagnostics& all, std::string_view line) const {
  const int first = line_of(line);
  std::string said;
  for (Diagnostic d : hinted(all, line)) {
    if (is_of_line(d)) d.what.place.file = "line", d.what.place.line += first - 1;
    said += to_string(d);
  }
  return said;
}

// Adds hints that only the session can give.
Diagnostics Session::State::hinted(Diagnostics all, std::string_view line) const {
  for (Diagnostic& d : all) {
    for (const std::string_view name : with_those_above(name_missed(d.what)))
      if (const auto made = failed.find(name); made != failed.end())
        set_hint(d.what, fmt::format("line {}, which should have created it, has an error", made->second));
    if (unknown_command(d.what, line)) {
      std::vector<std::string_view> known;
      for (const Word& w : words()) known.push_back(w.word);
      set_hint(d.what, did_you_mean(first_word(line), known));
    }
  }
  return all;
}

// Asks what to do with a value that has no meaning at its place (policy ask). Returns true to translate it, false to
// ignore the line; nullopt if there is no one to ask or no translation.
std::optional<bool> Session::State::asked_about(const CommandResult& refused, std::string_view line) const {
  const auto meaningless = [](const Diagnostic& d) {
    return d.severity == Severity::error && d.what.code == ErrorCode::type;
  };
  if (!callbacks.ask_about_line || document().scene().policy != Policy::ask) return std::nullopt;
  if (!std::any_of(refused.said.begin(), refused.said.end(), meaningless)) return std::nullopt;
  const CommandResult other = editor.carry_out(editor.now(), line, {}, true);
  if (!other.done || other.line == trimmed(line)) return std::nullopt;
  const auto chosen = choose({told(refused.said, line),
                              fmt::format("it can be translated to '{}'", trimmed(other.line)),
                              {"translate", "ignore"}},
                             callbacks.ask_about_line);
  return chosen == std::size_t{0};
}

Session::Answer Session::State::command(std::string_view line) {
  if (looks_only) return only_looks();
  const bool row = editor.now().script.goes_on(line);
  if (indented(line) && sheet_refused)
    return refused("this row has no sheet, because the line that should open it has an error");
  if (!editor.now().script.belongs(line)) line = trimmed(line);  // the file must not take it for a row
  const SaidLine said = look_at(line);
  if (said.several) return refused("enter one line at a time");
  CommandResult result = editor.carry_out(editor.now(), line);
  if (const auto meant = result.done ? std::nullopt : asked_about(result, line)) {
    if (!*meant) return {false, false, false, "ignored\n"};
    result = editor.carry_out(editor.now(), line, {}, true);
  }
  Answer answer{result.done, false, !result.done, told(result.said, line), hinted(result.said, line)};
  if (!result.done) {
    if (!row) sheet_refused = meant_a_sheet(line);
    for (std::string& name : names_missed(document().scene(), line)) failed[std::move(name)] = lines;
    return answer;
  }
  if (Status s = take(std::move(result.after), {{std::move(result.line)}, in_place ? result.sheet : ""}); !s)
    return refused(s.error());
  tally.command(), sheet_refused = false;
  if (!failed.empty())
    for (const std::string& name : names_made(line)) failed.erase(name);
  if (result.touched > 1 && !row && !quiet) answer.said += fmt::format("{} objects\n", result.touched);
  answer.said += tried(said.words, line);
  return answer;
}

// Carries out several lines as one step. If one is wrong, none is carried out.
Session::Answer Session::State::together(const std::vector<std::string>& said) {
  if (looks_only) return only_looks();
  if (said.empty()) return {};
  if (said.size() == 1) return enter(said[0]);
  lines += 1;
  Point at = editor.now();
  at.script.close();
  Step step;
  Answer answer;
  int before = 0;  // lines of earlier commands
  // Many lines are usually without a message: then one reading is enough.
  constexpr std::size_t many = 100;
  if (said.size() >= many && !indented(said[0]))
    if (auto after = editor.carried_out(at, said)) {
      at = *std::move(after);
      step.lines = said;
    }
  for (const std::string& line : step.lines.empty() ? said : std::vector<std::string>()) {
    CommandResult result = editor.carry_out(at, line);
    answer.said += told(result.said, line);
    for (Diagnostic& d : hinted(result.said, line)) {
      if (is_of_line(d)) d.what.place.line += before;
      answer.why.push_back(std::move(d));
    }
    if (!result.done) return {false, false, true, answer.said, answer.why};
    before += 1 + static_cast<int>(std::count(line.begin(), line.end(), '\n'));
    at = std::move(result.after);
    step.lines.push_back(std::move(result.line));
  }
  if (Status s = take(std::move(at), std::move(step)); !s) return refused(s.error());
  tally.command(), sheet_refused = false;
  answer.done = true;
  return answer;
}

Result<Document> Session::State::ahead(const std::vector<std::string>& said) const {
  if (said.size() == 1 && is_rewriting(trimmed(said[0]))) {
    const Result<TextEdit> edit = rewriting(trimmed(said[0]));
    if (!edit) return edit.error();
    std::string edited = text();
    put_into(edited, {*edit});
    Diagnostics found;
    Point then = after(edited, *edit, found);
    const auto wrong = std::ranges::find(found, Severity::error, &Diagnostic::severity);
    if (wrong != found.end()) return wrong->what;
    return std::move(then.document);
  }
  Point at = editor.now();
  for (const std::string& line : said) {
    CommandResult result = editor.carry_out(at, line);
    for (const Diagnostic& d : result.said)
      if (d.severity == Severity::error) return d.what;
    at = std::move(result.after);
  }
  return at.document;
}

// Evaluates the film at its ends and at the line's times, and reports errors of code that are new, each once.
std::string Session::State::tried(const Words& words, std::string_view line) {
  if (!may_hold_text(line) && document().scene().procedures->empty()) return {};
  const auto [first, last] = document().range();
  const int first_line = line_of(line);
  std::vector<Time> times{first, last};
  for (const std::string& w : words)
    if (starts_like_time(w[0]))
      if (const Result<Time> t = parse_time(w, document())) times.push_back(*t);
  program = Program::compile(document(), program);
  Diagnostics all;
  MessageGroups alike;
  for (const Time t : times) {
    const Frame made = program.frame(t);
    for (Problem p : made.reports) {
      if (!problems.insert(to_string(p)).second) continue;
      Diagnostic d{Severity::warning, {ErrorCode::syntax, {}, {}, {"line", first_line, 1, 0}}, {}, 0};
      if (p.source) point_at(d, p, line, *p.source);
      if (!d.line.empty()) d.what.place.line += first_line - 1;
      const std::size_t n = alike.add(p);
      if (n == all.size()) all.push_back(std::move(d));
      all[n].what.message = alike.text(n);
    }
  }
  std::string said;
  for (const Diagnostic& d : all) said += to_string(d);
  return said;
}

Session::Answer Session::State::undo(const Words&) {
  if (looks_only) return only_looks();
  if (editor.steps().empty())
    return refused("there is nothing to undo", editor.base().empty() ? "" : "the script is as you opened it");
  if (Status s = go_back(); !s) return refused(s.error());
  tally.undo(), sheet_refused = false;
  return done(fmt::format("undone: {}\n", trimmed(editor.undone().front().lines[0])));
}

Session::Answer Session::State::redo(const Words&) {
  if (looks_only) return only_looks();
  if (Status s = go_again(); !s) return refused(s.error());
  tally.redo(), sheet_refused = false;
  return done(fmt::format("redone: {}\n", trimmed(editor.steps().back().lines[0])));
}

Session::Answer Session::State::enter(std::string_view line) {
  lines += 1 + static_cast<int>(std::count(line.begin(), line.end(), '\n'));
  line = trimmed(line, false);
  if (ended) return refused("the session has ended");
  if (trimmed(line).empty()) return {};
  std::string shifted;  // at the prompt, a row need not be indented
  const ReaderState& script = editor.now().script;
  if (script.left && (starts_like_time(line[0]) || moment_length(line) > 0))
    line = shifted = std::string(script.margin() + 2, ' ') + std::string(line);
  if (indented(line) && (script.belongs(line) || sheet_refused)) return command(line);
  if (is_rewriting(trimmed(line))) return rewrite(trimmed(line));
  const Words all = line_words(trimmed(line));
  const Word* word = all.empty() ? nullptr : find_word(all[0]);
  // These words set how `play` draws, whatever the script says. Without a player they are commands of the script.
  const bool of_picture = word && word->run == &State::picture && callbacks.set_play_option;
  if (!word || (all.size() > 1 && is_verb(all[0]) && !of_picture)) return command(line);
  if (all.size() > word->most + 1) return refused(fmt::format("'{}' is not expected here", all[word->most + 1]));
  return (this->*word->run)(all);
}

Session::Session(Callbacks callbacks, const LoadOptions& options)
    : state_(std::make_unique<State>(std::move(callbacks), options)) {}
Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Session::Answer Session::open(const std::string& file, Earlier earlier) { return state_->open(file, earlier); }
void Session::begin(std::string text, const std::string& file) { state_->begin(std::move(text), file); }
Session::Answer Session::enter(std::string_view line) { return state_->enter(line); }
Session::Answer Session::enter_together(const std::vector<std::string>& lines) { return state_->together(lines); }
Result<Document> Session::look_ahead(const std::vector<std::string>& lines) const { return state_->ahead(lines); }
void Session::keep_nameless_in(std::string journal) { state_->nameless_journal = std::move(journal); }
void Session::edit_in_place() { state_->go_in_place(); }
const Diagnostics& Session::diagnostics() const { return state_->of_text; }
void Session::keep_quiet() { state_->quiet = true; }
bool Session::needs_more(std::string_view line) { return goes_on(line); }
const Document& Session::document() const { return state_->document(); }
std::string Session::sheet() const {
  const auto& left = state_->editor.now().script.left;
  return left ? left->opener : std::string();
}
const std::string& Session::file() const { return state_->file; }
std::vector<Session::PastStep> Session::history(std::size_t most) const {
  const std::span<const Step> stand = state_->editor.steps(), undone = state_->editor.undone();
  std::vector<PastStep> all;
  const auto add = [&](const Step& step, bool stands) {
    const std::size_t rows = step.rows ? step.rows->times.size() : 0;
    all.push_back({step.lines.empty() ? "" : step.lines[0], step.lines.size() + rows, step.sheet, stands});
  };
  const std::size_t later = std::min(undone.size(), most), earlier = std::min(stand.size(), most - later);
  for (const Step& step : stand.last(earlier)) add(step, true);
  for (const Step& step : undone.first(later)) add(step, false);
  return all;
}
std::size_t Session::unsaved() const { return state_->tally.unsaved(); }
bool Session::may_change() const { return !state_->looks_only; }
std::string Session::text() const { return state_->text(); }

}  // namespace betwixt

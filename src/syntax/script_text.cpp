// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "syntax/script_text.h"

#include <algorithm>

#include "syntax/texts.h"

namespace betwixt {
namespace {

// Replaces the elements from `first` to before `last` by `count` equal ones.
template <class T, class Value>
void replace_part(std::vector<T>& all, std::size_t first, std::size_t last, std::size_t count, const Value& by) {
  const auto place = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
  all.insert(all.erase(place(first), place(last)), count, by);
}

}  // namespace

void ScriptText::assign(std::string text) {
  text_ = std::move(text);
  starts_.assign(1, 0);
  for (std::size_t at = 0; (at = text_.find('\n', at)) != std::string::npos;) starts_.push_back(++at);
  above_.assign(starts_.size(), {});
  broken_.assign(starts_.size(), false);
  lex_from(0, count() - 1);
}

void ScriptText::replace(Span span, std::string_view by) {
  const std::size_t first = line_of(span.at), last = line_of(span.end());
  // The edit may complete a broken line above.
  const auto broken = std::find(broken_.begin(), broken_.end(), true) - broken_.begin();
  const std::size_t from = std::min(first_of(first), static_cast<std::size_t>(broken));
  text_.replace(span.at, span.size, by);
  const auto fresh = static_cast<std::size_t>(std::count(by.begin(), by.end(), '\n'));
  for (std::size_t i = last + 1; i < starts_.size(); ++i) starts_[i] += by.size() - span.size;
  replace_part(starts_, first + 1, last + 1, fresh, std::size_t{0});
  for (std::size_t i = 0, at = span.at; i < fresh; ++i) starts_[first + 1 + i] = at = text_.find('\n', at) + 1;
  replace_part(above_, first + 1, last + 1, fresh, LineState{});
  replace_part(broken_, first + 1, last + 1, fresh, false);
  lex_from(from, first + fresh);
}

// Lexes logical lines from `line` on, until one below `last` begins where one began before.
void ScriptText::lex_from(std::size_t line, std::size_t last) {
  while (line < count()) {
    above_[line] = {};
    line = lex(line);
    if (line > last && line < count() && !above_[line].goes_on()) return;
  }
}

// Lexes the logical line that begins with a line. Returns the line after it.
std::size_t ScriptText::lex(std::size_t line) {
  const std::size_t from = starts_[line] + (line == 0 ? head() : 0);
  const LogicalLine logical = logical_line(std::string_view(text_).substr(from));
  broken_[line] = !logical.whole;
  const std::size_t behind = line_of(static_cast<std::size_t>(logical.end - text_.data())) + 1;
  LineState state;
  for (std::size_t i = line; i + 1 < behind; above_[i] = state) {
    pass_line(i == line ? std::string_view(text_).substr(from, starts_[i + 1] - from) : with_end(i), state);
    broken_[++i] = false;
  }
  return behind;
}

// Returns the length of the part that the reader skips: a byte order mark, and a first line "#!…".
std::size_t ScriptText::head() const {
  const std::string_view script = without_mark(text_);
  return text_.size() - script.size() + program_line(script);
}

std::string_view ScriptText::with_end(std::size_t line) const {
  const std::size_t to = line + 1 < starts_.size() ? starts_[line + 1] : text_.size();
  return std::string_view(text_).substr(starts_[line], to - starts_[line]);
}

std::string_view ScriptText::line(std::size_t line) const {
  std::string_view all = with_end(line);
  if (all.ends_with('\n')) all.remove_suffix(1);
  if (all.ends_with('\r')) all.remove_suffix(1);
  return all;
}

std::size_t ScriptText::line_of(std::size_t place) const {
  return static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), place) - starts_.begin()) - 1;
}

std::vector<Token> ScriptText::tokens(std::size_t line) const {
  LineState state = above_[line];
  const std::size_t skipped = line == 0 ? head() : 0;
  std::vector<Token> all = tokens_of(with_end(line).substr(skipped), state);
  for (Token& t : all) t.at += skipped;
  if (skipped > 0) all.insert(all.begin(), {0, skipped, TokenKind::comment});
  return all;
}

std::optional<Token> ScriptText::token_at(std::size_t line, std::size_t place) const {
  std::optional<Token> found;
  for (const Token& t : tokens(line))
    if (t.at <= place && place <= t.end()) found = t;
  return found;
}

std::size_t ScriptText::first_of(std::size_t line) const {
  while (line > 0 && above_[line].goes_on()) --line;
  return line;
}

std::size_t ScriptText::behind(std::size_t line) const {
  for (++line; line < count() && above_[line].goes_on();) ++line;
  return line;
}

std::size_t ScriptText::first_before(std::size_t place) const {
  const std::size_t here = first_of(line_of(place));
  std::size_t above = here;
  while (above > 0 && (empty(above) || indented(line(above)))) above = first_of(above - 1);
  const std::string_view begun = std::string_view(text_).substr(starts_[above], place - starts_[above]);
  return logical_line(begun).open ? above : here;
}

bool ScriptText::only_comment(std::size_t line) const { return !above_[line].text && comment_in(this->line(line)); }

bool ScriptText::empty(std::size_t line) const { return !above_[line].text && empty_line(this->line(line)); }

std::vector<std::size_t> line_starts(std::string_view text) {
  std::vector<std::size_t> all;
  for (std::size_t at = 0; at < text.size(); at += line_at(text, at).size()) all.push_back(at);
  return all;
}

std::string_view line_at(std::string_view text, std::size_t start) {
  const std::size_t feed = text.find('\n', start);
  return text.substr(start, feed == std::string_view::npos ? feed : feed + 1 - start);
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/text_lines.h"

#include <algorithm>

#include "editor/speaking.h"
#include "language/line_words.h"

namespace betwixt {

void TextLines::take(std::string text) {
  text_ = std::move(text);
  above_.clear();
  starts_.assign(1, 0);
  for (std::size_t at = 0; (at = text_.find('\n', at)) != std::string::npos;) starts_.push_back(++at);
}

void TextLines::replace(Span span, std::string_view others) {
  text_.replace(span.at, span.size, others);
  take(std::move(text_));
}

std::string_view TextLines::line(std::size_t i) const {
  const std::size_t from = starts_[i];
  std::size_t to = i + 1 < starts_.size() ? starts_[i + 1] - 1 : text_.size();
  if (to > from && text_[to - 1] == '\r') --to;
  return std::string_view(text_).substr(from, to - from);
}

std::size_t TextLines::line_of(std::size_t place) const {
  return static_cast<std::size_t>(std::ranges::upper_bound(starts_, place) - starts_.begin()) - 1;
}

void TextLines::know_states() const {
  if (!above_.empty()) return;
  LineState state;
  above_.reserve(starts_.size());
  for (std::size_t i = 0; i < starts_.size(); ++i) {
    above_.push_back(state);
    pass_line(line(i), state);
  }
}

LineState TextLines::state_above(std::size_t line) const { return know_states(), above_[line]; }

std::size_t TextLines::first_of(std::size_t line) const {
  while (line > 0 && state_above(line).goes_on()) --line;
  return line;
}

std::size_t TextLines::behind(std::size_t line) const {
  for (++line; line < count() && state_above(line).goes_on();) ++line;
  return line;
}

std::size_t TextLines::opener_of(std::size_t line) const {
  std::size_t at = first_of(line);
  if (!indented(this->line(at))) return count();
  while (at > 0 && below_opener(this->line(at))) at = first_of(at - 1);
  return opens_sheet(this->line(at)) ? at : count();
}

}  // namespace betwixt

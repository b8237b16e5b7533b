// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/said_line.h"

#include "commands/verbs.h"
#include "syntax/tokens.h"

namespace betwixt {
SaidLine look_at(std::string_view text, std::size_t most) {
  const LogicalLine line = logical_line(text);
  return {text,           first_word(text), line_words(text.substr(0, most)),
          indented(text), line.open,        !line.open && line.end != text.data() + text.size()};
}

bool is_verb(std::string_view word) {
  const Verb* const verb = find_verb(word);
  return verb && !(verb->flags & Verb::after_time);
}

bool goes_on(std::string_view text) { return logical_line(text).open; }

}  // namespace betwixt

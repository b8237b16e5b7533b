// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The words of a logical line, for readers that ask for each line whether it has a certain word.
#pragma once

#include "syntax/characters.h"

namespace betwixt {

// Returns whether f(word) is true for a word of the logical line that begins at `at`. Skips texts and comments.
template <class F>
bool any_word(const char* at, const char* end, F&& f) {
  for (int depth = 0; (at = space_end(at, end, depth > 0)) < end && *at != '\n';) {
    const char* const from = at;
    at = word_end(at, end);
    if (at > from) {
      if (f(between(from, at))) return true;
    } else if (*at == '"') {
      at = quoted_end(at, end).at;
    } else {
      depth += (*at == '(') - (*at == ')' && depth > 0);
      ++at;
    }
  }
  return false;
}

}  // namespace betwixt

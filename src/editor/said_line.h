// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The first look at an entered line: where it ends, whether it continues, and its first words, which decide what
// carries it out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

struct SaidLine {
  std::string_view text, verb;
  std::vector<std::string> words;  // empty for a comment or a blank line; of a long line only the first words
  bool indented = false;
  bool open = false;     // a bracket or a """ is open: the line continues
  bool several = false;  // the text has more than one line
  bool alone() const { return words.size() == 1; }
};
// `most`: looks for words in this many bytes only.
SaidLine look_at(std::string_view text, std::size_t most = std::string_view::npos);

bool is_verb(std::string_view word);  // whether a command of the language can begin with it
// Returns true if a bracket or a """ is open.
bool goes_on(std::string_view text);

}  // namespace betwixt

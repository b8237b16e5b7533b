// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A line as somebody says it, looked at once: where it ends, whether it goes on, and what it begins with, from which
// follows who carries it out.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

struct SaidLine {
  std::string_view text, verb;
  std::vector<std::string> words;  // none: a remark, or nothing; of a long line only the first ones
  bool indented = false;
  bool open = false;     // a bracket or a """ is: it goes on
  bool several = false;  // more lines than one stand behind each other
  bool alone() const { return words.size() == 1; }
};
// `most`: words are looked for in so many bytes.
SaidLine look_at(std::string_view text, std::size_t most = std::string_view::npos);

bool is_verb(std::string_view word);  // of the language
// Whether a bracket or a """ is open.
bool goes_on(std::string_view text);

}  // namespace betwixt

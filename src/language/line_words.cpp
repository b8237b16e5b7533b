// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/line_words.h"

namespace betwixt {

std::vector<std::string> line_words(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  std::vector<std::string> words;
  for (std::size_t i = 0; i < line.size();) {
    if (blank(line[i])) {
      ++i;
      continue;
    }
    if (line[i] == '#' && (i + 1 == line.size() || blank(line[i + 1]))) break;
    std::string word;
    if (line[i] == '"') {
      const std::size_t close = line.find('"', i + 1);
      word = line.substr(i + 1, close == std::string_view::npos ? close : close - i - 1);
      i = close == std::string_view::npos ? line.size() : close + 1;
    } else {
      for (int braces = 0; i < line.size() && (braces > 0 || !blank(line[i])); ++i) {  // {a,b} is one word
        braces += line[i] == '{' ? 1 : line[i] == '}' ? -1 : 0;
        word += line[i];
      }
    }
    words.push_back(std::move(word));
  }
  return words;
}

std::string_view first_word(std::string_view text) {
  std::size_t from = 0;
  while (from < text.size() && blank(text[from])) ++from;
  std::size_t to = from;
  while (to < text.size() && !blank(text[to]) && text[to] != '\n') ++to;
  return text.substr(from, to - from);
}

}  // namespace betwixt

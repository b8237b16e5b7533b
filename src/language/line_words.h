// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Splits a line into words without interpreting it: for words outside the language, and to find the subject of a line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

inline bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }
inline bool starts_like_time(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }
inline bool indented(std::string_view line) { return !line.empty() && blank(line[0]); }

// Returns the words of a text's first line, separated by blanks or in double quotes. Skips comments.
std::vector<std::string> line_words(std::string_view text);
std::string_view first_word(std::string_view text);  // between blanks, of any kind

}  // namespace betwixt

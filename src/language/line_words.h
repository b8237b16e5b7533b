// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A line taken apart without understanding it: for words that are not of the language, and to see what a line is about.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

inline bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }
inline bool starts_like_time(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.'; }
inline bool indented(std::string_view line) { return !line.empty() && blank(line[0]); }

// Of the first line of a text: what stands between blanks, or in double quotes; a comment is none.
std::vector<std::string> line_words(std::string_view text);
std::string_view first_word(std::string_view text);  // between blanks, whatever it is

}  // namespace betwixt

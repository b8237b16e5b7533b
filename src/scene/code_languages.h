// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The languages of code blocks, and their words.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

// What a piece of code is. `name` and what has no other class is drawn by the block itself, the others by parts of it.
enum class CodeClass : std::uint8_t { name, keyword, type, function, string, number, comment, sign };
inline constexpr std::array<std::string_view, 8> code_class_names{"",       "keyword", "type",    "function",
                                                                  "string", "number",  "comment", "sign"};

// A language, as far as colors need it. Lists are words between blanks.
struct CodeLanguage {
  std::string_view name = {};
  std::string_view keywords = {}, types = {};  // `types`: also constants of the language
  std::string_view line_comments = {};         // each begins one up to the end of the line
  std::string_view block_comment = {};         // how it begins and ends
  std::string_view quotes = {};                // signs around texts that end in their line
  std::string_view long_quotes = {};           // the same for texts of several lines
  char key = 0;                                // the sign after a key: of JSON, a colon
  bool capitals = false;                       // names with a capital are types
  bool any_case = false;                       // keywords may have capitals
  bool dashes = false;                         // names may contain dashes
  bool markup = false;                         // tags between < and >
};

inline constexpr std::string_view code_font = "DejaVu Sans Mono";

// Returns the language of this name; nullptr if there is none.
const CodeLanguage* find_code_language(std::string_view name);
// Returns all names in the form of FunctionSpec::words: "bash|c|…".
std::string_view code_language_words();
// Returns whether the list has the word.
bool has_code_word(std::string_view list, std::string_view word, bool any_case);

// The size of a text in a font of fixed width, in letters. An empty text has one line.
struct CodeExtent {
  double columns = 0, lines = 1;
};
CodeExtent code_extent(std::string_view text);

// A word, or a sign of its own, at a place in a text. Comments and texts in quotes are split into words too.
struct CodeToken {
  std::size_t at = 0, size = 0;  // bytes
  CodeClass is = CodeClass::name;
};
// Returns the tokens of a text in order, without blanks. An unknown language has words and signs without classes.
std::vector<CodeToken> code_tokens(std::string_view text, std::string_view language);

}  // namespace betwixt

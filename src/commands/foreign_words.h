// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words from other tools that this language does not have, each with a pointer to its equivalent here.
#pragma once

#include <span>
#include <string_view>

#include "betwixt/result.h"
#include "scene/document.h"

namespace betwixt {

struct ForeignWord {
  std::string_view word;
  std::string_view leads;  // the equivalent, in the words of a hint
  std::string_view see;    // the words of the language that explain more, separated by blanks
};

std::span<const ForeignWord> foreign_words();
// Returns the equivalent of the word, or "" if it has no row.
std::string_view foreign_word_hint(std::string_view word);
// Returns the hint for a parameter, or a function, that a kind has not: what does the same, a similar name, or the
// kinds that have it.
Hint missing_parameter_hint(const Scene&, Kind, std::string_view name);

}  // namespace betwixt

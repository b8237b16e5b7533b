// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Names, shell patterns and suggestions for misspelt words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

// Returns true for a name: a letter, then letters, digits, '-', '_' and '/' (not at an end, not doubled).
bool is_name(std::string_view);
bool is_pattern(std::string_view);  // has one of * ? [ {

// Expands {a,b} and {1..100}, in the order written; at most `most` results. Errors: syntax, range.
Result<std::vector<std::string>> expand_braces(std::string_view pattern, std::size_t most = 1'000'000);
// Returns how many alternatives each {…} of a pattern has, the leftmost first; the last one varies fastest. Braces must
// not be nested. Returns an empty list if there are none.
std::vector<std::size_t> brace_ranges(std::string_view pattern);
// Returns true if a pattern with * ? [a-c] matches; * and ? do not match '/' and '.'. The pattern has no braces left.
bool matches(std::string_view pattern, std::string_view name);

// Returns a text as a piece of a name: letters without accents, digits, - and _; a blank is -. Returns "" if no
// character of the text can be in a name. "São Paulo" is Sao-Paulo.
std::string key_word(std::string_view text);

// Orders ball2 before ball10: runs of digits compare as numbers.
bool natural_less(std::string_view a, std::string_view b);

// Returns whether two words are the same but for capitals, - and _, as FadeIn and fade-in are.
bool same_letters(std::string_view, std::string_view);
// Returns the hint "did you mean 'sphere'?".
Hint correction(const std::string& word);
// Returns that hint if a candidate is similar to `word`, otherwise an empty one.
Hint did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates);
// Return the error that no object, twerper … has this name, and that a pattern matches nothing.
Error unknown_name(std::string_view kind, std::string_view name, Hint hint = {});
Error nothing_named(std::string_view pattern);

}  // namespace betwixt

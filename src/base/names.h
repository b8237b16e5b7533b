// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Names, shell patterns and near misses.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

// A letter, then letters, digits, '-', '_' and '/' (not at an end, not doubled).
bool is_name(std::string_view);
bool is_pattern(std::string_view);  // has one of * ? [ {

// {a,b} and {1..100} written out, in the order written; at most `most` results. Errors: syntax, range.
Result<std::vector<std::string>> expand_braces(std::string_view pattern, std::size_t most = 1'000'000);
// How many each {…} of a pattern stands for, the leftmost first, where none is inside another: the last one runs
// fastest. Empty where there are none.
std::vector<std::size_t> brace_ranges(std::string_view pattern);
// * ? [a-c]; neither * nor ? crosses '/' or '.'. The pattern has no braces left.
bool matches(std::string_view pattern, std::string_view name);

// ball2 before ball10: runs of digits compare as numbers.
bool natural_less(std::string_view a, std::string_view b);

// "did you mean 'sphere'?" where one of the candidates is a near miss of `word`; otherwise empty.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace betwixt

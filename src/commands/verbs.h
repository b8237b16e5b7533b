// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// All verbs. Their rows are in the files of their bodies, one file for each family.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "commands/command.h"

namespace betwixt {

const std::vector<Verb>& verbs();
const Verb* find_verb(std::string_view word);                  // nullptr if there is none
std::vector<std::string_view> verb_words(unsigned flags = 0);  // of the verbs that have all these flags

// Returns the words of Verb::words that can be at a place, counted from 0.
std::string_view words_at(std::string_view words, std::size_t place);
// Returns whether one of these words is that one.
bool has_word(std::string_view words, std::string_view one);

// Words of the tools around a script (the shell), which a script can neither use nor take as names.
std::span<const std::string_view> reserved_words();

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// All verbs. Their rows stand beside their bodies, a family in a file.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "commands/command.h"

namespace betwixt {

const std::vector<Verb>& verbs();
const Verb* find_verb(std::string_view word);                  // null: there is none
std::vector<std::string_view> verb_words(unsigned flags = 0);  // of those that have these

// Words of those around a script (the shell), which a script neither knows nor names anything by.
std::span<const std::string_view> reserved_words();

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Help: every word of the language and of the shell, with a sentence, how it is written, and an example.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document.h"

namespace betwixt {

enum class HelpGroup { shell, verb, row, kind, function, twerper, filter, option };

struct HelpEntry {
  HelpGroup group;
  std::string_view word, sentence;
  std::string_view usage;
  std::string_view example;  // lines that can be entered one after another
};

std::span<const HelpEntry> help_entries();
std::vector<std::string_view> words_with_help();  // including those that only lead to other words; for near misses
std::vector<HelpEntry> shell_entries();           // of the words that only the shell has

// Returns the sentence about a word, or about a key with its sign; "" if it is unknown.
std::string_view sentence_of(std::string_view word);
// Returns all words by groups, a line each, with the film's own words.
std::string help_overview(const Scene&, bool of_the_shell = true);
// Returns all that is known about a word; "" if it is unknown.
std::string help_text(std::string_view word, const Scene&);

}  // namespace betwixt

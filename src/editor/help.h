// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Help: every word of the language and of the shell, with a sentence, how it is written, and an example.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/document.h"

namespace betwixt {

enum class HelpGroup { shell, verb, row, kind, function, twerper, filter, option };
std::string_view word_of(HelpGroup);  // "kinds": `help kinds` lists them

struct HelpEntry {
  HelpGroup group;
  std::string_view word, sentence;
  std::string_view usage;
  std::string_view example;                // lines that can be entered one after another
  const FunctionSpec* function = nullptr;  // of a function that can be set; kinds may have others of the same name
};

std::span<const HelpEntry> help_entries();
std::vector<std::string_view> words_with_help();  // including those that only lead to other words; for near misses
std::vector<HelpEntry> shell_entries();           // of the words that only the shell has

// Returns "every object", or the kinds that have the function: "polyline, curve".
std::string owners_of(const FunctionSpec&);
// Returns the sentence about a word or a key ("size="); "" if it is unknown. Kinds have functions of one name and
// different meanings, so the sentence about a function, as a key or in a target ("ball.size"), needs the kind.
std::string_view sentence_of(std::string_view word, std::optional<Kind> = {});
std::string_view sentence_of(const FunctionView&);  // "" if the author has defined the function
// Returns all words by groups, a line each, with the film's own words.
std::string help_overview(const Scene&, bool of_the_shell = true);
// Returns all that is known about a word; "" if it is unknown. With a kind, functions are those of that kind.
std::string help_text(std::string_view word, const Scene&, std::optional<Kind> = {});

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The words that plug-ins brought to this process, and which words are taken.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/document.h"

namespace betwixt {

// Gives the scene the words that plug-ins brought.
void adopt_plugins(Scene&);
// What the plug-in says about a word of its own; empty: it says nothing, or no plug-in brought the word.
std::string plugin_help(std::string_view word);
// The plug-ins that a script seems to need: those with a word that stands in it.
std::vector<std::string> plugins_for(std::string_view script);
std::vector<std::string> plugins_loaded();  // all that brought any words

// What a procedure's name would be mistaken for: "a command", "a twerper", …; empty: the name is free.
std::string_view taken_by(std::string_view name, Role);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The words that plug-ins brought to this process, and which words are taken.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "procedure/plugins.h"
#include "scene/document.h"

namespace betwixt {

// Adds the plug-ins' words to the scene.
void adopt_plugins(Scene&);
// Returns the lines that make the model of a plug-in's kind, or nullopt if no plug-in brought it.
std::optional<std::string> plugin_kind(std::string_view name);
std::vector<std::string> plugin_kinds();  // the names of all
std::optional<PluginRenderer> plugin_renderer(std::string_view name);
std::vector<PluginRenderer> plugin_renderers();
// Returns the plug-in's help for one of its words, or "" if it has none or no plug-in brought the word.
std::string plugin_help(std::string_view word);
// Returns the plug-ins that have a word which occurs in the script.
std::vector<std::string> plugins_for(std::string_view script);
std::vector<std::string> plugins_loaded();  // all that brought any words

// Returns the meaning that the name already has ("a command", "a twerper", …), or "" if it is free.
std::string_view taken_by(std::string_view name, Role);

}  // namespace betwixt

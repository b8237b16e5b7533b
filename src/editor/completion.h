// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Completion of the last word of a line, at the shell and in a script editor.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/object.h"

namespace betwixt {

// The context of a line.
struct LineAround {
  bool in_shell = false;                  // complete the words of the shell too
  bool sheet_open = false, list = false;  // rows may follow; the sheet is a display list
  std::string sheet = {};                 // the target of the sheet
  std::filesystem::path folder = ".";     // file names are relative to it
  std::vector<std::string> styles = {};   // the styles that exist
};

// Returns the offset at which the last word of a line begins.
std::size_t begun_word(std::string_view line);
// Returns whether the last word of a line can be a target, so that a dot follows the name of an object.
bool takes_target(std::string_view line);
// Returns the kind of the object whose function the last word names: that before its dot, or that of the kind that the
// line names before its parameters. Returns nullopt if there is none.
std::optional<Kind> kind_at(std::string_view line, const Document&);
// Returns all completions of the last word, sorted.
std::vector<std::string> completions(std::string_view line, const Document&, const LineAround&);

}  // namespace betwixt

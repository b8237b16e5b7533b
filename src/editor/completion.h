// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the last word of a line can become, at a shell and in a script that somebody writes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// Where a line stands.
struct LineAround {
  bool in_shell = false;                  // its words count too
  bool sheet_open = false, list = false;  // rows may follow; those of a display list
  std::string sheet = {};                 // the target of the sheet
  std::filesystem::path folder = ".";     // in which files are looked for
  std::vector<std::string> styles = {};   // that there are
};

// Where the last word of a line begins.
std::size_t begun_word(std::string_view line);
// All that it can become, in order.
std::vector<std::string> completions(std::string_view line, const Document&, const LineAround&);

}  // namespace betwixt

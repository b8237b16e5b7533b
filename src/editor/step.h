// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What was done, in words.
#pragma once

#include <string>
#include <vector>

namespace betwixt {

// Commands that were carried out together, as they stand in a history.
struct Step {
  std::vector<std::string> lines;
  std::string sheet;  // the lines that stand above their rows there, unless they do already; may be empty
};

enum class Did : char { command = 'c', undo = 'u', redo = 'r', save = 's' };  // save: a file holds all that stands

}  // namespace betwixt

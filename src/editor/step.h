// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What was done, in words.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

// Commands that were carried out together, as they stand in a history.
struct Step {
  std::vector<std::string> lines;
  std::string sheet;  // the lines that stand above their rows there, unless they do already; may be empty
  friend bool operator==(const Step&, const Step&) = default;
};

// save: a file holds all that stands; checkpoint: it may begin anew with another text, that of the first steps.
enum class Did : char { command = 'c', undo = 'u', redo = 'r', save = 's', checkpoint = 'k' };

// Whether its rows go on below the step above it, whose sheet they share.
bool stands_below(const Step&, const Step* above);
// The lines of a history, each by itself: rows follow those of their sheet, unless they already stand below them.
std::vector<std::string> lines_of(const Step&, const Step* above);
std::size_t bytes_of(const Step&);   // of its text
std::size_t memory_of(const Step&);  // of the step and all that it holds

// A script: the author's text, and below it every step.
std::string as_script(std::string_view base, std::span<const Step> steps);

// A step as one text: a line as it is; of more, the sheet and then each line, with a zero between two, which no line
// has.
std::string packed(const Step&);
Step unpacked(std::string_view);

}  // namespace betwixt

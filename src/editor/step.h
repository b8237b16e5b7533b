// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A step of the history, as text.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

struct TrackRows;

// Commands that were carried out together, as a history records them.
struct Step {
  std::vector<std::string> lines;
  std::string sheet;  // opener lines above the rows, unless they are there already; may be empty
  std::shared_ptr<const TrackRows> rows = {};                  // further lines, as numbers; may be null
  friend bool operator==(const Step&, const Step&) = default;  // two steps with rows share them
};

// save: a file holds all standing steps; checkpoint: a file may begin with a new text that contains the first steps.
enum class Did : char { command = 'c', undo = 'u', redo = 'r', save = 's', checkpoint = 'k' };

// Returns true if the step's rows continue those of the step above, as both have the same sheet.
bool stands_below(const Step&, const Step* above);
// Returns the lines of a step one by one: its sheet first, unless the step continues the one above.
std::vector<std::string> lines_of(const Step&, const Step* above);
std::size_t bytes_of(const Step&);   // of its text
std::size_t memory_of(const Step&);  // of the step and all that it owns

// Returns the author's text, followed by every step.
std::string as_script(std::string_view base, std::span<const Step> steps);

// Packs a step into one text for the journal. A single line stays as it is. Otherwise it is the sheet and the lines,
// separated by a zero byte, which no line contains.
std::string packed(const Step&);
Step unpacked(std::string_view);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The line of a script that opens a section, and that line with another beginning, length or speed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace betwixt::studio {

struct SectionLine {
  int number = 0;  // in the script; the first is 1
  std::string text;
};
// Returns nullopt if the script does not have the line: the section is in a file that it uses.
std::optional<SectionLine> section_line(std::string_view script, std::string_view name);

// Return the line with `at TIME` in place of what it says of its beginning, with another length, with another speed.
std::string section_at(std::string_view line, std::string_view time);
std::string section_for(std::string_view line, std::string_view length);
std::string section_speed(std::string_view line, double speed);
bool section_has_length(std::string_view line);

}  // namespace betwixt::studio

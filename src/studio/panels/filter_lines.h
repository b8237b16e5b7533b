// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The filters of a function, each with the line of the script that says it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/functions.h"
#include "studio/panels/value_parts.h"

namespace betwixt::studio {

struct FilterLine {
  std::string name;
  int component = -1;
  std::size_t index = 0;  // among the filters of the film; of a comment, the number of those before it
  bool off = false;       // it does not act: its line has the word `off`, or is a comment
  bool comment = false;
  std::string words;  // as a line of the language, without a comment
  Span line;          // its line without the line feed; its size is 0 if it is not known
  bool own = false;   // the line is of this target only
};
// Returns the filters of a function, on the target's layer, in the order in which they act; those that are off too.
std::vector<FilterLine> filter_lines(const Document&, const std::string& text, const Target&);
// Returns the lines that make all filters of a function on the target's layer, for this target alone.
std::vector<std::string> own_filter_lines(const Document&, const Target&);
// Returns the length of "# " in front of a line that is a comment; otherwise 0.
std::size_t comment_sign(std::string_view line);
// Returns the parameters of a filter, with the numbers as its line writes them.
std::vector<PartField> fields_of(const FilterLine&, const FunctionSpec&);
// Returns a line in which a parameter has another value.
std::string with_parameter(std::string_view line, const std::string& key, const std::string& value);
// Returns a line with the word `off` or without it.
std::string with_off(std::string_view line, bool off);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts that make the value of a function, in the order in which they act: what is set, code, events, velocities,
// filters, layers. Each part knows its place in the script, so that an edit changes the author's own line.
#pragma once

#include <string>
#include <vector>

#include "studio/timeline/event_lines.h"
#include "syntax/script_text.h"

namespace betwixt::studio {

// A parameter of a part, as text of the language.
struct PartField {
  std::string key = {};                   // "width"; "weight" of a layer; "" for the part's own value
  std::vector<std::string> numbers = {};  // one for each component; code has one text
  std::string unit = {};                  // of numbers without one
  double low = -1e300, high = 1e300;
  bool text = false;
  bool operator==(const PartField&) const = default;
};

struct ValuePart {
  enum class What : std::uint8_t { set, code, events, velocity, filter, layer };
  What what = What::set;
  Target target = {};  // the track of the part
  std::string title = {}, sentence = {};
  std::vector<PartField> fields = {};
  std::size_t index = 0;  // of a filter, among those that its track has
  bool off = false;       // it does not act: its line has the word `off`, or is a comment
  bool comment = false;
  // The lines that say it; the size is 0 if no line says it alone: a pattern, a copy of an object, a file.
  Span lines = {};
  bool own = false;                // these lines say it of this target only
  std::vector<EventAt> keys = {};  // of events, velocities and layers
};

// `whole` is a function of an object, without component and layer.
std::vector<ValuePart> value_parts(const Document&, const Program&, const std::string& text, const Target& whole, Time);

// Return the lines of an edit; empty if it changes nothing or cannot be made.
// A number of a field: of all numbers, or of one.
Lines change_part(const Document&, const std::string& text, const ValuePart&, const PartField&, std::size_t number,
                  const std::string& typed, Time);
Lines remove_part(const Document&, const std::string& text, const ValuePart&);
// Turns a filter off by the word `off`, and on again.
Lines switch_part(const Document&, const std::string& text, const ValuePart&);
// Moves a filter to the place of another one on the same track.
Lines move_part(const Document&, const std::string& text, const std::vector<ValuePart>&, std::size_t from,
                std::size_t to);

// Returns the line `rewrite …` that replaces a part of a text.
std::string rewriting_line(const std::string& text, Span, std::string_view by);
// Returns the number of the line of a place, from 1.
int line_number(const std::string& text, std::size_t place);

}  // namespace betwixt::studio

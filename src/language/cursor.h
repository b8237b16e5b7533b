// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads the basic elements of the language: white space, words, numbers, times, texts. A function that fails reports
// one error, at the place of the failure, and returns false; its caller then returns false, too.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "betwixt/result.h"
#include "betwixt/time.h"
#include "scene/quantity.h"
#include "scene/sections.h"
#include "scene/table.h"
#include "syntax/characters.h"

namespace betwixt {

struct Scene;

// Finds the beginning or the end of a section. Errors: name.
using SectionTimes = std::function<Result<Time>(std::string_view name, bool end)>;
// Returns whether a name and .start or .end begin at this place, as in intro.end+12f.
bool section_time_begins(const char* at, const char* end);

class Cursor {
 public:
  explicit Cursor(std::string_view text) : at(text.data()), end(text.data() + text.size()) {}

  const char* at;
  const char* end;
  int depth = 0;                          // open brackets; inside them a new line is white space
  std::array<const char*, 8> brackets{};  // where they were opened
  Rate rate, ticks{30, 1};                // the meaning of f and t
  bool frames_read = false;               // a time has been given in frames
  bool ticks_read = false;
  const Lets* lets = nullptr;  // the values of names in formulas
  const Tables* tables = nullptr;
  const Scene* moments = nullptr;  // whose sounds have words that are times
  PatternPlace place;
  bool cell_missing = false;               // a formula has read an empty cell of the place's row
  SectionClock clock;                      // that times and lengths are written in
  Time latest;                             // the latest time of the film that has been read
  std::optional<Time> last;                // the time that was read last in this line
  const SectionTimes* sections = nullptr;  // the times of sections by name

  // The first failure since the last clear. `where`: the text that it is about.
  std::optional<Error> error;
  std::string_view where;
  bool fail(ErrorCode code, std::string message, std::string_view about, Hint hint = {});
  // The same for an error of another function, with its correction; its place is not of this text.
  bool fail(Error, std::string_view about);
  bool fail_here(ErrorCode code, std::string message, Hint hint = {});

  void space();        // skips blanks, commas, comments; inside brackets also new lines
  bool at_line_end();  // after space(): whether the logical line ends here
  char peek() const { return at < end ? *at : '\n'; }
  // Takes a name, a pattern, a target or a verb. Commas inside braces belong to the word.
  std::string_view word();
  std::string_view next_word() { return space(), word(); }
  std::string_view since(const char* start) const { return {start, static_cast<std::size_t>(at - start)}; }
  std::string_view peek_word();
  bool accept_word(std::string_view w);  // takes the word if it is next
  bool accept(char c);                   // takes the character if it is next
  bool open();                           // (
  bool close();                          // )

  // Reads a plain number, without a formula.
  bool literal(double& out);
  // Reads a number, or a formula whose value is one.
  bool number(double& out);
  // The same, but a formula may have another type: then sets `formula`, and no unit follows.
  bool number(double& out, std::optional<Quantity>& formula);
  bool whole_number(long low, long high, const char* what, long& out);
  // Takes the letters directly after a number.
  std::string_view unit();
  bool text(std::string& out);  // "…" or """…"""
  // Reads a time, and returns that of the film.
  bool time(Time& out);
  // Reads a length, and returns that of the film.
  bool length(Time& out);
  // Reads a length that no section makes shorter, such as one of a recording.
  bool own_length(Time& out) { return time_or_length(out, true); }
  // Reads the length of what begins at the last time that was read.
  bool lasting(Time& out);
  // Takes note that the text speaks of this time of the film.
  void reaches(Time t) { latest = std::max(latest, t); }
  bool segment(Time& from, Time& to);  // A..B
  bool angle(double& radians);
  bool number_or_angle(double& out, bool& is_angle);  // angles in radians
  bool opening(double& seconds);                      // of a shutter: an angle (a turn is a frame), a length, or off
  bool per_second(Rate& out, const char* what);       // 24, 23.976, 30000/1001 …

 private:
  bool section_time(Time& out);
  bool time_or_length(Time& out, bool length);
  bool store(Time& out, long double seconds, const char* start);
  bool from_formula(const Quantity&, bool length, Time& out, const char* start);
  bool clock_time(Time& out, const char* start, bool negative);
};

// Quotes a token for a message, shortened if it is long.
std::string quoted_word(std::string_view);
// Returns the hint for a backslash that a text cannot have, or that means something else; the text begins with it.
std::string hint_of_escape(std::string_view);
// Returns whether the text contains the word, not as a part of another word.
bool stands_in(std::string_view text, std::string_view word);

}  // namespace betwixt

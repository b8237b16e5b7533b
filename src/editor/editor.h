// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How a document goes on: a line is carried out on a copy, and taken; what was taken can be taken back and done again.
// It is the same for a person at a shell and for the hosts of a server. Who keeps what was done hangs a sink on it.
#pragma once

#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "commands/reader.h"
#include "editor/step.h"

namespace betwixt {

// What can be gone back to: a document and what the next line must know, the sheet that is open among it.
struct Point {
  Document document;
  SoFar script;
};

// What a line does. Nothing has changed yet.
struct Deed {
  bool done = false;  // else the line is wrong: `said` tells why
  Point after;
  std::string line;      // as it stands in a history
  std::string sheet;     // what it stands below there: it is a row
  bool stamped = false;  // it happens at a time because it came then
  bool opens = false;    // a sheet is open behind it that was not before
  Diagnostics said;      // a place without a file is of the line itself
};

class Editor {
 public:
  // Is told before a step is taken, taken back or done again; where it cannot keep it, nothing is done. `standing`:
  // the steps before it.
  using Sink = std::function<Status(Did, const Step&, std::span<const Step> standing)>;
  static constexpr std::size_t without_limit = std::numeric_limits<std::size_t>::max();

  // `depth`: so many steps can be taken back. What was said is kept of all, the documents before only of these.
  explicit Editor(LoadOptions options = {}, std::size_t depth = without_limit)
      : options_(std::move(options)), depth_(depth) {}

  // Begins with the author's text; the sink is told nothing. `name`: the file that it stands in, may be empty.
  Diagnostics begin(std::string text, const std::string& name);
  void keep(Sink sink) { sink_ = std::move(sink); }
  void rename(const std::string& name) { home_ = Home(name); }
  void allow(const LoadOptions& options) { options_ = options; }

  const Point& now() const { return now_; }
  const std::string& base() const { return base_; }                           // the author's text
  std::span<const Step> steps() const { return {steps_.data(), standing_}; }  // that stand …
  std::span<const Step> undone() const {
    return {steps_.begin() + static_cast<std::ptrdiff_t>(standing_), steps_.end()};
  }

  // A line as somebody says it: a command, or a row of the sheet that is open. `now`: the time at which commands
  // happen that are said by a live host (LoadOptions::now).
  // `translated`: values that mean nothing where they stand are translated, and the deed's line says what came of it.
  Deed carry_out(const Point& from, std::string_view line, std::optional<Time> now = {}, bool translated = false) const;

  // The sink's errors.
  Status take(Point after, Step step);
  // Errors: range (there is nothing to take back, or no document of that time), the sink's.
  Status undo();
  Status redo();

 private:
  Status tell(Did what, const Step& step, std::size_t standing) const;

  LoadOptions options_;
  std::size_t depth_;
  Sink sink_;
  Home home_;
  std::string base_;
  Point now_;
  std::vector<Step> steps_;
  std::size_t standing_ = 0;
  std::deque<Point> before_;   // the last of the steps that stand
  std::vector<Point> undone_;  // after the steps that do not; the next one is the last
};

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How a document goes on: a line is carried out on a copy, and taken; what was taken can be taken back and done again.
// It is the same for a person at a shell and for the hosts of a server. Who keeps what was done hangs a sink on it.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "commands/reader.h"
#include "editor/step.h"

namespace betwixt {

// How much a document holds.
struct Counts {
  std::size_t events = 0, values = 0;  // bytes of these
};

// What can be gone back to: a document and what the next line must know, the sheet that is open among it.
struct Point {
  Document document;
  SoFar script;
  std::optional<Counts> counts = {};  // of the document, where they are known
};

// What a line does. Nothing has changed yet.
struct Deed {
  bool done = false;  // else the line is wrong: `said` tells why
  Point after;
  std::string line;         // as it stands in a history
  std::string sheet;        // what it stands below there: it is a row
  bool stamped = false;     // it happens at a time because it came then
  bool opens = false;       // a sheet is open behind it that was not before
  std::size_t touched = 0;  // how many its pattern named, where that is more than one
  Diagnostics said;         // a place without a file is of the line itself
};

// A step of an earlier session that cannot be carried out any more.
struct LeftOut {
  std::size_t number = 0;  // of the step, from 0
  Step step;
  Diagnostics why;
};

// So many steps can be taken back, and no more than hold so many bytes, by estimate; the last one always can.
struct UndoDepth {
  static constexpr std::size_t without_limit = std::numeric_limits<std::size_t>::max();
  std::size_t steps = without_limit, bytes = without_limit;
};

class Editor {
 public:
  // Is told before a step is taken, taken back or done again; where it cannot keep it, nothing is done.
  using Sink = std::function<Status(Did, const Step&)>;

  // What was said is kept of all, the documents before only of those that can be taken back.
  explicit Editor(LoadOptions options = {}, UndoDepth depth = {}) : options_(std::move(options)), depth_(depth) {}

  // Begins with the author's text; the sink is told nothing. `name`: the file that it stands in, may be empty.
  Diagnostics begin(std::string text, const std::string& name);
  // A text as if it were the author's. What it has in common with the document now, both share, and files that this one
  // names too are as they were when they were read.
  Point read(std::string_view text, Diagnostics&) const;
  void keep(Sink sink) { sink_ = std::move(sink); }
  // Frees the points that undo and redo cannot reach any more. Without it, they are freed at once.
  void free_with(std::function<void(Point)> free) { free_ = std::move(free); }
  void rename(const std::string& name) { home_ = Home(name); }
  void allow(const LoadOptions& options) { options_ = options; }

  const Point& now() const { return now_; }
  void count(const Counts& counts) { now_.counts = counts; }                  // of the document that there is
  const std::string& base() const { return base_; }                           // the author's text
  std::span<const Step> steps() const { return {steps_.data(), standing_}; }  // that stand …
  std::span<const Step> undone() const {
    return {steps_.begin() + static_cast<std::ptrdiff_t>(standing_), steps_.end()};
  }

  // A line as somebody says it: a command, or a row of the sheet that is open. `now`: the time at which commands
  // happen that are said by a live host (LoadOptions::now).
  // `translated`: values that mean nothing where they stand are translated, and the deed's line says what came of it.
  Deed carry_out(const Point& from, std::string_view line, std::optional<Time> now = {}, bool translated = false) const;
  // A step of a history, on what there is now: all its lines, below its sheet. On failure what is said is of one line.
  Deed carry_out(const Step&) const;
  // Carries out the steps of an earlier session. The first `standing` of them stand, the others were undone. The sink
  // hears nothing. Returns the steps that fail among those that stand; they are left out. A step that fails among those
  // that were undone is forgotten, with all behind it.
  std::vector<LeftOut> restore(std::span<const Step> steps, std::size_t standing);

  // Bytes that undo keeps for a step between the two. This may take long, so it can be called before take().
  static std::size_t bytes_kept(const Point& before, const Point& after);
  // The sink's errors. `bytes`: those that undo keeps for it, where they are known.
  Status take(Point after, Step step, std::optional<std::size_t> bytes = {});
  // Errors: range (there is nothing to take back, or no document of that time), the sink's.
  Status undo();
  Status redo();

  // Steps that cannot be taken back any more, and the document behind them.
  std::size_t settled() const { return standing_ - before_.size(); }
  const Document& settled_document() const { return (before_.empty() ? now_ : before_.front().point).document; }
  // So many of them become a part of the author's text; these.
  std::vector<Step> settle(std::string base, std::size_t steps);
  std::size_t undo_bytes() const { return bytes_; }

 private:
  // A point that can be gone to, and what is kept for its sake beside its neighbour on the way to now.
  struct Past {
    Point point;
    std::size_t bytes = 0;
  };
  Status tell(Did what, const Step& step) const { return sink_ ? sink_(what, step) : Status(Nothing{}); }
  void push(Point after, Step step, std::optional<std::size_t> bytes = {});
  void forget(Past& past);
  // Carries out lines of a history on one copy of a document. Returns nullopt if one of them fails.
  std::optional<Point> carried_out(const Point& from, const std::string& lines) const;
  void settle_all(std::span<const Step> steps, std::size_t number, std::vector<LeftOut>& left_out);
  const Step* last_step() const { return standing_ > 0 ? &steps_[standing_ - 1] : nullptr; }
  void step_back();
  void shorten();

  LoadOptions options_;
  UndoDepth depth_;
  Sink sink_;
  std::function<void(Point)> free_;
  Home home_;
  std::string base_;
  Point now_;
  std::vector<Step> steps_;
  std::size_t standing_ = 0;
  std::deque<Past> before_;   // the last of the steps that stand
  std::vector<Past> undone_;  // after the steps that do not; the next one is the last
  std::size_t bytes_ = 0;     // of both
  bool heavy_ = false;        // steps were forgotten as they held too much
};

}  // namespace betwixt

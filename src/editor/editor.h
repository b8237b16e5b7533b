// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The undo stack of a document. A command is carried out on a copy, then taken; it can be undone and redone. A step
// stands until it is undone. The shell and the clients of a server use the same editor. A sink may record every step.
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

// The size of a document.
struct Counts {
  std::size_t events = 0, values = 0;  // values: in bytes
};

// A state to which the editor can return: a document, and the state of the reader behind it with its open sheet.
struct Point {
  Document document;
  ReaderState script;
  std::optional<Counts> counts = {};  // of the document; nullopt if not counted yet
};

// The result of a line that was carried out on a copy. The editor itself has not changed.
struct CommandResult {
  bool done = false;  // if false, the line is wrong and `said` has the diagnostics
  Point after;
  std::string line;         // as the history records it
  std::string sheet;        // the sheet's lines, if the line is a row
  bool stamped = false;     // the time in `line` is the time at which it came
  bool opens = false;       // the line opens a sheet
  bool empty = false;       // the line has no command
  std::size_t touched = 0;  // the number of things its pattern matches, if more than one
  Diagnostics said;         // a diagnostic without a file is about the line itself
};

// A step of an earlier session that can no longer be carried out.
struct FailedStep {
  std::size_t number = 0;  // of the step, from 0
  Step step;
  Diagnostics why;
};

// The limits of undo: a number of steps, and an estimate of the bytes that they hold. The last step can always be
// undone.
struct UndoLimits {
  static constexpr std::size_t without_limit = std::numeric_limits<std::size_t>::max();
  std::size_t steps = without_limit, bytes = without_limit;
};

class Editor {
 public:
  // Receives each step before it is taken, undone or redone. If the sink fails, nothing changes.
  using Sink = std::function<Status(Did, const Step&)>;

  // The editor keeps the text of all steps, but earlier documents only within the limits of `depth`.
  explicit Editor(LoadOptions options = {}, UndoLimits depth = {}) : options_(std::move(options)), depth_(depth) {}

  // Begins with the author's text; the sink gets nothing. `name`: the name of its file, or "".
  Diagnostics begin(std::string text, const std::string& name);
  // Reads a text in place of the author's. The result shares with the current document all that is equal, and uses the
  // files that both name as they were when they were read first.
  Point read(std::string_view text, Diagnostics&) const;
  void keep(Sink sink) { sink_ = std::move(sink); }
  // Frees the points that undo and redo cannot reach any more. Without it, they are freed at once.
  void free_with(std::function<void(Point)> free) { free_ = std::move(free); }
  void rename(const std::string& name) { home_ = Home(name); }
  void allow(const LoadOptions& options) { options_ = options; }

  const Point& now() const { return now_; }
  void count(const Counts& counts) { now_.counts = counts; }                  // of the current document
  const std::string& base() const { return base_; }                           // the author's text
  std::span<const Step> steps() const { return {steps_.data(), standing_}; }  // not undone
  std::span<const Step> undone() const { return std::span<const Step>(steps_).subspan(standing_); }

  // Carries out a line: a command, or a row of the open sheet. `now`: the time of commands from a live client
  // (LoadOptions::now). `translated`: translates values that have no meaning at their place; the line of the result has
  // the translation.
  CommandResult carry_out(const Point& from, std::string_view line, std::optional<Time> now = {},
                          bool translated = false) const;
  // Carries out lines at once; nullopt if there is a message about one of them, also if it is only a notice.
  std::optional<Point> carried_out(const Point& from, const std::vector<std::string>& lines) const;
  // Carries out a step of a history on the current document: its sheet, then all its lines. If one line fails, the
  // diagnostics are about that line.
  CommandResult carry_out(const Step&) const;
  // Carries out the steps of an earlier session: `standing` steps, then those that were undone. The sink gets nothing.
  // Returns the standing steps that fail; they are left out. An undone step that fails is forgotten, with all behind
  // it.
  std::vector<FailedStep> restore(std::span<const Step> steps, std::size_t standing);

  // Carries out lines one after the other on one copy of a document. Some parts of a document are copied as a whole
  // when they change (notes, aliases, names in formulas, functions, display lists): here once, not for each line.
  class Draft {
   public:
    Draft(const Editor& editor, const Point& from)
        : editor_(&editor), scene_(from.document.scene()), script_(from.script) {}
    // Like Editor::carry_out(), for a line that has a command or is a row. The result has no `after`.
    CommandResult carry_out(std::string_view line, std::optional<Time> now) {
      return editor_->carry_out_on(scene_, script_, line, now, false);
    }
    const Scene& scene() const { return scene_; }
    bool sheet_is_open() const { return script_.left != nullptr; }
    void close_sheet() { script_.left.reset(); }
    Point point() &&;

   private:
    const Editor* editor_;
    Scene scene_;
    ReaderState script_;
  };

  // Returns the bytes that undo keeps for a step between the two. This may take long, so you can call it before take().
  static std::size_t bytes_kept(const Point& before, const Point& after);
  // Errors: those of the sink. `bytes`: the bytes that undo keeps for the step, if you know them already.
  Status take(Point after, Step step, std::optional<std::size_t> bytes = {});
  // Errors: range (nothing to undo, or its document is no longer kept), those of the sink.
  Status undo();
  Status redo();

  // Steps that can no longer be undone, and the document behind them.
  std::size_t settled() const { return standing_ - before_.size(); }
  const Document& settled_document() const { return (before_.empty() ? now_ : before_.front().point).document; }
  // Makes the first `steps` steps a part of the author's text, which is now `base`. Returns them.
  std::vector<Step> settle(std::string base, std::size_t steps);
  std::size_t undo_bytes() const { return bytes_; }

 private:
  // A state in the undo stack, and the bytes that it holds beyond its neighbour towards the current state.
  struct Past {
    Point point;
    std::size_t bytes = 0;
  };
  Status tell(Did what, const Step& step) const { return sink_ ? sink_(what, step) : Status(Nothing{}); }
  void push(Point after, Step step, std::optional<std::size_t> bytes = {});
  void forget(Past& past);
  // Carries out a line on this scene, which may be left changed if the line fails. Returns a result without `after`.
  CommandResult carry_out_on(Scene&, ReaderState&, std::string_view line, std::optional<Time> now,
                             bool translated) const;
  // Carries out lines of a history on one copy of a document. Returns nullopt if one of them fails.
  std::optional<Point> carried_out(const Point& from, const std::string& lines, Diagnostics& said) const;
  void settle_all(std::span<const Step> steps, std::size_t number, std::vector<FailedStep>& left_out);
  const Step* last_step() const { return standing_ > 0 ? &steps_[standing_ - 1] : nullptr; }
  void step_back();
  void shorten();

  LoadOptions options_;
  UndoLimits depth_;
  Sink sink_;
  std::function<void(Point)> free_;
  Home home_;
  std::string base_;
  Point now_;
  std::vector<Step> steps_;
  std::size_t standing_ = 0;
  std::deque<Past> before_;   // of the last standing steps; the newest is the last
  std::vector<Past> undone_;  // after the undone steps; the next redo is the last
  std::size_t bytes_ = 0;     // of before_ and undone_
  bool heavy_ = false;        // the last forgotten state was dropped because of its bytes
};

}  // namespace betwixt

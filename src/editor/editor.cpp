// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/editor.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/memory.h"
#include "scene/document.h"
#include "scene/memory.h"
#include "syntax/tokens.h"

namespace betwixt {

Diagnostics Editor::begin(std::string text, const std::string& name) {
  base_ = std::move(text), home_ = Home(name);
  steps_.clear(), before_.clear(), undone_.clear();
  standing_ = bytes_ = 0, heavy_ = false;
  Diagnostics all;
  now_ = {};
  now_ = read(base_, all);
  return all;
}

Point Editor::read(std::string_view text, Diagnostics& said) const {
  const Scene& now = now_.document.scene();
  Scene scene = with_files_of(now);
  SectionsAhead ahead;
  const auto make = [&] { return Script(scene, said, options_, {}, home_); };
  const ReaderState script =
      read_settled(scene, said, ahead, make, [&](Scene& s, Script& to) { read_text(s, to, text, home_.name); });
  share(scene, now);
  return {Document(std::make_shared<const Scene>(std::move(scene))), script};
}

CommandResult Editor::carry_out(const Point& from, std::string_view line, std::optional<Time> now,
                                bool translated) const {
  Scene scene = from.document.scene();
  ReaderState script = from.script;
  CommandResult result = carry_out_on(scene, script, line, now, translated);
  if (!result.done) return result;
  if (result.empty) script.left = from.script.left, script.blocks = from.script.blocks;  // a comment closes nothing
  result.after = {Document(std::make_shared<const Scene>(std::move(scene))), std::move(script)};
  return result;
}

Point Editor::Draft::point() && {
  return {Document(std::make_shared<const Scene>(std::move(scene_))), std::move(script_)};
}

CommandResult Editor::carry_out_on(Scene& scene, ReaderState& so_far, std::string_view line, std::optional<Time> now,
                                   bool translated) const {
  CommandResult result;
  const bool row = so_far.goes_on(line), below = so_far.belongs(line);
  if (row) result.sheet = so_far.left->opener;
  LoadOptions options = options_;
  options.now = now;
  Script script(scene, result.said, options, so_far, home_);
  so_far.left.reset();  // the sheet shares parts of the scene, which would be copied when they change
  script.spells_out = translated;
  const Policy policy = scene.policy;
  if (translated) scene.policy = Policy::translate;
  read_line(scene, script, line, home_.name);
  if (translated) scene.policy = policy;
  if (script.in_time && !in_reach(*now))  // the history would get a time that the reader refuses
    script.report(Severity::error,
                  fail(ErrorCode::range, "the present time is beyond the limit of 146 years (4.6e9 s)",
                       "seek an earlier time, or write one: at TIME …"),
                  {});
  for (Diagnostic& d : result.said)
    if (d.what.place.file == home_.name) d.what.place.file.clear();
  result.done = !has_errors(result.said);
  so_far = script;
  if (!result.done) return result;
  result.line = script.stamped();
  if (!below)
    result.line.erase(
        0, result.line.size() - without_indent(result.line).size());  // the history must not take it for a row
  result.stamped = !row && !translated && script.in_time;
  result.touched = script.touched;
  result.empty = !row && !script.verb;
  result.opens = !row && script.verb && script.left;
  return result;
}

std::optional<Point> Editor::carried_out(const Point& from, const std::vector<std::string>& lines) const {
  Diagnostics said;
  auto after = carried_out(from, fmt::format("{}", fmt::join(lines, "\n")), said);
  return said.empty() ? after : std::nullopt;
}

std::optional<Point> Editor::carried_out(const Point& from, const std::string& lines, Diagnostics& said) const {
  Scene scene = from.document.scene();
  Script script(scene, said, options_, from.script, home_);
  script.live = false;  // caches pay off: many lines look up the same names
  read_line(scene, script, lines, home_.name);
  if (has_errors(said)) return std::nullopt;
  return Point{Document(std::make_shared<const Scene>(std::move(scene))), script};
}

CommandResult Editor::carry_out(const Step& step) const {
  const std::vector<std::string> lines = lines_of(step, last_step());
  CommandResult result;
  Point at = now_;
  if (step.lines.size() > 1 || step.rows || (!step.sheet.empty() && !stands_below(step, last_step())))
    at.script.left.reset();
  if (step.lines.size() > 1 || step.rows) at.script.close();
  if (lines.size() > 1)
    if (Diagnostics said; auto after = carried_out(at, fmt::format("{}", fmt::join(lines, "\n")), said)) {
      result.done = true, result.after = *std::move(after);
      return result;
    }
  for (const std::string& line : lines) {  // one by one, to find the wrong line
    result = carry_out(at, line);
    if (!result.done) return result;
    at = result.after;
  }
  return result;
}

std::size_t Editor::bytes_kept(const Point& before, const Point& after) {
  std::size_t n = sizeof(Past) + bytes_apart(before.document.scene(), after.document.scene());
  const auto& left = before.script.left;
  if (!left || left == after.script.left) return n;
  const Sheet& sheet = left->sheet;
  n += shared_bytes<OpenSheet> + bytes_held(left->opener) + bytes_held(left->pattern) + bytes_held(sheet.opener);
  return n + bytes_held(sheet.on.targets) + bytes_held(sheet.tracks) + bytes_held(sheet.each_above) +
         bytes_held(sheet.versions) + bytes_held(sheet.spots);
}

void Editor::push(Point after, Step step, std::optional<std::size_t> known) {
  const std::size_t bytes = memory_of(step) + (known ? *known : bytes_kept(now_, after));
  steps_.resize(standing_);
  steps_.push_back(std::move(step));
  ++standing_;
  for (Past& p : undone_) forget(p);
  undone_.clear();
  before_.push_back({std::exchange(now_, std::move(after)), bytes});
  bytes_ += bytes;
}

void Editor::forget(Past& past) {
  bytes_ -= past.bytes;
  if (free_) free_(std::exchange(past.point, {}));
}

// Forgets the oldest states beyond the limits.
void Editor::shorten() {
  while (before_.size() > 1 && (before_.size() > depth_.steps || bytes_ > depth_.bytes)) {
    heavy_ = before_.size() <= depth_.steps;
    forget(before_.front());
    before_.pop_front();
  }
}

Status Editor::take(Point after, Step step, std::optional<std::size_t> bytes) {
  if (Status s = tell(Did::command, step); !s) return s;
  push(std::move(after), std::move(step), bytes);
  shorten();
  return Nothing{};
}

void Editor::step_back() {
  --standing_;
  Past& before = before_.back();
  const std::size_t bytes = memory_of(steps_[standing_]) + bytes_kept(now_, before.point);
  bytes_ = bytes_ - before.bytes + bytes;
  undone_.push_back({std::exchange(now_, std::move(before.point)), bytes});
  before_.pop_back();
}

Status Editor::undo() {
  if (standing_ == 0) return fail(ErrorCode::range, "there is nothing to undo");
  if (before_.empty() && heavy_)
    return fail(ErrorCode::range,
                fmt::format("no more can be undone: the undo history is limited to {} bytes", depth_.bytes));
  if (before_.empty())
    return fail(ErrorCode::range,
                fmt::format("no more can be undone: the undo history is limited to {} commands", depth_.steps));
  if (Status s = tell(Did::undo, steps_[standing_ - 1]); !s) return s;
  step_back();
  return Nothing{};
}

Status Editor::redo() {
  if (undone_.empty()) return fail(ErrorCode::range, "there is nothing to redo");
  if (Status s = tell(Did::redo, steps_[standing_]); !s) return s;
  Past& after = undone_.back();
  const std::size_t bytes = memory_of(steps_[standing_]) + bytes_kept(now_, after.point);
  bytes_ = bytes_ - after.bytes + bytes;
  before_.push_back({std::exchange(now_, std::move(after.point)), bytes});
  undone_.pop_back();
  ++standing_;
  return Nothing{};
}

// Keeps no document between two steps, so that they are as fast as a script with the same lines. If a step fails,
// carries out each half separately.
void Editor::settle_all(std::span<const Step> steps, std::size_t number, std::vector<FailedStep>& left_out) {
  if (steps.empty()) return;
  if (steps.size() == 1) {
    CommandResult result = carry_out(steps[0]);
    if (!result.done) {
      left_out.push_back({number, steps[0], std::move(result.said)});
      return;
    }
    now_ = std::move(result.after);
  } else {
    std::string text;
    const Step* above = last_step();
    for (const Step& step : steps) {
      for (const std::string& line : lines_of(step, above)) text += line + "\n";
      above = &step;
    }
    Diagnostics said;
    auto after = carried_out(now_, text, said);
    if (!after) {
      const std::size_t half = steps.size() / 2;
      settle_all(steps.first(half), number, left_out);
      return settle_all(steps.subspan(half), number + half, left_out);
    }
    now_ = *std::move(after);
  }
  steps_.insert(steps_.end(), steps.begin(), steps.end());
  standing_ = steps_.size();
}

std::vector<FailedStep> Editor::restore(std::span<const Step> steps, std::size_t standing) {
  std::vector<FailedStep> out;
  const std::size_t settled = standing - std::min(standing, depth_.steps);  // they cannot be undone
  settle_all(steps.first(settled), 0, out);
  for (std::size_t i = settled; i < steps.size(); ++i) {
    CommandResult result = carry_out(steps[i]);
    if (!result.done && i >= standing) break;
    if (!result.done) {
      out.push_back({i, steps[i], std::move(result.said)});
      continue;
    }
    push(std::move(result.after), steps[i]);
    if (i < standing) shorten();
  }
  while (standing_ > standing - out.size()) step_back();
  shorten();
  return out;
}

std::vector<Step> Editor::settle(std::string base, std::size_t steps) {
  base_ = std::move(base);
  const auto end = steps_.begin() + static_cast<std::ptrdiff_t>(steps);
  std::vector<Step> rest(std::make_move_iterator(end), std::make_move_iterator(steps_.end()));
  steps_.erase(end, steps_.end());
  standing_ -= steps;
  return std::exchange(steps_, std::move(rest));
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/editor.h"

#include <fmt/format.h>

#include <algorithm>

#include "language/line_words.h"
#include "scene/document.h"
#include "scene/memory.h"

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
  Scene scene;
  const Scene& now = now_.document.scene();
  scene.meshes = now.meshes, scene.pictures = now.pictures, scene.sounds = now.sounds, scene.formulas = now.formulas;
  Script script(scene, said, options_, {}, home_);
  read_text(scene, script, text, home_.name);
  share(scene, now);
  return {Document(std::make_shared<const Scene>(std::move(scene))), script};
}

Deed Editor::carry_out(const Point& from, std::string_view line, std::optional<Time> now, bool translated) const {
  Deed deed;
  const bool row = from.script.left && indented(line);
  if (row) deed.sheet = from.script.left->opener;
  Scene scene = from.document.scene();
  LoadOptions options = options_;
  options.now = now;
  Script script(scene, deed.said, options, from.script, home_);
  script.spells_out = translated;
  const Policy policy = scene.policy;
  if (translated) scene.policy = Policy::translate;
  read_line(scene, script, line, home_.name);
  if (translated) scene.policy = policy;
  for (Diagnostic& d : deed.said)
    if (d.what.place.file == home_.name) d.what.place.file.clear();
  deed.done = !has_errors(deed.said);
  if (!deed.done) return deed;
  deed.line = script.stamped();
  if (!row) deed.line.erase(0, deed.line.find_first_not_of(" \t\r,"));  // in a history it must not look like a row
  deed.stamped = !row && !translated && script.in_time;
  deed.touched = script.touched;
  if (!row && !script.verb) script.left = from.script.left;  // a remark closes no sheet
  deed.opens = !row && script.verb && script.left;
  deed.after = {Document(std::make_shared<const Scene>(std::move(scene))), script};
  return deed;
}

Deed Editor::carry_out(const Step& step) const {
  const Step* above = standing_ > 0 ? &steps_[standing_ - 1] : nullptr;
  Deed deed;
  Point at = now_;
  if (step.lines.size() > 1 || (!step.sheet.empty() && !stands_below(step, above))) at.script.left.reset();
  for (const std::string& line : lines_of(step, above)) {
    deed = carry_out(at, line);
    if (!deed.done) return deed;
    at = deed.after;
  }
  return deed;
}

std::size_t Editor::bytes_kept(const Point& before, const Point& after) {
  return bytes_apart(before.document.scene(), after.document.scene());
}

void Editor::push(Point after, Step step, std::optional<std::size_t> known) {
  const std::size_t bytes = bytes_of(step) + (known ? *known : bytes_kept(now_, after));
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

// What is older than may be kept is not gone back to any more.
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
  undone_.push_back({std::exchange(now_, std::move(before_.back().point)), before_.back().bytes});
  before_.pop_back();
}

Status Editor::undo() {
  if (standing_ == 0) return fail(ErrorCode::range, "there is nothing to undo");
  if (before_.empty() && heavy_)
    return fail(ErrorCode::range,
                fmt::format("no more can be undone: what is kept for it has at most {} bytes", depth_.bytes));
  if (before_.empty())
    return fail(ErrorCode::range, fmt::format("no more than {} commands can be undone", depth_.steps));
  if (Status s = tell(Did::undo, steps_[standing_ - 1]); !s) return s;
  step_back();
  return Nothing{};
}

Status Editor::redo() {
  if (undone_.empty()) return fail(ErrorCode::range, "there is nothing to redo");
  if (Status s = tell(Did::redo, steps_[standing_]); !s) return s;
  ++standing_;
  before_.push_back({std::exchange(now_, std::move(undone_.back().point)), undone_.back().bytes});
  undone_.pop_back();
  return Nothing{};
}

std::optional<std::pair<std::size_t, Diagnostics>> Editor::restore(const std::vector<Step>& steps,
                                                                   std::size_t standing) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    Deed deed = carry_out(steps[i]);
    if (!deed.done && i < standing) return std::pair(i, std::move(deed.said));
    if (!deed.done) break;  // it was undone anyhow
    push(std::move(deed.after), steps[i]);
    if (i < standing) shorten();
  }
  while (standing_ > standing) step_back();
  shorten();
  return std::nullopt;
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

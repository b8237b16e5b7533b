// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/editor.h"

#include <fmt/format.h>

#include <algorithm>

#include "language/line_words.h"

namespace betwixt {

Diagnostics Editor::begin(std::string text, const std::string& name) {
  base_ = std::move(text), home_ = Home(name);
  steps_.clear(), before_.clear(), undone_.clear();
  standing_ = 0;
  Scene scene;
  Diagnostics all;
  Script script(scene, all, options_, {}, home_);
  read_text(scene, script, base_, name);
  now_ = {Document(std::make_shared<const Scene>(std::move(scene))), script};
  return all;
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
  deed.stamped = !row && !translated && !script.stamps.empty();
  if (!row && !script.verb) script.left = from.script.left;  // a remark closes no sheet
  deed.opens = !row && script.verb && script.left;
  deed.after = {Document(std::make_shared<const Scene>(std::move(scene))), script};
  return deed;
}

Status Editor::tell(Did what, const Step& step, std::size_t standing) const {
  return sink_ ? sink_(what, step, {steps_.data(), standing}) : Status(Nothing{});
}

Status Editor::take(Point after, Step step) {
  if (Status s = tell(Did::command, step, standing_); !s) return s;
  steps_.resize(standing_);
  steps_.push_back(std::move(step));
  ++standing_;
  undone_.clear();
  before_.push_back(std::exchange(now_, std::move(after)));
  if (before_.size() > depth_) before_.pop_front();
  return Nothing{};
}

Status Editor::undo() {
  if (standing_ == 0) return fail(ErrorCode::range, "there is nothing to undo");
  if (before_.empty()) return fail(ErrorCode::range, fmt::format("no more than {} commands can be undone", depth_));
  if (Status s = tell(Did::undo, steps_[standing_ - 1], standing_ - 1); !s) return s;
  --standing_;
  undone_.push_back(std::exchange(now_, std::move(before_.back())));
  before_.pop_back();
  return Nothing{};
}

Status Editor::redo() {
  if (undone_.empty()) return fail(ErrorCode::range, "there is nothing to redo");
  if (Status s = tell(Did::redo, steps_[standing_], standing_); !s) return s;
  ++standing_;
  before_.push_back(std::exchange(now_, std::move(undone_.back())));
  undone_.pop_back();
  return Nothing{};
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/editor.h"

#include <fmt/format.h>

#include <algorithm>

#include "language/line_words.h"

namespace betwixt {
namespace {

// A host's line as it stands in a history: commands about environments that give no time happen when they come; what is
// put into an environment is put into the one of that name now, not into the first one (R-E9).
std::string stamped(std::string_view line, const std::string& sheet, std::int64_t tick) {
  const auto all = line_words(line);
  const bool environments = all.size() >= 3 && (all[1].ends_with(".environments") || all[1].ends_with(".drive"));
  if (all.empty()) return std::string(line);
  if (!sheet.empty() && indented(line))
    return all.size() == 2 && all[0] == "begin" && sheet.starts_with("edit ")
               ? fmt::format("  begin {} since {}t", all[1], tick)
               : std::string(line);
  if (all[0] == "animate" || all[0] == "halt" || all[0] == "kill" || all[0] == "cancel")
    return fmt::format("at {}t {}", tick, line);
  if (all[0] == "set" && environments)
    return fmt::format("at {}t {}", tick, line.substr(line.find(all[1], line.find("set") + 3)));
  return std::string(line);
}

}  // namespace

Diagnostics Editor::begin(std::string text, const std::string& name) {
  base_ = std::move(text), name_ = name;
  steps_.clear(), before_.clear(), undone_.clear();
  standing_ = 0;
  Scene scene;
  Diagnostics all;
  Script script(scene, all, options_);
  script.carry({}, name_);
  read_text(scene, script, base_, name_);
  now_ = {Document(std::make_shared<const Scene>(std::move(scene))), script.carried()};
  now_.script.sheet.clear();
  return all;
}

Deed Editor::carry_out(const Point& from, std::string_view line, std::optional<Time> now) const {
  Deed deed;
  const bool row = !from.script.sheet.empty() && indented(line);
  const std::size_t typed = line.size();
  while (now && !row && indented(line)) line.remove_prefix(1);  // in a history it must not look like a row
  deed.line = now ? stamped(line, row ? from.script.sheet : "", from.document.scene().ticks.whole(*now)) : line;
  const auto longer = static_cast<int>(deed.line.size()) - static_cast<int>(typed);
  deed.stamped = !row && deed.line != line;
  if (row) deed.sheet = from.script.sheet;
  const std::string before = deed.sheet + "\n";  // a line that begins the text could be taken for "#!"
  const int above = static_cast<int>(std::count(before.begin(), before.end(), '\n'));
  Scene scene = from.document.scene();
  Diagnostics all;
  Script script(scene, all, options_);
  script.carry(from.script, name_);
  read_text(scene, script, before + deed.line + "\n", name_);
  deed.done = !has_errors(all);
  for (Diagnostic& d : all) {
    Place& at = d.what.place;
    if (at.file == name_ && at.line > 0) {
      if (at.line <= above && d.severity != Severity::error) continue;  // said when the sheet was opened
      at.file.clear(), at.line -= above;
      if (at.line == 1) at.column = std::max(1, at.column - longer);
    }
    deed.said.push_back(std::move(d));
  }
  if (!deed.done) return deed;
  deed.after.script = script.carried();
  deed.opens = !row && deed.after.script.sheet_open;
  if (line_words(line).empty()) deed.after.script.sheet = from.script.sheet;  // a remark closes none
  deed.after.document = Document(std::make_shared<const Scene>(std::move(scene)));
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
  if (standing_ == 0) return fail(Code::range, "there is nothing to undo");
  if (before_.empty()) return fail(Code::range, fmt::format("no more than {} commands can be undone", depth_));
  if (Status s = tell(Did::undo, steps_[standing_ - 1], standing_ - 1); !s) return s;
  --standing_;
  undone_.push_back(std::exchange(now_, std::move(before_.back())));
  before_.pop_back();
  return Nothing{};
}

Status Editor::redo() {
  if (undone_.empty()) return fail(Code::range, "there is nothing to redo");
  if (Status s = tell(Did::redo, steps_[standing_], standing_); !s) return s;
  ++standing_;
  before_.push_back(std::exchange(now_, std::move(undone_.back())));
  undone_.pop_back();
  return Nothing{};
}

}  // namespace betwixt

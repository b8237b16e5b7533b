// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds where a script gives events and values: rows of sheets, `at` and `set` lines, and the arguments of `create`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "betwixt/document.h"
#include "scene/sections.h"
#include "syntax/script_text.h"

namespace betwixt {

// A row or an `at` line, which makes one event on each target.
struct RowText {
  Span line;  // with its line ending
  Span time, rest;
  Time when;
  bool relative = false;    // +12f
  SectionClock clock = {};  // of its times
};
// A sheet with its rows, or a single `at` line.
struct SheetText {
  std::vector<Target> targets;
  Span opener;
  std::vector<RowText> rows;
  bool alone = false;
  SectionClock clock = {};
};
// A value for the whole film, given for this target alone.
struct ValueText {
  Target target;
  Span value;
};
// The parts of a text that affect some targets.
struct TextRows {
  std::vector<SheetText> sheets;
  std::vector<ValueText> values;
};

// Returns all parts that affect the targets, in the order of the text. Leaves out sheets that cannot be attributed,
// such as those with formulas for times.
TextRows rows_about(const std::string& text, const Document&, std::span<const Target>);

}  // namespace betwixt

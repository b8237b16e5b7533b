// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Environments of TeX's formulas: matrices, cases, lines that are aligned.
#include <fmt/format.h>

#include "base/names.h"
#include "exchange/formula_reader.h"

namespace betwixt {
namespace {

struct MathEnvironment {
  std::string_view name;
  char32_t left, right;
  std::string_view alignment;
  double first_gap, gap;  // em before the second column and before the third; they alternate
  std::int8_t level;
  double row_gap, stretch;
};
constexpr MathEnvironment environments[] = {
    {"matrix", 0, 0, "c", 1, 1, 1, 0, 1},          {"pmatrix", '(', ')', "c", 1, 1, 1, 0, 1},
    {"bmatrix", '[', ']', "c", 1, 1, 1, 0, 1},     {"Bmatrix", '{', '}', "c", 1, 1, 1, 0, 1},
    {"vmatrix", '|', '|', "c", 1, 1, 1, 0, 1},     {"Vmatrix", 0x2016, 0x2016, "c", 1, 1, 1, 0, 1},
    {"smallmatrix", 0, 0, "c", 0.4, 0.4, 2, 0, 0}, {"cases", '{', 0, "l", 1, 1, 1, 0, 1.2},
    {"array", 0, 0, "c", 1, 1, 1, 0, 1},           {"aligned", 0, 0, "rl", 0, 1, 0, 0.3, 1},
    {"align", 0, 0, "rl", 0, 1, 0, 0.3, 1},        {"align*", 0, 0, "rl", 0, 1, 0, 0.3, 1},
    {"split", 0, 0, "rl", 0, 1, 0, 0.3, 1},        {"gathered", 0, 0, "c", 0, 0, 0, 0.3, 1},
    {"gather*", 0, 0, "c", 0, 0, 0, 0.3, 1},
};

}  // namespace

// Reads {c|lr}.
bool FormulaReader::array_columns(FormulaAtom& table, const Token& t) {
  std::string_view spec;
  const Token opened = peek();
  if (!raw_argument(spec, t)) return false;
  table.alignment.clear();
  for (const char c : spec) {
    if (c == '|')
      table.bars.push_back(table.alignment.size());
    else if (c == 'l' || c == 'c' || c == 'r')
      table.alignment += c;
    else if (c != ' ')
      return fail_at(opened, ErrorCode::syntax, "the columns of an array are letters l, c and r, and |");
  }
  if (table.alignment.empty()) return fail_at(opened, ErrorCode::syntax, "this array has no columns");
  return true;
}

bool FormulaReader::environment(FormulaList& out, const Token& t) {
  std::string_view name;
  const Token named = peek();
  if (!raw_argument(name, t)) return false;
  const auto* const row = std::find_if(std::begin(environments), std::end(environments),
                                       [&](const MathEnvironment& e) { return e.name == name; });
  if (row == std::end(environments)) {
    std::vector<std::string_view> all;
    for (const MathEnvironment& e : environments) all.push_back(e.name);
    return fail_at(named, ErrorCode::name, fmt::format("there is no environment '{}'", name.substr(0, 40)),
                   did_you_mean(name, all));
  }
  FormulaAtom a = made(AtomForm::table, t);
  a.alignment = row->alignment, a.level = row->level, a.row_gap = row->row_gap, a.stretch = row->stretch;
  a.gaps = {row->first_gap, row->gap};
  if (name == "array" && !array_columns(a, t)) return false;
  if (!cells(a, End::end, t)) return false;
  const Token ends = take();
  std::string_view closed;
  if (!raw_argument(closed, ends)) return false;
  if (closed != name)
    return fail_at(ends, ErrorCode::syntax,
                   fmt::format("\\end{{{}}} cannot end \\begin{{{}}}", closed.substr(0, 40), name));
  if (row->left == 0 && row->right == 0) {
    out.push_back(std::move(a));
    return true;
  }
  FormulaAtom around = made(AtomForm::fenced, t, AtomClass::inner);
  around.fences = {row->left, row->right};
  around.lists.emplace_back().push_back(std::move(a));
  out.push_back(std::move(around));
  return true;
}

bool FormulaReader::cells(FormulaAtom& table, End wanted, const Token& opened) {
  const int brackets = std::exchange(brackets_, 0);
  FormulaList first;
  End end = End::text;
  while (is(peek(), "hline")) take(), table.rules.push_back(0);
  if (!list(first, end) || !cells_from(table, std::move(first), end, wanted, opened)) return false;
  brackets_ = brackets;
  return true;
}

// Reads the cells behind the first one, which ended with `end`, up to `wanted`.
bool FormulaReader::cells_from(FormulaAtom& table, FormulaList first, End end, End wanted, const Token& opened) {
  std::vector<std::vector<FormulaList>> rows(1);
  rows[0].push_back(std::move(first));
  while (end == End::cell || end == End::row) {
    take();
    if (end == End::row) {
      rows.emplace_back();
      const Token t = peek();
      if (is(t, '[')) {  // a length that TeX would add
        const std::size_t close = text_.find(']', t.at);
        if (close == text_.npos) return fail_at(t, ErrorCode::syntax, "'[' is never closed");
        at_ = close + 1;
      }
      while (is(peek(), "hline")) take(), table.rules.push_back(rows.size() - 1);
    }
    FormulaList cell;
    if (!list(cell, end)) return false;
    rows.back().push_back(std::move(cell));
  }
  if (end != wanted) {
    const Token t = peek();
    if (t.what == Token::nothing)
      return fail_at(opened, ErrorCode::syntax, fmt::format("{} is never closed", said(opened)));
    return fail_at(t, ErrorCode::syntax,
                   is(t, '}') ? "this } closes nothing" : fmt::format("{} is at a wrong place", said(t)));
  }
  if (rows.size() > 1 && rows.back().size() == 1 && rows.back()[0].empty())
    rows.pop_back();  // behind the last line's end
  for (const auto& row : rows) table.columns = std::max(table.columns, row.size());
  if (table.columns * rows.size() > 10'000) return fail_at(opened, ErrorCode::range, "it has too many cells");
  for (auto& row : rows) {
    row.resize(table.columns);
    for (FormulaList& cell : row) table.lists.push_back(std::move(cell));
  }
  return true;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Matrices and aligned lines.
#include <algorithm>

#include "exchange/formula_setter.h"

namespace betwixt {
namespace {

constexpr double line_height = 0.84, line_depth = 0.36;  // em: LaTeX's \strut
constexpr double least_gap = 0.1, rule_thickness = 0.04;
constexpr char32_t table_rule = 0x2501, table_bar = 0x2503;

struct Lines {
  std::vector<double> heights, depths, baselines;
};

char alignment_of(const FormulaAtom& a, std::size_t column) {
  if (a.alignment == "rl") return a.alignment[column % 2];
  return a.alignment[std::min(column, a.alignment.size() - 1)];
}

// The cells, each with an empty sign in front where a relation begins the right half of an equation.
std::vector<FormulaList> prepared_cells(const FormulaAtom& a) {
  std::vector<FormulaList> all = a.lists;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (a.alignment == "rl" && i % a.columns % 2 == 1 && !all[i].empty()) {
      FormulaAtom nothing;
      nothing.form = AtomForm::group;
      nothing.lists.resize(1);
      all[i].insert(all[i].begin(), std::move(nothing));
    }
  return all;
}

Lines lines_of(const std::vector<SetBox>& boxes, const FormulaAtom& a, double scale) {
  Lines out;
  const std::size_t rows = boxes.size() / a.columns;
  for (std::size_t r = 0; r < rows; ++r) {
    double height = scale * a.stretch * line_height, depth = scale * a.stretch * line_depth;
    for (std::size_t c = 0; c < a.columns; ++c) {
      height = std::max(height, boxes[r * a.columns + c].height + least_gap / 2);
      depth = std::max(depth, boxes[r * a.columns + c].depth + least_gap / 2);
    }
    out.baselines.push_back(r == 0 ? 0 : out.baselines.back() - out.depths.back() - scale * a.row_gap - height);
    out.heights.push_back(height), out.depths.push_back(depth);
  }
  return out;
}

}  // namespace

SetBox FormulaSetter::table(const FormulaAtom& a, SetStyle s) {
  const double outer = axis(s);
  s.level = std::max<int>(a.level, s.level > 1 ? s.level : 0), s.cramped = false;
  // The tree's atoms must outlive their marks, so parts are those of the atoms in the tree itself.
  std::vector<SetBox> boxes;
  const std::vector<FormulaList> cells = prepared_cells(a);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    boxes.push_back(list(cells[i], s));
    boxes.back().width += std::exchange(boxes.back().italics, 0);
    for (SetMark& m : boxes.back().marks)
      if (m.part != nullptr) m.part = &*parts_.insert(*m.part).first;
  }
  if (boxes.empty() || a.columns == 0) return {};
  const double scale = size(s);
  const Lines lines = lines_of(boxes, a, scale);
  std::vector<double> widths(a.columns), lefts(a.columns);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    widths[i % a.columns] = std::max(widths[i % a.columns], boxes[i].width);
  double pen = a.bars.empty() ? 0 : 0.5;
  for (std::size_t c = 0; c < a.columns; ++c) {
    if (c > 0) pen += scale * a.gaps[(c + 1) % 2];
    lefts[c] = pen;
    pen += widths[c];
  }
  if (!a.bars.empty()) pen += 0.5;
  const double top = lines.heights.front(), bottom = lines.baselines.back() - lines.depths.back();
  const double up = outer - (top + bottom) / 2;
  SetBox out{pen, top + up, -(bottom + up)};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::size_t c = i % a.columns;
    const double spare = widths[c] - boxes[i].width;
    const char side = alignment_of(a, c);
    const double x = lefts[c] + (side == 'r' ? spare : side == 'c' ? spare / 2 : 0);
    put_box(out, std::move(boxes[i]), x, lines.baselines[i / a.columns] + up);
  }
  for (const std::size_t c : a.bars) {
    const double x = c == 0 ? 0 : c >= a.columns ? pen : (lefts[c] + lefts[c - 1] + widths[c - 1]) / 2;
    SetMark mark;
    mark.area.push_back(area_of(x - rule_thickness / 2, bottom + up, x + rule_thickness / 2, top + up)),
        mark.sign = table_bar;
    out.marks.push_back(std::move(mark));
  }
  for (const std::size_t r : a.rules) {
    const double y = r < lines.baselines.size() ? lines.baselines[r] + lines.heights[r] : bottom;
    put_box(out, bar(pen, y + up - rule_thickness / 2, rule_thickness, table_rule), 0, 0);
  }
  return out;
}

}  // namespace betwixt

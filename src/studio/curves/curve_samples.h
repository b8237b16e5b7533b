// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Samples of curves, one for each column of pixels. Coarse columns come first and finer ones as time allows, so that
// slow procedures do not block the window.
#pragma once

#include <optional>
#include <vector>

#include "betwixt/program.h"
#include "studio/curves/curve_lines.h"

namespace betwixt::studio {

class CurveSamples {
 public:
  // Starts again, with a time for each column.
  void begin(const Program&, std::vector<CurveLine>, std::vector<Time> columns);
  // Computes samples for this long. Returns false when all are done.
  bool work(double milliseconds);
  bool complete() const { return next_ >= order_.size(); }

  const std::vector<CurveLine>& lines() const { return lines_; }
  // Return a curve's number at a column: the final value, and the value of its track alone. The second one exists only
  // where filters, layers or velocities change the result. Return nullopt if it is not computed yet or is no number.
  std::optional<double> final(std::size_t line, std::size_t column) const { return at(final_, line, column); }
  std::optional<double> bare(std::size_t line, std::size_t column) const { return at(bare_, line, column); }
  bool has_bare(std::size_t line) const { return laid_over_[line]; }
  std::optional<Color> color(std::size_t line, std::size_t column) const;
  std::size_t columns() const { return times_.size(); }

 private:
  using Numbers = std::vector<double>;  // line by line; NaN for no value
  std::optional<double> at(const Numbers&, std::size_t line, std::size_t column) const;
  void sample(std::size_t column);

  std::optional<Program> program_;
  std::vector<std::pair<ObjectId, Program>> bare_programs_;  // by layer; no layer for the objects themselves
  std::vector<CurveLine> lines_;
  std::vector<bool> laid_over_;
  std::vector<Target> targets_;         // the curves' targets, without duplicates
  std::vector<std::size_t> target_of_;  // index of each curve's target
  std::vector<Time> times_;
  std::vector<std::size_t> order_;
  std::size_t next_ = 0;
  Numbers final_, bare_;
  std::vector<std::optional<Color>> colors_;
};

}  // namespace betwixt::studio

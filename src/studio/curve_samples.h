// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Curves as the program makes them, a column of pixels each: coarse ones first, and finer as time allows, so that
// nobody waits for code that is slow.
#pragma once

#include <optional>
#include <vector>

#include "betwixt/program.h"
#include "studio/curve_lines.h"

namespace betwixt::studio {

class CurveSamples {
 public:
  // Begins anew, with a time for each column.
  void begin(const Program&, std::vector<CurveLine>, std::vector<Time> columns);
  // Goes on for so long; false: all is there.
  bool work(double milliseconds);
  bool complete() const { return next_ >= order_.size(); }

  const std::vector<CurveLine>& lines() const { return lines_; }
  // Of a line at a column: what it is at last, and what its track alone says where filters, layers or velocities make
  // something else of it. None: not known yet, or no number.
  std::optional<double> final(std::size_t line, std::size_t column) const { return at(final_, line, column); }
  std::optional<double> bare(std::size_t line, std::size_t column) const { return at(bare_, line, column); }
  bool has_bare(std::size_t line) const { return laid_over_[line]; }
  std::optional<Color> color(std::size_t line, std::size_t column) const;
  std::size_t columns() const { return times_.size(); }

 private:
  using Numbers = std::vector<double>;  // line by line; not a number: none
  std::optional<double> at(const Numbers&, std::size_t line, std::size_t column) const;
  void sample(std::size_t column);

  std::optional<Program> program_;
  std::vector<std::pair<ObjectId, Program>> bare_programs_;  // of no layer, and of layers
  std::vector<CurveLine> lines_;
  std::vector<bool> laid_over_;
  std::vector<Target> targets_;         // of the lines
  std::vector<std::size_t> target_of_;  // of each line
  std::vector<Time> times_;
  std::vector<std::size_t> order_;
  std::size_t next_ = 0;
  Numbers final_, bare_;
  std::vector<std::optional<Color>> colors_;
};

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A formula as a tree of atoms (The TeXbook, chapter 17), and the reader that makes it from TeX's notation.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

enum class AtomClass : std::uint8_t { ord, op, bin, rel, open, close, punct, inner, none };

enum class AtomForm : std::uint8_t {
  symbol,     // `symbol`; big if its class is op and `large`
  letters,    // `letters`, upright: the name of a function, or a text
  group,      // lists[0]
  fraction,   // lists[0] over lists[1]; `rule`: with a bar; between `left` and `right`, if given
  root,       // of lists[0]; lists[1]: its degree, may be empty
  fenced,     // lists[k] between fences[k] and fences[k + 1], which are as tall as they need
  fence,      // `symbol`, `amount` em tall
  accent,     // `symbol` over lists[0]; `wide`: as wide as it
  line,       // over lists[0], or under it if `below`
  brace,      // `symbol`, as wide as lists[0], over it, or under it if `below`
  arrow,      // `symbol`, as wide as its labels: lists[0] above, lists[1] below
  stack,      // lists[0] with lists[1] small above it, or below it if `below`
  table,      // lists: its cells, row by row, `columns` in each
  space,      // `amount` em
  style,      // from here on `level`
  crossed,    // lists[0] under a line; `symbol`: / or \ or x
  boxed,      // lists[0] in a frame
  invisible,  // the place of lists[0]; `wide`: only its width; `below`: only its height
};

struct FormulaAtom;
using FormulaList = std::vector<FormulaAtom>;

struct FormulaAtom {
  AtomClass is = AtomClass::ord;
  AtomForm form = AtomForm::symbol;
  char32_t symbol = 0;
  std::u32string letters = {};
  std::vector<FormulaList> lists = {};
  std::vector<char32_t> fences = {};  // 0: none
  FormulaList above = {}, below_it = {};
  bool has_above = false, has_below = false;
  enum class Limits : std::uint8_t { automatic, on, off } limits = Limits::automatic;
  bool large = false, rule = true, wide = false, below = false, stretches = false;
  bool takes_limits = false;  // in display style
  double amount = 0;
  std::int8_t level = -1;  // 0 display, 1 text, 2 script, 3 script of a script; -1: as the surroundings say
  char32_t left = 0, right = 0;
  // Of a table.
  std::size_t columns = 0;
  std::string alignment = {};          // a letter for each column, l c r; the last one holds for the rest; "rl" repeats
  std::array<double, 2> gaps = {};     // em before the second column and before the third; they alternate
  std::vector<std::size_t> bars = {};  // vertical lines: the columns before which they are
  std::vector<std::size_t> rules = {};  // horizontal lines: the rows before which they are
  double row_gap = 0, stretch = 1;      // em between rows; a factor of the rows' least heights
  std::string part = {};
  std::size_t at = 0, length = 1;  // where it is in the formula, in bytes
};

// Where a formula has an error: bytes of it.
struct FormulaError {
  Error what;
  std::size_t at = 0, length = 1;
};

inline constexpr std::size_t most_formula_bytes = 20'000;
inline constexpr int most_formula_depth = 50;

// Reads a formula. Returns the error, or none (an empty message).
FormulaError read_formula(std::string_view text, FormulaList& out);

}  // namespace betwixt

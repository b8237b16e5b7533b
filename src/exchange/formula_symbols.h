// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// TeX's names of signs, and the alphabets of mathematics.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "exchange/formula_tree.h"

namespace betwixt {

struct FormulaSign {
  std::string_view name;
  char32_t code;
  AtomClass is;
};
std::span<const FormulaSign> math_signs();  // by name
const FormulaSign* find_sign(std::string_view name);
// The class of a character that is written itself, and the character that stands for it ('-' is a minus sign).
FormulaSign sign_of(char32_t written);

// sin, log …; `limits`: of these, as of max, subscripts stand below in display style.
struct FormulaFunction {
  std::string_view name, shown;
  bool limits;
};
const FormulaFunction* find_math_function(std::string_view name);

struct FormulaAccent {
  std::string_view name;
  char32_t code;
  bool wide;
};
const FormulaAccent* find_math_accent(std::string_view name);

// Spaces in em, by the command that makes them.
std::optional<double> find_math_space(std::string_view name);

enum class Alphabet : std::uint8_t {
  usual,
  upright,
  bold,
  italic,
  bold_italic,
  hollow,
  script,
  gothic,
  sans,
  typewriter
};
std::optional<Alphabet> find_alphabet(std::string_view command);  // mathbb, bf …
char32_t in_alphabet(char32_t letter, Alphabet);

// A sign with a stroke through it (= to ≠), or 0 if there is none.
char32_t negated(char32_t sign);

// The names of all commands, for suggestions.
std::vector<std::string_view> sign_names();

}  // namespace betwixt

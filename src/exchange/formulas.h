// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas in TeX's notation, set without TeX.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "exchange/formula_tree.h"
#include "scene/outline.h"

namespace betwixt {

// The font of formulas, where the machine has it.
inline constexpr std::string_view formula_font_name = "Latin Modern Math";

// Sets a formula in display style at 1 m an em, with the baseline at y = 0; each sign and each bar is a letter. An
// error's place has the first byte in the text (from 1, as a column) and the length. Errors: syntax, name (a command or
// a sign that does not exist), range, machine (the font is missing).
Result<std::shared_ptr<const Outline>> set_formula_text(const std::string& text);

}  // namespace betwixt

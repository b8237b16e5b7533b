// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas as TeX sets them, through the programs latex and dvisvgm. They get a folder of their own, and limits.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "betwixt/result.h"
#include "scene/outline.h"

namespace betwixt {

// In display style at 1 m an em (10pt of TeX's), the baseline at y = 0; each glyph and each bar is a letter. Neither
// program takes longer than `most`. Errors: syntax (TeX's own words), range (a formula too long, too much drawn),
// machine (a program is missing, fails, takes too long).
Result<std::shared_ptr<const Outline>> set_by_tex(const std::string& formula,
                                                  std::chrono::milliseconds most = std::chrono::seconds(30));

// The same of what `dvisvgm --no-fonts` wrote. In front of the formula, on its baseline, stands a square of one inch.
Result<Outline> read_tex_drawing(std::string_view svg);

}  // namespace betwixt

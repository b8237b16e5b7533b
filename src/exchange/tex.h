// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas set by TeX, through the programs latex and dvisvgm. They run in a jail (parser_jail.h), in which they can
// change a temporary folder, and read TeX's own files.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "betwixt/result.h"
#include "scene/outline.h"

namespace betwixt {

// Sets a formula in display style at 1 m an em (TeX's 10pt), with the baseline at y = 0; each glyph and each bar is a
// letter. Neither program may take longer than `most`. Errors: syntax (TeX's own message), range (too long a formula or
// drawing), machine (a program is missing, fails, or takes too long).
Result<std::shared_ptr<const Outline>> set_by_tex(const std::string& formula,
                                                  std::chrono::milliseconds most = std::chrono::seconds(30));

// Reads the output of `dvisvgm --no-fonts`. A square of one inch precedes the formula, on its baseline.
Result<Outline> read_tex_drawing(std::string_view svg);

}  // namespace betwixt

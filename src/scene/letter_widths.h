// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How wide texts are, without a font: for charts, which keep their labels apart.
#pragma once

#include <string>
#include <string_view>

namespace betwixt {

// Returns the width of one line of text in em. In DejaVu Sans, which is wide; few other fonts of screens are wider.
double letters_width(std::string_view);
// Returns the text if it is not wider than that; otherwise its beginning with …, or "" if fewer than two letters fit.
std::string shortened(const std::string&, double most_em);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which characters of one piece of code go where in another.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace betwixt {

inline constexpr std::size_t no_partner = static_cast<std::size_t>(-1);

// Returns for each byte of `from` its place in `to`, or no_partner. Lines that stay are paired first, then lines that
// have moved, then the words of lines that have changed, and last words that have gone to another line. Only equal
// words and equal lines are paired; the blanks at their ends do not count.
std::vector<std::size_t> match_code(std::string_view from, std::string_view to, std::string_view language);

}  // namespace betwixt

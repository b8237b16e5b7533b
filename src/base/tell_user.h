// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Messages to the user on standard error. If no one reads it any more, they are lost and nothing else happens.
#pragma once

#include <string>
#include <string_view>

namespace betwixt {

// Prints a text with its control characters made visible (utf8.h). If colours are on, it colours "error:", "warning:"
// and "notice:", the place before them, and carets.
void tell_user(std::string_view text);

enum class ColorMode { automatic, always, never };
// Chooses colours. The default is automatic: on if standard error is a terminal with colours and NO_COLOR is not set
// (no-color.org).
void choose_color_mode(ColorMode);
// Returns the text with the terminal's codes for colours.
std::string with_color_codes(std::string_view text);

}  // namespace betwixt

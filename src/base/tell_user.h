// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Words for whoever runs the program, on standard error. Where nobody reads there any more, they are lost, and nothing
// else happens.
#pragma once

#include <string>
#include <string_view>

namespace betwixt {

// With all that a terminal would obey made visible (utf8.h). In colours where that is wanted: "error:", "warning:" and
// "notice:", what stands before them, and carets.
void tell_user(std::string_view text);

enum class Colours { automatic, always, never };
// Automatic, as it is unless somebody chooses: where standard error is a terminal that knows colours, and NO_COLOR is
// not set (no-color.org).
void choose_colours(Colours);
// The text as a terminal shows it in colours.
std::string in_colours(std::string_view text);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The names of the drawing styles of the program. The room render has a row for each; plug-ins cannot take them.
#pragma once

#include <array>
#include <string_view>

namespace betwixt {

inline constexpr std::array<std::string_view, 4> style_names{"shaded", "wireframe", "hidden-line", "traced"};

}  // namespace betwixt

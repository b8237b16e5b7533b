// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the place of a diagnostic in a text.
#pragma once

#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// Gives it the place at which a part, of one line or of several, first stands in a text; where it is not in it, none.
void point_at(Diagnostic&, std::string_view text, std::string_view part);

}  // namespace betwixt

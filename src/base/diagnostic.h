// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds the place of a diagnostic in a text.
#pragma once

#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// Sets the place where a part, of one line or of several, first occurs in a text; sets none if it does not occur.
void point_at(Diagnostic&, std::string_view text, std::string_view part);

}  // namespace betwixt

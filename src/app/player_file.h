// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The engine and player for web pages: one JavaScript file, built separately and embedded into pages.
#pragma once

#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// Returns its path: BETWIXT_PLAYER, beside the program, or the installed one. Errors: machine (not found).
Result<std::string> find_player();
// Returns its content, fit for a <script> element. Without the reader of meshes, scenes, drawings and pictures it is a
// quarter smaller. Errors: machine.
Result<std::string> read_player(bool with_reader);

// Escapes a text for a <script type="…"> element that is no JavaScript. Sequences that would end it get a backslash
// more (<\/script, <\!--, <\script), which the page removes again.
std::string as_script_text(std::string_view);

}  // namespace betwixt

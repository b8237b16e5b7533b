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
// The parts of the player that only some films need.
struct PlayerParts {
  bool reader = false;    // of meshes, scenes, drawings and pictures: a quarter of the player
  bool formulas = false;  // the font of formulas
  bool code = false;      // the font of code
};

// Returns its content with the wanted parts, fit for a <script> element. Errors: machine.
Result<std::string> read_player(PlayerParts);

// Escapes a text for a <script type="…"> element that is no JavaScript. Sequences that would end it get a backslash
// more (<\/script, <\!--, <\script), which the page removes again.
std::string as_script_text(std::string_view);

}  // namespace betwixt

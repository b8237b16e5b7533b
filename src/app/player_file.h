// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The engine and the player for web pages: one file of JavaScript, which is built apart and put into pages.
#pragma once

#include <string>
#include <string_view>

#include "betwixt/result.h"

namespace betwixt {

// Where it is: BETWIXT_PLAYER, beside the program, or where it was installed. Errors: machine (it is not here).
Result<std::string> find_player();
// What is in it, to stand between <script> and </script>. Errors: machine.
Result<std::string> read_player();

// A text that is no JavaScript between <script type="…"> and </script>: what would end it gets a backslash more
// (<\/script, <\!--, <\script), which the page takes away again.
std::string as_script_text(std::string_view);

}  // namespace betwixt

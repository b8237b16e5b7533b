// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values that the user gives for the `let` lines of a script (LoadOptions::lets).
#pragma once

#include "commands/command.h"
#include "scene/quantity.h"

namespace betwixt {

// Replaces the value of the script's `let` if another one is given for it. `name`: where the script has it.
bool given_let(Command&, std::string_view name, Let& value);
// Reports the given values for which the script has no `let`.
void say_unknown_lets(const Scene&, Script&);
// Reads the value of a `let`: up to the end of the cursor's line.
bool let_value(Command&, Let&);

}  // namespace betwixt

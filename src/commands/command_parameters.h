// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The named parameters of the author's commands: `procedure walk command (who object, from time = 1f) lua "…"`.
#pragma once

#include <string>
#include <vector>

#include "commands/command.h"

namespace betwixt {

// Reads the declared parameters, in brackets. Fails if a name or a default is wrong.
bool read_parameters(Command&, std::vector<CommandParameter>& out);
// Returns Lua code that declares the parameters as local variables; without arguments they are nil.
std::string declared(const std::vector<CommandParameter>&, const std::vector<std::string>& codes = {});
// Reads the arguments of a command: `NAME=VALUE`, or values in the order of the parameters. Returns Lua code for each
// parameter.
bool read_arguments(Command&, const NamedProcedure&, std::string_view about, std::vector<std::string>& codes);
// Returns "walk who=OBJECT along=OBJECT [step=0.8]".
std::string usage_of(const NamedProcedure&);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Parses the command line. Only its source includes the parser's library.
#pragma once

#include <string>

#include "app/subcommand.h"

namespace betwixt {

// Runs the subcommand. Returns the exit code.
int command_line(int argc, char** argv);
// Returns the --help text of a subcommand.
std::string help_of(const Subcommand&);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// From words on the command line to subcommands. Its source is all that sees the library that reads them.
#pragma once

#include <string>

#include "app/subcommand.h"

namespace betwixt {

// Carries out what is asked for; gives the exit code.
int command_line(int argc, char** argv);
// What --help says about a subcommand.
std::string help_of(const Subcommand&);

}  // namespace betwixt

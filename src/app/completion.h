// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What shells are told about the program, so that they complete its words. Made from the subcommands' rows.
#pragma once

#include <string>

namespace betwixt {

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace betwixt

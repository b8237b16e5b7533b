// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Completion scripts for shells, generated from the subcommands' rows.
#pragma once

#include <string>

namespace betwixt {

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Starts the studio, a separate program (src/studio).
#pragma once

#include <string>
#include <vector>

#include "app/command.h"

namespace betwixt {

bool has_display();  // whether windows can be opened
bool has_studio();   // whether it has been built
// Replaces this process by the studio, with a tab for each file. Returns only if that fails. Errors: machine.
Status become_studio(std::vector<std::string> arguments, const std::vector<std::string>& files);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The studio, a program of its own (src/studio).
#pragma once

#include <string>
#include <vector>

#include "app/command.h"

namespace betwixt {

bool has_display();  // to open windows on
bool has_studio();   // it has been built
// The studio takes this program's place; returns only if it cannot. Errors: machine.
Status become_studio(std::vector<std::string> arguments, const std::string& file);

}  // namespace betwixt

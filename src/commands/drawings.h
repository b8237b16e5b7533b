// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Converts drawings from files to objects.
#pragma once

#include "commands/command.h"

namespace betwixt {

// Creates each NAME, a copy of `root`, and below it objects NAME/THING: groups, and a polygon for each outline.
bool create_drawing(Command&, const std::vector<std::string>& names, const std::vector<ObjectId>& parents,
                    const Object& root, std::string path, std::string_view about);

}  // namespace betwixt

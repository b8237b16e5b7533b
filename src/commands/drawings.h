// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Drawings from files become objects.
#pragma once

#include "commands/command.h"

namespace betwixt {

// Objects NAME/THING below each NAME, which is made like `root`: a polygon for each outline, and groups.
bool create_drawing(Command&, const std::vector<std::string>& names, const std::vector<ObjectId>& parents,
                    const Object& root, std::string path, std::string_view about);

}  // namespace betwixt

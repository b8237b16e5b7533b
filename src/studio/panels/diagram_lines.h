// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines that change a diagram. `create` places its nodes, so `set` cannot change its layout.
#pragma once

#include <optional>
#include <string>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

// Returns the line that gives the line `create NAME …` of a text another value of a parameter: `rewrite 2..2 "…"`.
// Returns nullopt if the text has no such line.
std::optional<std::string> line_that_recreates(const std::string& text, const std::string& name,
                                               const std::string& parameter, const std::string& value);
// Returns the line that changes what a diagram shows: after the film's first frame by `at 24f rearrange d layout=tree`.
// Returns nullopt for values that `set` changes.
std::optional<std::string> diagram_line(const Workspace&, ObjectId, std::string_view function,
                                        const std::string& value);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A fast path for a change of one row in a long script that no other line depends on: updates the film without reading
// the script again.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "editor/placing.h"

namespace betwixt {

// Returns the change as commands on the film that the text makes. Returns nullopt if the effect is not certain, as
// another line may use the same track. The text must have no errors.
std::optional<std::vector<std::string>> commands_of(std::string_view text, const TextEdit&, const Document&);

}  // namespace betwixt

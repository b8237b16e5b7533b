// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A row that is changed in a long script, where no other line has anything to do with it: what the film is after it
// follows from what it was before, and the script need not be read again.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/document.h"
#include "editor/placing.h"

namespace betwixt {

// What the change does, as commands on the film that the text makes; none where that is not plain to see: another line
// might speak of the same track, or make something of it. The text has no errors.
std::optional<std::vector<std::string>> commands_of(std::string_view text, const TextEdit&, const Document&);

}  // namespace betwixt

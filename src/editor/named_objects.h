// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The objects that the lines of a script name: an editor highlights the object at the cursor, and the lines that name
// the selection.
#pragma once

#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// Returns the objects that a line names, in order, each once and at most `most`. A row also names those of its sheet's
// opener.
std::vector<ObjectId> objects_named_in(std::string_view line, std::string_view opener, const Document&,
                                       std::size_t most = 100'000);
// Returns true if the line names one of these objects. Its cost depends on the number of names in the line.
bool names_any(std::string_view line, std::string_view opener, const Document&, const std::vector<ObjectId>&);

}  // namespace betwixt

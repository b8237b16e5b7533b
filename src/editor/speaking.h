// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What lines of a script speak of: an editor shows what is meant where the cursor is, and which lines mean what is
// selected.
#pragma once

#include <string_view>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// Whether rows may follow it: a target alone, or `make NAME`.
bool opens_sheet(std::string_view line);
// Whether it is a line that stands below one that opens a sheet, or is nothing at all: the one that does is further up.
bool below_opener(std::string_view line);
// The objects that a line names, in the order in which it does, each once; a row speaks of those of the line that
// opened its sheet too. No more than `most`.
std::vector<ObjectId> spoken_of(std::string_view line, std::string_view opener, const Document&,
                                std::size_t most = 100'000);
// Whether one of these is among them; so many names are looked at as the line has.
bool speaks_of(std::string_view line, std::string_view opener, const Document&, const std::vector<ObjectId>&);

}  // namespace betwixt

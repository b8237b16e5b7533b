// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Objects that have another name in the newer of two films.
#pragma once

#include <map>
#include <string>

#include "betwixt/document.h"
#include "compare/facts.h"

namespace betwixt {

// New names by old ones. An object below a renamed one (man/arm) is not listed if its name only follows.
using Renames = std::map<std::string, std::string>;

// Finds the objects that are gone, and have the same content as one that came.
Renames renames_between(const Facts& old, const Facts& now);
// Returns the film with the new names; a name that cannot be given stays.
Document renamed(const Document&, const Renames&);

}  // namespace betwixt

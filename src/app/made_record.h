// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a film was made of. It is kept in a hidden file beside the film, so that a second call knows that the film is
// still right and passes it over.
#pragma once

#include <set>
#include <string>

#include "betwixt/result.h"

namespace betwixt {

// Returns whether the film is there as it was made, with these parameters, and none of its files has changed since.
bool stands_as_made(const std::string& film, const std::string& parameters);
Status write_made_record(const std::string& film, const std::string& parameters, const std::set<std::string>& files);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values, formatted for people and as JSON.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/program.h"

namespace betwixt {

// Formats a value as in a script; numbers that are nearly 0 are written as 0. A matrix is its numbers, row by row.
std::string plain_value(const Value&, const Target&, const Document&);

// Returns the targets that match the patterns, each once; all objects if there is no pattern. Calls `nothing` with each
// pattern that matches nothing. Errors: name.
Result<std::vector<Target>> targets_of(const Document&, std::vector<std::string> patterns,
                                       const std::function<void(const std::string&)>& nothing = {});
// Returns one JSON object: the times as written, with the values of the targets at each.
std::string values_json(const Document&, const Program&, const std::vector<Target>&,
                        const std::vector<std::pair<std::string, Time>>& times,
                        const std::function<void(const std::vector<std::string>&)>& problems = {});

// Returns the values of targets at times, one line each; with several times, grouped by time. Without a pattern: all
// objects. Errors: name.
Result<std::string> values_at(const Document&, std::vector<std::string> patterns,
                              const std::vector<std::pair<std::string, Time>>& times);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values for people.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/program.h"

namespace betwixt {

// As it would be written in a script; what is as good as 0 is 0. A matrix is its numbers, row by row.
std::string plain_value(const Value&, const Target&, const Document&);

// What patterns name, each once; no pattern: all objects. `nothing` is told which name nothing. Errors: name.
Result<std::vector<Target>> targets_of(const Document&, std::vector<std::string> patterns,
                                       const std::function<void(const std::string&)>& nothing = {});
// As one JSON object: the times, each as it was said, with what the targets are then.
std::string values_json(const Document&, const Program&, const std::vector<Target>&,
                        const std::vector<std::pair<std::string, Time>>& times,
                        const std::function<void(const std::vector<std::string>&)>& problems = {});

// What targets are at times, a line each; where there are several times, below each time. No pattern: all objects.
// Errors: name.
Result<std::string> values_at(const Document&, std::vector<std::string> patterns,
                              const std::vector<std::pair<std::string, Time>>& times);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values for people.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

// As it would be written in a script; what is as good as 0 is 0. A matrix is its numbers, row by row.
std::string plain_value(const Value&, const Target&, const Document&);

// What targets are at times, a line each; where there are several times, below each time. No pattern: all objects.
// Errors: name.
Result<std::string> values_at(const Document&, std::vector<std::string> patterns,
                              const std::vector<std::pair<std::string, Time>>& times);

}  // namespace betwixt

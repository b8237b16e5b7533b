// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "betwixt/program.h"

namespace betwixt {

// Returns the bytes of a program without its document: its arrays and curves. Includes arrays shared with the last
// program, but not the environment set, pictures and unused evaluators.
std::size_t bytes_of(const Program&);

}  // namespace betwixt

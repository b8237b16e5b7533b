// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "betwixt/program.h"

namespace betwixt {

// What a program takes beside its document: its arrays and curves. What it shares with the program before counts too;
// environments that go on together, pictures and evaluators at rest do not.
std::size_t bytes_of(const Program&);

}  // namespace betwixt

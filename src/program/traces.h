// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "program/compiled.h"

namespace betwixt {

// Returns the points of a trace, in its own space.
Points trace(const Program::Compiled&, std::uint32_t object, Time, Asking&);
// Returns true if a trace is still being drawn at a time.
bool tracing_at(const Program::Compiled&, Time);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "betwixt/frame.h"
#include "exchange/fonts.h"

namespace betwixt {

// Returns the contours of a text or polygon in object space. They are empty for other kinds, and if a measure is
// absurd.
Outline outline_of(const Shape&);

}  // namespace betwixt

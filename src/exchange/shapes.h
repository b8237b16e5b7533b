// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "betwixt/frame.h"
#include "exchange/fonts.h"

namespace betwixt {

// The contours of a text or polygon in object space; none for other kinds, and where a measure is absurd.
Outline outline_of(const Shape&);

}  // namespace betwixt

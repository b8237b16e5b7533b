// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The style `traced`: pictures by following light. It needs no graphics interface.
#pragma once

#include "betwixt/render.h"

namespace betwixt {

// Works with so many threads, 0: as many as suit the machine; the picture is the same.
Result<std::unique_ptr<Renderer>> make_traced(const RenderOptions&, unsigned threads = 0);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The style `traced`: a path tracer. It needs no graphics interface.
#pragma once

#include "betwixt/render.h"

namespace betwixt {

// Uses this number of threads, 0: as many as suit the machine. The picture does not depend on it.
Result<std::unique_ptr<Renderer>> make_traced(const RenderOptions&, unsigned threads = 0);

}  // namespace betwixt

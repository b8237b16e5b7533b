// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "algebra/kernels.h"

namespace betwixt::algebra {

// Reads and writes what the kernel does, in the same order and by vectors of the same size, and works out nothing: what
// is written is what was read, x and y changed about. `through`: what is drawn goes past the caches.
void copy_all(Kernel, const Arrays<float>&, bool through, unsigned threads);
void copy_all(Kernel, const Arrays<double>&, bool through, unsigned threads);

}  // namespace betwixt::algebra

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "algebra/kernels.h"

namespace betwixt::algebra {

// Reads and writes the same arrays as a kernel, in the same order and in vectors of the same size, but computes
// nothing: it writes what it read, with x and y exchanged. With `through`, stores go past the caches.
void copy_all(Kernel, const Arrays<float>&, bool through, unsigned threads);
void copy_all(Kernel, const Arrays<double>&, bool through, unsigned threads);

}  // namespace betwixt::algebra

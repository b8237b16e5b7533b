// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What memory gives one core just now: a yardstick for all that is bound by it.
#pragma once

#include <cstddef>
#include <vector>

namespace betwixt {

// Past the caches, in the widest registers that this machine has. Both stand at whole lines of the cache and are a
// multiple of one long.
void copy_past_caches(const double* from, double* to, std::size_t count);
// Gigabytes a second, read and written, by copies of arrays that no cache holds; one number a copy.
std::vector<double> copy_rates();

}  // namespace betwixt

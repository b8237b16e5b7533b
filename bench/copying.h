// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures how fast one core copies memory now. Results that memory limits are compared with this.
#pragma once

#include <cstddef>
#include <vector>

namespace betwixt {

// Copies past the caches, in the widest registers of this machine. Both arrays begin at a cache line, and their size is
// a multiple of a cache line.
void copy_past_caches(const double* from, double* to, std::size_t count);
// Returns the speed of each of several copies of arrays larger than all caches, in gigabytes a second, read and
// written.
std::vector<double> copy_rates();

}  // namespace betwixt

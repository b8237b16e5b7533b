// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbered pictures that are there.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "betwixt/result.h"
#include "film/output.h"

namespace betwixt {

// Their numbers, in order: what else lies in the folder does not count. Errors: file (no such folder).
Result<std::set<int>> numbers_there(const Output& pictures);
// A PNG or OpenEXR of that size, to its last byte.
bool whole_picture(const std::string& path, int width, int height);
// What is said of a PNG that is there and was made otherwise: of another size, or with other bits a channel. "" where
// it was not, or is none.
std::string made_otherwise(const std::string& path, int width, int height, int bits);
// "3, 7-9, 12"; of more than 20 runs the first ones.
std::string runs(const std::vector<int>& ascending);

}  // namespace betwixt

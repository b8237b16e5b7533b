// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbered pictures that exist.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "betwixt/linear_picture.h"
#include "betwixt/result.h"
#include "film/output.h"

namespace betwixt {

// Returns their numbers in order; other files in the folder do not count. Errors: file (no such folder).
Result<std::set<int>> numbers_there(const Output& pictures);
// Returns true if the file is a complete PNG or OpenEXR of that size.
bool whole_picture(const std::string& path, int width, int height);
// Returns a message if a PNG exists with another size, other bits a channel or another coding of colours; otherwise "".
std::string made_otherwise(const std::string& path, int width, int height, int bits,
                           ColorCoding colors = ColorCoding::srgb);
// Returns "3, 7-9, 12"; of more than 20 runs the first ones.
std::string runs(const std::vector<int>& ascending);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tables of colours by OpenColorIO, in betwixt-parser only.
#pragma once

#include <functional>
#include <string>

#include "exchange/color_table.h"

namespace betwixt {

// Opens a file for reading. Returns it, or -1.
using OpenForLibrary = std::function<int(const std::string& path)>;

// Makes a table of a configuration or a look file. OpenColorIO opens the files that they name itself, by fopen(): while
// it works, this program's fopen64() calls `open`.
Result<std::shared_ptr<const ColorTable>> colors_by_ocio(const std::string& path, FileSource&, const ColorQuery&,
                                                         const OpenForLibrary& open);

}  // namespace betwixt

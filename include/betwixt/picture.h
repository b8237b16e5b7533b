// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures in files.
//
// Room: exchange
#pragma once

#include <string>

#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

// Written beside it first, then put in place: never half a file. Errors: file (cannot be written), machine (disk full).
Status write_png(const std::string& path, const Picture&, bool overwrite = true);
// PNG, JPEG, TGA, BMP. Errors: file (missing, unreadable, broken), range (more than 16384 pixels a side).
Result<std::shared_ptr<const Picture>> read_picture(const std::string& path);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures in files.
//
// Room: exchange
#pragma once

#include <string>

#include "betwixt/deep_picture.h"
#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

// A PNG, as bytes. Errors: machine.
Result<std::string> to_png(const Picture&);
// Written beside it first, then put in place: never half a file. Errors: file (cannot be written), machine (disk full).
Status write_png(const std::string& path, const Picture&, bool overwrite = true);
// The same of light: as it is shown, with 16 bits a channel; and as it is, in half floats (OpenEXR).
Status write_png(const std::string& path, const DeepPicture&, bool overwrite = true);
Status write_exr(const std::string& path, const DeepPicture&, bool overwrite = true);
// PNG and OpenEXR, as light. Errors: as those of read_picture.
Result<DeepPicture> read_deep_picture(const std::string& path);
// PNG, JPEG, TGA, BMP. Errors: file (missing, unreadable, broken), range (more than 16384 pixels a side).
Result<std::shared_ptr<const Picture>> read_picture(const std::string& path);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads and writes picture files.
//
// Room: exchange
#pragma once

#include <string>

#include "betwixt/linear_picture.h"
#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

// Returns a PNG as bytes. Errors: machine.
Result<std::string> to_png(const Picture&);
// Write a temporary file beside the final one and rename it, so that there is never an incomplete file under the final
// name. Errors: file (cannot be written), machine (disk full).
Status write_png(const std::string& path, const Picture&, bool overwrite = true);
// The same for linear light: a PNG with 16 bits a channel, as a screen shows it; an OpenEXR in half floats, unchanged.
// Both say in the file how its colours are coded; of an OpenEXR this says the primaries only.
Status write_png(const std::string& path, const LinearPicture&, bool overwrite = true,
                 ColorCoding colors = ColorCoding::srgb);
Status write_exr(const std::string& path, const LinearPicture&, bool overwrite = true,
                 ColorCoding colors = ColorCoding::srgb);
// Reads PNG or OpenEXR and returns linear light. Errors: those of read_picture.
Result<LinearPicture> read_linear_picture(const std::string& path);
// Reads PNG, JPEG, TGA or BMP. Errors: file (missing, unreadable, broken), range (more than 16384 pixels a side).
Result<std::shared_ptr<const Picture>> read_picture(const std::string& path);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole files in and out.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

using Bytes = std::vector<std::uint8_t>;

// Errors: file (missing, a folder, not allowed, more than 1 GiB).
Result<Bytes> read_whole(const std::string& path);
// Beside it first, then in place: never half a file. What is no plain file (a pipe, a device) is written to as it is.
Status write_whole(const std::string& path, std::span<const std::uint8_t> bytes, bool overwrite);

// `name` for messages and, where the bytes do not say it, for its ending.
Result<std::shared_ptr<const Picture>> decode_picture(std::span<const std::uint8_t> bytes, const std::string& name);

// What follows the last dot of the file's name, in small letters.
std::string ending(const std::string& path);

}  // namespace betwixt

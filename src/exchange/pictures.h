// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads pictures in this process, without protection.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "betwixt/linear_picture.h"
#include "betwixt/result.h"
#include "exchange/file_source.h"

namespace betwixt {

// `name` is for messages; its ending tells the format if the bytes do not.
Result<std::shared_ptr<const Picture>> decode_picture(std::span<const std::uint8_t> bytes, const std::string& name);
// Reads a picture of a script. Errors: those of read_picture; range (unpacking.h; not with `any_size`).
Result<std::shared_ptr<const Picture>> load_picture(const std::string& path, bool any_size);
// Like read_picture().
Result<std::shared_ptr<const Picture>> parse_picture(const std::string& path, FileSource&);
// Like read_linear_picture().
Result<std::shared_ptr<const LinearPicture>> parse_linear_picture(const std::string& path, FileSource&);

inline constexpr std::string_view exr_begins = "\x76\x2f\x31\x01";
// Like parse_linear_picture().
Result<LinearPicture> decode_exr(std::string_view bytes, const std::string& name);

// check_size(): whether the picture can be read. check_picture(): whether these are all channels of a picture that can
// be written. Errors: range.
Status check_size(const std::string& name, std::int64_t width, std::int64_t height);
Status check_picture(int width, int height, std::size_t channels);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "base/files.h"
#include "base/sha256.h"
#include "exchange/font_face.h"

namespace betwixt {
namespace {

constexpr std::uint64_t largest_font = 32 << 20;

}  // namespace

Result<std::shared_ptr<const OwnFont>> load_font(const std::string& path) {
  auto bytes = read_whole(path);
  if (!bytes) return bytes.error();
  if (bytes->size() > largest_font)
    return fail(ErrorCode::range, fmt::format("{} has more than {} MiB", path, largest_font >> 20));
  auto font = std::make_shared<OwnFont>();
  font->bytes = *std::move(bytes);
  for (const std::uint8_t byte : sha256(font->bytes)) font->digest += fmt::format("{:02x}", byte);
  const auto face = open_own_font(font);
  if (!face) return fail(ErrorCode::file, fmt::format("{} is not a font with outlines", path));
  if (const auto shaped = face->shape("Ag"); !shaped) {
    Error e = shaped.error();
    e.message = fmt::format("{}: {}", path, e.message);
    return e;
  }
  return std::shared_ptr<const OwnFont>(std::move(font));
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures as JPEG.
#include <stb/stb_image_write.h>

#include "base/files.h"
#include "betwixt/film.h"

namespace betwixt {

Result<std::string> jpeg_of(const Picture& picture, int quality) {
  std::vector<std::uint8_t> rgb(picture.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < picture.rgba.size() / 4; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      rgb[3 * i + c] = static_cast<std::uint8_t>((picture.rgba[4 * i + c] * picture.rgba[4 * i + 3] + 127) / 255);
  std::string file;
  const auto add = [](void* to, void* bytes, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
  };
  if (!stbi_write_jpg_to_func(add, &file, picture.width, picture.height, 3, rgb.data(), quality))
    return fail(ErrorCode::machine, "the picture cannot be written as JPEG");
  return file;
}

Status write_jpeg(const std::string& path, const Picture& picture, int quality, bool overwrite) {
  const Result<std::string> file = jpeg_of(picture, quality);
  return file ? write_whole(path, *file, overwrite) : Status(file.error());
}

}  // namespace betwixt

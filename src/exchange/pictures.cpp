// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/pictures.h"

#include <fmt/format.h>
#include <spng.h>
#include <stb_image.h>

#include <cstdlib>
#include <cstring>
#include <memory>

#include "base/files.h"
#include "betwixt/picture.h"

namespace betwixt {
namespace {

constexpr int most_pixels_a_side = 16384;

struct Free {
  void operator()(spng_ctx* c) const { spng_ctx_free(c); }
  void operator()(void* p) const { std::free(p); }
  void operator()(stbi_uc* p) const { stbi_image_free(p); }
};
using Png = std::unique_ptr<spng_ctx, Free>;
using Decoded = Result<std::shared_ptr<const Picture>>;

Error broken(const std::string& name, const char* why) {
  return fail(ErrorCode::file, fmt::format("{} is broken or not a picture: {}", name, why));
}

Status check_size(const std::string& name, std::uint64_t width, std::uint64_t height) {
  if (width >= 1 && height >= 1 && width <= most_pixels_a_side && height <= most_pixels_a_side) return Nothing{};
  return fail(ErrorCode::range, fmt::format("{} has {} by {} pixels; 1 to {} a side can be read", name, width, height,
                                            most_pixels_a_side));
}

std::size_t size_of(const Picture& p) {
  return 4 * static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height);
}

Decoded decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  const Png png(spng_ctx_new(0));
  if (!png) return fail(ErrorCode::machine, "out of memory");
  spng_ihdr head{};
  int error = spng_set_png_buffer(png.get(), bytes.data(), bytes.size());
  if (error == 0) error = spng_get_ihdr(png.get(), &head);
  if (error != 0) return broken(name, spng_strerror(error));
  if (const Status size = check_size(name, head.width, head.height); !size) return size.error();
  auto picture = std::make_shared<Picture>();
  picture->width = static_cast<int>(head.width), picture->height = static_cast<int>(head.height);
  picture->rgba.resize(size_of(*picture));
  error = spng_decode_image(png.get(), picture->rgba.data(), picture->rgba.size(), SPNG_FMT_RGBA8, SPNG_DECODE_TRNS);
  if (error != 0) return broken(name, spng_strerror(error));
  return std::shared_ptr<const Picture>(std::move(picture));
}

Decoded decode_other(std::span<const std::uint8_t> bytes, const std::string& name) {
  int width = 0, height = 0, channels = 0;
  const int length = static_cast<int>(bytes.size());
  const auto why = [] { return stbi_failure_reason() != nullptr ? stbi_failure_reason() : "no reason given"; };
  if (stbi_info_from_memory(bytes.data(), length, &width, &height, &channels) == 0) return broken(name, why());
  if (const Status size = check_size(name, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
      !size)
    return size.error();
  const std::unique_ptr<stbi_uc, Free> pixels(
      stbi_load_from_memory(bytes.data(), length, &width, &height, &channels, 4));
  if (!pixels) return broken(name, why());
  auto picture = std::make_shared<Picture>();
  picture->width = width, picture->height = height;
  picture->rgba.assign(pixels.get(), pixels.get() + size_of(*picture));
  return std::shared_ptr<const Picture>(std::move(picture));
}

bool begins(std::span<const std::uint8_t> bytes, std::string_view with) {
  return bytes.size() >= with.size() && std::memcmp(bytes.data(), with.data(), with.size()) == 0;
}

}  // namespace

Decoded decode_picture(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (bytes.empty()) return fail(ErrorCode::file, fmt::format("{} is empty", name));
  if (begins(bytes, "\x89PNG")) return decode_png(bytes, name);
  if (begins(bytes, "\xff\xd8") || begins(bytes, "BM") || ending(name) == "tga") return decode_other(bytes, name);
  return fail(ErrorCode::file, fmt::format("{} is not a picture that can be read", name),
              "PNG, JPEG, TGA and BMP can be");
}

Decoded parse_picture(const std::string& path, Shelf& shelf) {
  const auto bytes = shelf.read(path);
  if (!bytes) return bytes.error();
  return decode_picture(as_bytes(*bytes), path);
}

Status write_png(const std::string& path, const Picture& picture, bool overwrite) {
  if (picture.width < 1 || picture.height < 1 || picture.rgba.size() != size_of(picture))
    return fail(ErrorCode::range,
                fmt::format("a picture of {} by {} pixels cannot be written", picture.width, picture.height));
  const Png png(spng_ctx_new(SPNG_CTX_ENCODER));
  if (!png) return fail(ErrorCode::machine, "out of memory");
  spng_ihdr head{};
  head.width = static_cast<std::uint32_t>(picture.width), head.height = static_cast<std::uint32_t>(picture.height);
  head.bit_depth = 8, head.color_type = SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_option(png.get(), SPNG_IMG_COMPRESSION_LEVEL, 4);  // half the time of the usual 6 for a few per cent
  spng_set_ihdr(png.get(), &head);
  spng_set_srgb(png.get(), 0);
  const int error =
      spng_encode_image(png.get(), picture.rgba.data(), picture.rgba.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  if (error != 0) return fail(ErrorCode::machine, fmt::format("cannot encode {}: {}", path, spng_strerror(error)));
  int result = 0;
  std::size_t length = 0;
  const std::unique_ptr<void, Free> bytes(spng_get_png_buffer(png.get(), &length, &result));
  if (!bytes) return fail(ErrorCode::machine, fmt::format("cannot encode {}: {}", path, spng_strerror(result)));
  return write_whole(path, {static_cast<const char*>(bytes.get()), length}, overwrite);
}

}  // namespace betwixt

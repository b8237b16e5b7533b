// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/pictures.h"

#include <fmt/format.h>
#include <spng.h>
#include <stb_image.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "base/files.h"
#include "betwixt/picture.h"
#include "exchange/unpacking.h"

namespace betwixt {

Status check_size(const std::string& name, std::int64_t width, std::int64_t height) {
  constexpr std::int64_t most_pixels_a_side = 16384;
  if (width >= 1 && height >= 1 && width <= most_pixels_a_side && height <= most_pixels_a_side) return Nothing{};
  return fail(ErrorCode::range, fmt::format("{} has {} by {} pixels; each side must have from 1 to {}", name, width,
                                            height, most_pixels_a_side));
}

namespace {

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

std::size_t size_of(const Picture& p) {
  return 4 * static_cast<std::size_t>(p.width) * static_cast<std::size_t>(p.height);
}

// A picture with four channels of sizeof(Channel) bytes each.
template <class Channel>
struct Raw {
  int width = 0, height = 0;
  std::vector<Channel> rgba;
};
template <class Channel>
Result<Raw<Channel>> read_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  const Png png(spng_ctx_new(0));
  if (!png) return fail(ErrorCode::machine, "out of memory");
  spng_ihdr head{};
  constexpr std::size_t most_beside = std::size_t{64} << 20;  // bytes of compressed texts and profiles
  spng_set_chunk_limits(png.get(), most_beside, most_beside);
  int error = spng_set_png_buffer(png.get(), bytes.data(), bytes.size());
  if (error == 0) error = spng_get_ihdr(png.get(), &head);
  if (error != 0) return broken(name, spng_strerror(error));
  if (const Status size = check_size(name, head.width, head.height); !size) return size.error();
  if (const Status fits = unpack(4 * sizeof(Channel) * std::uint64_t{head.width} * head.height, name); !fits)
    return fits.error();
  Raw<Channel> raw{static_cast<int>(head.width), static_cast<int>(head.height), {}};
  raw.rgba.resize(4 * static_cast<std::size_t>(head.width) * head.height);
  error = spng_decode_image(png.get(), raw.rgba.data(), raw.rgba.size() * sizeof(Channel),
                            sizeof(Channel) == 1 ? SPNG_FMT_RGBA8 : SPNG_FMT_RGBA16, SPNG_DECODE_TRNS);
  if (error != 0) return broken(name, spng_strerror(error));
  return raw;
}

Decoded decode_png(std::span<const std::uint8_t> bytes, const std::string& name) {
  auto raw = read_png<std::uint8_t>(bytes, name);
  if (!raw) return raw.error();
  return std::make_shared<const Picture>(Picture{raw->width, raw->height, std::move(raw->rgba)});
}

Decoded decode_other(std::span<const std::uint8_t> bytes, const std::string& name) {
  int width = 0, height = 0, channels = 0;
  const int length = static_cast<int>(bytes.size());
  const auto why = [] { return stbi_failure_reason() != nullptr ? stbi_failure_reason() : "no reason given"; };
  if (stbi_info_from_memory(bytes.data(), length, &width, &height, &channels) == 0) return broken(name, why());
  if (const Status size = check_size(name, width, height); !size) return size.error();
  if (const Status fits = unpack(4 * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height), name);
      !fits)
    return fits.error();
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
  return fail(ErrorCode::file, fmt::format("the picture format of {} is not supported", name),
              "supported: PNG, JPEG, TGA and BMP");
}

Decoded parse_picture(const std::string& path, FileSource& files) {
  const auto bytes = files.read(path);
  if (!bytes) return bytes.error();
  return decode_picture(as_bytes(*bytes), path);
}

Status check_picture(int width, int height, std::size_t channels) {
  if (width >= 1 && height >= 1 && channels == 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
    return Nothing{};
  return fail(ErrorCode::range, fmt::format("a picture of {} by {} pixels cannot be written", width, height));
}

namespace {

// Returns whether most pixels of `size` bytes equal their left neighbour. Looks at every 16th row.
bool repeats(std::span<const std::byte> rgba, std::size_t row, std::size_t size) {
  std::size_t repeated = 0, seen = 0;
  for (std::size_t y = 0; y < rgba.size(); y += 16 * row)
    for (std::size_t at = y + size; at < y + row; at += size, ++seen)
      repeated += std::memcmp(&rgba[at], &rgba[at - size], size) == 0 ? 1 : 0;
  return 2 * repeated > seen;
}

// The chunk cICP: the numbers of primaries, curve and matrix in ITU-T H.273, and the full range.
using Cicp = std::array<std::uint8_t, 4>;
constexpr Cicp cicp_of(ColorCoding c) {
  constexpr Cicp all[] = {{1, 13, 0, 1}, {12, 13, 0, 1}, {9, 13, 0, 1}, {9, 16, 0, 1}, {9, 18, 0, 1}};
  return all[static_cast<std::size_t>(c)];
}

// The encoder reads the chunk when it encodes, so both live as long as it does.
struct CicpChunk {
  Cicp bytes{};
  spng_unknown_chunk chunk{};
};

// Says how the colours are coded. Programs that do not know cICP find the primaries and about the curve.
void say_colors(spng_ctx* png, ColorCoding colors, CicpChunk& kept) {
  if (colors == ColorCoding::srgb) return void(spng_set_srgb(png, 0));
  kept.bytes = cicp_of(colors);
  std::memcpy(kept.chunk.type, "cICP", 4);
  kept.chunk.length = kept.bytes.size(), kept.chunk.data = kept.bytes.data(), kept.chunk.location = SPNG_AFTER_IHDR;
  spng_set_unknown_chunks(png, &kept.chunk, 1);
  spng_chrm primaries = colors == ColorCoding::p3 ? spng_chrm{0.3127, 0.329, 0.68, 0.32, 0.265, 0.69, 0.15, 0.06}
                                                  : spng_chrm{0.3127, 0.329, 0.708, 0.292, 0.17, 0.797, 0.131, 0.046};
  spng_set_chrm(png, &primaries);
  if (!has_highlights(colors)) spng_set_gama(png, 1 / 2.2);
}

// Returns how the colours of a PNG are coded, by its cICP.
ColorCoding coding_of_png(std::span<const std::uint8_t> bytes) {
  for (std::size_t at = 8; at + 16 <= bytes.size();) {
    const auto chunk = bytes.subspan(at);
    const std::size_t length =
        std::size_t{chunk[0]} << 24 | std::size_t{chunk[1]} << 16 | std::size_t{chunk[2]} << 8 | chunk[3];
    if (begins(chunk.subspan(4), "IDAT")) break;
    if (begins(chunk.subspan(4), "cICP") && length == 4)
      for (std::size_t c = 0; c < color_coding_names.size(); ++c) {
        const auto known = cicp_of(static_cast<ColorCoding>(c));
        if (chunk[8] == known[0] && chunk[9] == known[1]) return static_cast<ColorCoding>(c);
      }
    at += 12 + length;
  }
  return ColorCoding::srgb;
}

// `rgba`: straight alpha, `bits` bits a channel.
Result<std::string> to_png(int width, int height, std::uint8_t bits, std::span<const std::byte> rgba,
                           ColorCoding colors = ColorCoding::srgb) {
  if (Status s = check_picture(width, height, 8 * rgba.size() / bits); !s) return s.error();
  CicpChunk cicp;
  const Png png(spng_ctx_new(SPNG_CTX_ENCODER));
  if (!png) return fail(ErrorCode::machine, "out of memory");
  const std::size_t size = bits / 2;  // bytes of a pixel
  const bool plain = repeats(rgba, size * static_cast<std::size_t>(width), size);
  spng_ihdr head{};
  head.width = static_cast<std::uint32_t>(width), head.height = static_cast<std::uint32_t>(height);
  head.bit_depth = bits, head.color_type = SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
  // On the pictures of the examples this takes an eighth of the time of level 4 with all filters, and a quarter more
  // space. Photographs need the filters.
  spng_set_option(png.get(), SPNG_IMG_COMPRESSION_LEVEL, plain ? 3 : 4);
  if (plain) spng_set_option(png.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_NONE);
  spng_set_ihdr(png.get(), &head);
  say_colors(png.get(), colors, cicp);
  const int error = spng_encode_image(png.get(), rgba.data(), rgba.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  if (error != 0) return fail(ErrorCode::machine, fmt::format("a picture cannot be encoded: {}", spng_strerror(error)));
  int result = 0;
  std::size_t length = 0;
  const std::unique_ptr<void, Free> bytes(spng_get_png_buffer(png.get(), &length, &result));
  if (!bytes) return fail(ErrorCode::machine, fmt::format("a picture cannot be encoded: {}", spng_strerror(result)));
  return std::string(static_cast<const char*>(bytes.get()), length);
}

Status write(const std::string& path, const Result<std::string>& png, bool overwrite) {
  return png ? write_whole(path, *png, overwrite) : png.error();
}

}  // namespace

Result<std::string> to_png(const Picture& picture) {
  return to_png(picture.width, picture.height, 8, std::as_bytes(std::span(picture.rgba)));
}

Status write_png(const std::string& path, const Picture& picture, bool overwrite) {
  return write(path, to_png(picture), overwrite);
}

Status write_png(const std::string& path, const LinearPicture& picture, bool overwrite, ColorCoding colors) {
  const std::vector<std::uint16_t> shown = to_coded_16(picture, colors);
  return write(path, to_png(picture.width, picture.height, 16, std::as_bytes(std::span(shown)), colors), overwrite);
}

namespace {

// Reads bytes one after the other; `ended` says that there were too few.
struct ByteReader {
  std::span<const std::uint8_t> left;
  bool ended = false;

  std::uint8_t next() {
    if (left.empty()) return ended = true, std::uint8_t{0};
    const std::uint8_t byte = left.front();
    left = left.subspan(1);
    return byte;
  }
  std::string line() {
    std::string text;
    for (char c = static_cast<char>(next()); c != '\n' && !ended && text.size() < 1024; c = static_cast<char>(next()))
      text += c;
    return text;
  }
};

// Fills a row of Radiance: four channels in runs, or pixel by pixel. Returns false if a run is too long.
bool read_radiance_row(ByteReader& from, std::vector<std::array<std::uint8_t, 4>>& row) {
  const std::size_t width = row.size();
  for (std::uint8_t& byte : row[0]) byte = from.next();
  const auto& head = row[0];
  const bool runs = width >= 8 && width < 32768 && head[0] == 2 && head[1] == 2 &&
                    static_cast<std::size_t>(256 * head[2] + head[3]) == width;
  if (!runs) {
    for (std::size_t x = 1; x < width && !from.ended; ++x)
      for (std::uint8_t& byte : row[x]) byte = from.next();
    return true;
  }
  for (std::size_t channel = 0; channel < 4; ++channel)
    for (std::size_t x = 0; x < width && !from.ended;) {
      const std::uint8_t count = from.next();
      const std::size_t length = count > 128 ? count - 128 : count;
      if (from.ended) break;
      if (length == 0 || length > width - x) return false;
      const std::uint8_t same = count > 128 ? from.next() : 0;
      for (std::size_t k = 0; k < length; ++k) row[x++][channel] = count > 128 ? same : from.next();
    }
  return true;
}

// Radiance: RGB with a common exponent. Light is at most what OpenEXR's half floats hold. Our own reader: that of stb
// does not come to an end, or leaves rows black, where a file ends too early.
Result<LinearPicture> decode_hdr(std::span<const std::uint8_t> bytes, const std::string& name) {
  ByteReader from{bytes};
  bool rgbe = false;
  for (std::string line = from.line(); !line.empty() && !from.ended; line = from.line())
    rgbe |= line == "FORMAT=32-bit_rle_rgbe";
  const std::string size = from.line();
  int width = 0, height = 0, read = 0;
  if (!rgbe || std::sscanf(size.c_str(), "-Y %d +X %d%n", &height, &width, &read) != 2)
    return broken(name, "its head is not that of 32-bit_rle_rgbe, -Y … +X …");
  if (const Status fits = check_size(name, width, height); !fits) return fits.error();
  const std::size_t wide = static_cast<std::size_t>(width), numbers = 4 * wide * static_cast<std::size_t>(height);
  if (const Status fits = unpack(numbers * sizeof(float), name); !fits) return fits.error();
  constexpr float most = 65504;
  LinearPicture picture{width, height, {}};
  picture.rgba.reserve(numbers);
  std::vector<std::array<std::uint8_t, 4>> row(wide);
  for (int y = 0; y < height; ++y) {
    if (!read_radiance_row(from, row)) return broken(name, "a run is longer than its row");
    if (from.ended) return broken(name, "it ends too early");
    for (const auto& [r, g, b, exponent] : row) {
      const float unit = exponent == 0 ? 0 : std::ldexp(1.0F, exponent - 136);
      for (const std::uint8_t c : {r, g, b}) picture.rgba.push_back(std::min(unit * static_cast<float>(c), most));
      picture.rgba.push_back(1);
    }
  }
  return picture;
}

LinearPicture as_light(const Picture& p) {
  std::vector<std::uint16_t> wide(p.rgba.size());
  std::transform(p.rgba.begin(), p.rgba.end(), wide.begin(),
                 [](std::uint8_t byte) { return static_cast<std::uint16_t>(257 * byte); });
  return to_light(p.width, p.height, wide);
}

}  // namespace

Result<std::shared_ptr<const LinearPicture>> parse_linear_picture(const std::string& path, FileSource& files) {
  const auto bytes = files.read(path);
  if (!bytes) return bytes.error();
  const auto shared = [](LinearPicture picture) { return std::make_shared<const LinearPicture>(std::move(picture)); };
  if (begins(as_bytes(*bytes), exr_begins)) {
    auto read = decode_exr(*bytes, path);
    if (!read) return read.error();
    return shared(*std::move(read));
  }
  if (begins(as_bytes(*bytes), "#?")) {
    auto read = decode_hdr(as_bytes(*bytes), path);
    if (!read) return read.error();
    return shared(*std::move(read));
  }
  if (begins(as_bytes(*bytes), "\xff\xd8")) {
    const auto read = decode_picture(as_bytes(*bytes), path);
    if (!read) return read.error();
    return shared(as_light(**read));
  }
  if (!begins(as_bytes(*bytes), "\x89PNG"))
    return fail(ErrorCode::file, fmt::format("the picture format of {} is not supported", path),
                "supported: PNG, OpenEXR, Radiance (.hdr) and JPEG");
  auto raw = read_png<std::uint16_t>(as_bytes(*bytes), path);
  if (!raw) return raw.error();
  return shared(to_light(raw->width, raw->height, raw->rgba, coding_of_png(as_bytes(*bytes))));
}

}  // namespace betwixt

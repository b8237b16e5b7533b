// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/numbered.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "base/files.h"
#include "betwixt/picture.h"
#include "exchange/pictures.h"

namespace betwixt {

Result<std::set<int>> numbers_there(const Output& pictures) {
  std::set<int> all;
  std::error_code failed;
  const std::filesystem::directory_iterator folder(pictures.folder, failed);
  if (failed == std::errc::no_such_file_or_directory)
    return fail(ErrorCode::file, "there is no folder " + pictures.folder);
  if (failed) return system_error(failed.value(), "read", pictures.folder);
  for (const auto& entry : folder) {
    const std::string name = entry.path().filename().string();
    const std::size_t around = pictures.before.size() + pictures.after.size();
    if (name.size() <= around || !name.starts_with(pictures.before) || !name.ends_with(pictures.after)) continue;
    int number = 0;
    const char* const end = name.data() + name.size() - pictures.after.size();
    const auto read = std::from_chars(name.data() + pictures.before.size(), end, number);
    // Only the exact name: frame-7.png is not part of frame-%04d.png.
    if (read.ec == std::errc() && read.ptr == end && pictures.path(number) == pictures.folder + '/' + name)
      all.insert(number);
  }
  return all;
}

bool whole_picture(const std::string& path, int width, int height) {
  using namespace std::string_view_literals;
  if (ending(path) == "exr") {
    const auto bytes = read_whole(path);
    if (!bytes) return false;
    const auto light = decode_exr(*bytes, path);
    return light && light->width == width && light->height == height;
  }
  constexpr auto end = "\0\0\0\0IEND\xae\x42\x60\x82"sv;  // readers of pictures do not check it
  const auto bytes = read_whole(path);
  if (!bytes || !bytes->ends_with(end)) return false;
  const auto picture = read_picture(path);
  return picture && (*picture)->width == width && (*picture)->height == height;
}

std::string made_otherwise(const std::string& path, int width, int height, int bits, ColorCoding colors) {
  std::ifstream file(path, std::ios::binary);
  // Signature; length and name of the first chunk, width, height, bits, …; then chunks about the colours.
  std::array<char, 256> head{};
  file.read(head.data(), head.size());
  const std::string_view begin(head.data(), static_cast<std::size_t>(file.gcount()));
  if (begin.size() < 25 || !begin.starts_with("\x89P")) return "";
  const auto number = [&](std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(begin[i]); };
    return byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
  };
  const int wide = number(16), tall = number(20), deep = head[24];
  if (wide < 1 || tall < 1) return "";
  if (wide != width || tall != height)
    return fmt::format("{} has {}x{} pixels, not {}x{}", path, wide, tall, width, height);
  if (deep != bits) return fmt::format("{} has {} bits a channel, not {}", path, deep, bits);
  constexpr std::string_view codings[] = {"cICP\x01\x0d", "cICP\x0c\x0d", "cICP\x09\x0d", "cICP\x09\x10",
                                          "cICP\x09\x12"};
  const std::size_t at = begin.find("cICP");
  const auto* const is = std::find(std::begin(codings), std::end(codings), at == begin.npos ? "" : begin.substr(at, 6));
  const ColorCoding has = is == std::end(codings) ? ColorCoding::srgb : static_cast<ColorCoding>(is - codings);
  const auto name = [](ColorCoding c) { return color_coding_names[static_cast<std::size_t>(c)]; };
  return has == colors ? "" : fmt::format("{} has its colors in {}, not in {}", path, name(has), name(colors));
}

std::string runs(const std::vector<int>& ascending) {
  constexpr int most = 20;
  std::string all;
  int said = 0;
  for (std::size_t i = 0; i < ascending.size();) {
    std::size_t last = i;
    while (last + 1 < ascending.size() && ascending[last + 1] == ascending[last] + 1) ++last;
    if (said++ == most) return all + ", …";
    if (!all.empty()) all += ", ";
    all += last == i ? fmt::format("{}", ascending[i]) : fmt::format("{}-{}", ascending[i], ascending[last]);
    i = last + 1;
  }
  return all;
}

}  // namespace betwixt

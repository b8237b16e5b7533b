// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/video_strip.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace betwixt {
namespace {

constexpr std::string_view first_word = "betwixt-pictures-1";

// Whole numbers, one after the other.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : rest_(text) {}
  std::optional<std::int64_t> next() {
    while (rest_.starts_with(' ') || rest_.starts_with('\n')) rest_.remove_prefix(1);
    std::int64_t n = 0;
    const auto [end, failed] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), n);
    if (failed != std::errc()) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return n;
  }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

}  // namespace

std::string write_strip(const VideoStrip& strip) {
  std::string out =
      fmt::format("{} {} {} {} {} {} {}\n", first_word, strip.width, strip.height,
                  static_cast<std::int64_t>(strip.aspect * 1e9), strip.end, strip.slack, strip.begins.size());
  for (std::size_t k = 0; k < strip.begins.size(); ++k)
    out += fmt::format("{} {}\n", strip.begins[k], strip.pictures[k].size());
  for (const std::string& picture : strip.pictures) out += picture;
  return out;
}

Result<VideoStrip> read_strip(std::string_view bytes, const std::string& name) {
  const Error broken = fail(ErrorCode::file, fmt::format("{} is broken", name));
  if (!bytes.starts_with(first_word)) return broken;
  Numbers numbers(bytes.substr(first_word.size()));
  std::int64_t head[6]{};
  for (std::int64_t& to : head)
    if (const auto n = numbers.next())
      to = *n;
    else
      return broken;
  const auto [width, height, aspect, end, slack, count] = head;
  constexpr std::int64_t most_side = 1 << 14;
  if (width < 1 || height < 1 || width > most_side || height > most_side || aspect < 1 || end < 1 || slack < 0 ||
      count < 1 || count > static_cast<std::int64_t>(bytes.size()))
    return broken;
  VideoStrip strip{
      static_cast<int>(width), static_cast<int>(height), static_cast<double>(aspect) / 1e9, end, slack, {}, {}};
  std::vector<std::size_t> sizes;
  std::size_t sum = 0;
  for (std::int64_t k = 0; k < count; ++k) {
    const auto begin = numbers.next(), size = numbers.next();
    if (!begin || !size || *size < 1 || *size > static_cast<std::int64_t>(bytes.size())) return broken;
    if (!strip.begins.empty() && *begin <= strip.begins.back()) return broken;
    strip.begins.push_back(*begin), sizes.push_back(static_cast<std::size_t>(*size));
    sum += sizes.back();
  }
  std::string_view rest = numbers.rest();
  if (rest.size() != sum + 1) return broken;
  rest.remove_prefix(1);
  for (const std::size_t size : sizes) strip.pictures.emplace_back(rest.substr(0, size)), rest.remove_prefix(size);
  return strip;
}

}  // namespace betwixt

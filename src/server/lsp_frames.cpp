// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/lsp_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace betwixt {
namespace {

constexpr std::size_t longest_head = 16'384;

// Where the empty line below the first lines is, and how many bytes it and the end of the line above it take.
std::pair<std::size_t, std::size_t> end_of_head(std::string_view bytes) {
  for (std::size_t at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1)) {
    if (bytes.substr(at + 1, 1) == "\n") return {at, 2};
    if (bytes.substr(at + 1, 2) == "\r\n") return {at, 3};
  }
  return {std::string_view::npos, 0};
}

std::optional<std::size_t> content_length(std::string_view head) {
  constexpr std::string_view key = "content-length:";
  while (!head.empty()) {
    const std::size_t end = std::min(head.find('\n'), head.size());
    std::string_view line = head.substr(0, end);
    head.remove_prefix(std::min(head.size(), end + 1));
    const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    if (line.size() < key.size() ||
        !std::equal(key.begin(), key.end(), line.begin(), [&](char k, char c) { return same(c, k); }))
      continue;
    line.remove_prefix(key.size());
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) line.remove_suffix(1);
    std::size_t n = 0;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), n);
    if (error == std::errc() && stop == line.data() + line.size() && !line.empty()) return n;
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> LspFrames::next(std::string* refused) {
  for (;;) {
    const std::size_t there = std::min(pass_over_, bytes_.size() - begun_);
    begun_ += there, pass_over_ -= there;
    if (begun_ > bytes_.size() / 2) bytes_.erase(0, begun_), begun_ = 0;
    const std::string_view rest = std::string_view(bytes_).substr(begun_);
    if (rest.empty() || pass_over_ > 0) return std::nullopt;
    const auto [end, gap] = end_of_head(rest.substr(0, longest_head));
    if (end == std::string_view::npos) {
      if (rest.size() < longest_head) return std::nullopt;
      pass_over_ = rest.size();
      if (refused) *refused = "this is no message: it does not say its length";
      continue;
    }
    const auto length = content_length(rest.substr(0, end));
    if (!length || *length > longest) {
      pass_over_ = end + gap + length.value_or(0);
      if (pass_over_ < end + gap) pass_over_ = rest.size();  // no number of bytes
      if (refused)
        *refused = length ? fmt::format("a message of {} bytes is longer than any can be: {}", *length, longest)
                          : "this is no message: it does not say its length";
      continue;
    }
    if (rest.size() - end - gap < *length) return std::nullopt;
    std::string message(rest.substr(end + gap, *length));
    begun_ += end + gap + *length;
    return message;
  }
}

std::string LspFrames::framed(std::string_view message) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", message.size(), message);
}

}  // namespace betwixt

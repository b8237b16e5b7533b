// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "lsp/framing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace betwixt {
namespace {

constexpr std::size_t longest_head = 16'384;
constexpr std::size_t longest_line = 64;  // for "Content-Length: N"

// Returns the end of a head: the position of the line end before the empty line, and the bytes that both ends take.
std::pair<std::size_t, std::size_t> end_of_head(std::string_view bytes) {
  for (std::size_t at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1)) {
    if (bytes.substr(at + 1, 1) == "\n") return {at, 2};
    if (bytes.substr(at + 1, 2) == "\r\n") return {at, 3};
  }
  return {std::string_view::npos, 0};
}

constexpr std::string_view key = "content-length:";
bool same(char letter, char of_key) { return std::tolower(static_cast<unsigned char>(letter)) == of_key; }

// Returns where the next line "Content-Length: N" begins, at or after `from`.
std::size_t find_length_line(std::string_view bytes, std::size_t from) {
  for (;; from += key.size()) {
    const auto at =
        std::search(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(), key.begin(), key.end(), same);
    if (at == bytes.end()) return std::string_view::npos;
    from = static_cast<std::size_t>(at - bytes.begin());
    const std::size_t number = bytes.find_first_not_of(' ', from + key.size());
    const std::size_t end = std::min(bytes.find_first_not_of("0123456789", number), bytes.size());
    const std::string_view rest = bytes.substr(end, 2);
    if (number < end && (rest.starts_with('\n') || rest == "\r\n")) return from;
  }
}

std::optional<std::size_t> content_length(std::string_view head) {
  const std::size_t at = find_length_line(head, 0);
  if (at == std::string_view::npos) return std::nullopt;
  const char* const begin = head.data() + head.find_first_not_of(' ', at + key.size());
  std::size_t n = 0;
  const auto read = std::from_chars(begin, head.data() + head.size(), n);
  return read.ec == std::errc() ? n : static_cast<std::size_t>(-1);
}

}  // namespace

// Skips everything before the next head. Returns false if none has arrived.
bool LspFrames::find_head() {
  const std::size_t at = find_length_line(bytes_, begun_);
  const std::size_t kept = std::min(bytes_.size() - begun_, longest_head);
  begun_ = at != std::string::npos ? at : bytes_.size() - kept;
  lost_ = at == std::string::npos;
  return !lost_;
}

std::optional<std::string> LspFrames::next(std::string* refused) {
  const auto lose = [&](std::size_t bytes, std::string why) {
    begun_ += bytes, lost_ = true;
    if (refused) *refused = std::move(why);
  };
  for (;;) {
    if (begun_ > bytes_.size() / 2) bytes_.erase(0, begun_), scanned_ -= std::min(scanned_, begun_), begun_ = 0;
    if (lost_ && !find_head()) return std::nullopt;
    const std::string_view rest = std::string_view(bytes_).substr(begun_);
    const auto [end, gap] = end_of_head(rest.substr(0, longest_head));
    if (end == std::string_view::npos) {
      if (rest.size() < longest_head) return std::nullopt;
      lose(1, "this is not a message: its length is missing");
      continue;
    }
    const auto length = content_length(rest.substr(0, end + 1));
    if (!length || *length > longest) {
      lose(end + gap, length ? fmt::format("a message can have at most {} bytes", longest)
                             : "this is not a message: its length is missing");
      continue;
    }
    const std::size_t body = end + gap, whole = std::min(body + *length, rest.size());
    const std::size_t next_head =
        find_length_line(rest.substr(0, whole), std::max(body, scanned_ - std::min(scanned_, begun_)));
    if (next_head != std::string_view::npos) {
      lose(next_head, "a message is shorter than its stated length");
      continue;
    }
    scanned_ = begun_ + std::max(body, whole - std::min(whole, longest_line));
    if (whole < body + *length) return std::nullopt;
    begun_ += whole;
    return std::string(rest.substr(body, *length));
  }
}

std::string LspFrames::framed(std::string_view message) {
  return fmt::format("Content-Length: {}\r\n\r\n{}", message.size(), message);
}

}  // namespace betwixt

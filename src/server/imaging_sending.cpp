// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes that hosts send: `send NAME LENGTH` and then the bytes themselves.
#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "exchange/sent.h"
#include "language/json.h"
#include "server/answers.h"
#include "server/imaging.h"

namespace betwixt {
namespace {

constexpr std::string_view usage = "usage: send NAME LENGTH, then LENGTH bytes";

struct Announced {
  std::string name;
  std::uint64_t length = 0;
};

// Reads "send NAME LENGTH". A name in quotes is not read, so that the server and its hosts always count alike.
std::optional<Announced> announced(std::string_view line) {
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  constexpr std::string_view word = "send ";
  if (!line.starts_with(word)) return std::nullopt;
  line.remove_prefix(word.size());
  const std::size_t space = line.find(' ');
  if (space == 0 || space == line.npos) return std::nullopt;
  Announced out{std::string(line.substr(0, space)), 0};
  const std::string_view number = line.substr(space + 1);
  const auto read = std::from_chars(number.data(), number.data() + number.size(), out.length);
  if (read.ec != std::errc() || read.ptr != number.data() + number.size()) return std::nullopt;
  return out;
}

}  // namespace

std::optional<std::uint64_t> Imaging::bytes_after(Host host, std::string_view line) const {
  const HostState& h = hosts_.at(host);
  // The line may continue a text.
  if (h.open_lines > 0 || (h.bundling && !h.bundle.empty() && h.bundle.back().open)) return std::nullopt;
  const auto what = announced(line);
  return what ? std::optional(what->length) : std::nullopt;
}

bool Imaging::wants_bytes(Host host, std::string_view line) {
  HostState& h = hosts_.at(host);
  const auto what = announced(line);
  if (!what || h.bundling || !sent::may_come(what->name, what->length)) return false;
  if (promised_ + what->length > sent::all_together) return false;
  h.promised = what->length, promised_ += h.promised;
  return true;
}

void Imaging::receive(Host host, std::string bytes) {
  HostState& h = hosts_.at(host);
  promised_ -= std::exchange(h.promised, 0);
  h.sent = std::move(bytes);
}

Result<std::string> Imaging::send(HostState& h, const std::vector<std::string>& w, Nanos) {
  const auto bytes = std::exchange(h.sent, {});
  if (w.size() != 3) return fail(ErrorCode::syntax, "a name and a length are missing here", std::string(usage));
  if (!bytes) {
    const auto what = announced(fmt::format("send {} {}", w[1], w[2]));
    if (!what)
      return fail(ErrorCode::syntax, fmt::format("'{}' is not a number of bytes", w[2].substr(0, 60)),
                  std::string(usage));
    if (Status s = sent::may_come(what->name, what->length); !s) return s.error();
    return fail(ErrorCode::range, "hosts are sending too many bytes at the same time", "send it again later");
  }
  std::filesystem::path folder;
  if (!save_.empty()) {
    std::error_code ignored;
    const auto beside = std::filesystem::path(save_).parent_path();
    folder = std::filesystem::weakly_canonical(beside.empty() ? "." : beside, ignored) / sent::folder_name;
  }
  return asked([&](Film&) -> Result<std::string> {
    const auto full = sent::take(w[1], *bytes, folder);
    if (!full) return full.error();
    return fmt::format(",\"name\":{}", json_text(*full));
  });
}

}  // namespace betwixt

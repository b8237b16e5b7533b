// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/unpacking.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace betwixt {
namespace {

constexpr std::uint64_t mebibyte = 1 << 20, most_times = 100, always = 64 * mebibyte, most = 1024 * mebibyte;

thread_local Unpacking* innermost = nullptr;

}  // namespace

Unpacking::Unpacking(bool any_size) : any_size_(any_size), outer_(std::exchange(innermost, this)) {}
Unpacking::~Unpacking() { innermost = outer_; }

Status Unpacking::take(std::uint64_t bytes, const std::string& name) {
  const std::uint64_t allowed = std::min(most, always + most_times * std::min(read_, most));
  if (any_size_ || (bytes <= allowed && taken_ <= allowed - bytes)) return taken_ += bytes, Nothing{};
  return fail(ErrorCode::range,
              fmt::format("{} unpacks to {} MiB; the limit for a file of {} bytes is {} MiB", name,
                          (taken_ + std::min(bytes, most * 1024)) / mebibyte, read_, allowed / mebibyte),
              Hint(Permission::read_anywhere, "to read files of any size: --read-anywhere"));
}

Status unpack(std::uint64_t bytes, const std::string& name) {
  return innermost ? innermost->take(bytes, name) : Status(Nothing{});
}

Result<std::string> CountedFiles::read(const std::string& path) {
  auto bytes = files_.read(path);
  if (bytes) unpacking_.read(bytes->size());
  return bytes;
}

}  // namespace betwixt

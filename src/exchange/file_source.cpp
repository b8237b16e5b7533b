// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/file_source.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/files.h"

namespace betwixt {

bool LocalFiles::has(const std::string& path) {
  std::error_code ignored;
  return may_read_(path) && std::filesystem::is_regular_file(path, ignored);
}

Result<std::string> LocalFiles::read(const std::string& path) {
  if (!may_read_(path)) return fail(ErrorCode::file, fmt::format("reading {} is not allowed", path));
  return read_whole(path);
}

}  // namespace betwixt

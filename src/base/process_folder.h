// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string>

#include "base/files.h"

namespace betwixt {

// A folder that only this user can open. It goes when the process ends.
class ProcessFolder {
 public:
  // `use`: a part of its name.
  explicit ProcessFolder(std::string use) : use_(std::move(use)) {}
  ProcessFolder(const ProcessFolder&) = delete;
  ProcessFolder& operator=(const ProcessFolder&) = delete;
  ~ProcessFolder() {
    std::error_code ignored;
    if (!path_.empty() && owner_ == ::getpid()) std::filesystem::remove_all(path_, ignored);
  }
  // Makes it at the first call.
  Result<std::filesystem::path> get() {
    if (!path_.empty()) return path_;
    std::error_code ignored;
    std::filesystem::path temporary = std::filesystem::temp_directory_path(ignored);
    if (temporary.empty()) temporary = "/tmp";
    std::string pattern = (temporary / ("betwixt-" + use_ + "-XXXXXX")).string();
    if (!::mkdtemp(pattern.data())) return system_error(errno, "make a folder in", temporary.string());
    path_ = std::filesystem::weakly_canonical(pattern, ignored), owner_ = ::getpid();
    return path_;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::string use_;
  std::filesystem::path path_;
  pid_t owner_ = 0;
};

}  // namespace betwixt

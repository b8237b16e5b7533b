// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The source of files for the parsers of untrusted files, which open nothing themselves.
#pragma once

#include <functional>
#include <string>

#include "betwixt/result.h"

namespace betwixt {

// Returns whether a path may be read. Called before any file is opened, including buffers, textures and material
// libraries.
using MayRead = std::function<bool(const std::string& path)>;

class FileSource {
 public:
  virtual ~FileSource() = default;
  virtual bool has(const std::string& path) = 0;  // whether it is a plain file that may be read
  virtual Result<std::string> read(const std::string& path) = 0;
};

// The files of this machine that may be read.
class LocalFiles final : public FileSource {
 public:
  explicit LocalFiles(const MayRead& may_read) : may_read_(may_read) {}
  bool has(const std::string& path) override;
  Result<std::string> read(const std::string& path) override;

 private:
  const MayRead& may_read_;
};

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where those who read other people's files get these from: they open nothing themselves.
#pragma once

#include <functional>
#include <string>

#include "betwixt/result.h"

namespace betwixt {

// Asked before any file is opened (buffers, textures, material libraries too): may this path be read?
using MayRead = std::function<bool(const std::string& path)>;

class Shelf {
 public:
  virtual ~Shelf() = default;
  virtual bool has(const std::string& path) = 0;  // a plain file that may be read
  virtual Result<std::string> read(const std::string& path) = 0;
};

// What this machine has, as far as it may be read.
class MachineShelf final : public Shelf {
 public:
  explicit MachineShelf(const MayRead& may_read) : may_read_(may_read) {}
  bool has(const std::string& path) override;
  Result<std::string> read(const std::string& path) override;

 private:
  const MayRead& may_read_;
};

}  // namespace betwixt

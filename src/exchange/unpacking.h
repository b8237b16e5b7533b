// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How much a file of somebody else's may become in memory. A picture of 260 kB can have 268 million pixels, and a mesh
// of 400 bytes as many points: both would take gigabytes.
#pragma once

#include <cstdint>
#include <string>

#include "betwixt/result.h"
#include "exchange/shelf.h"

namespace betwixt {

// Counts what one file, and the files that it names, become. The innermost one of a thread is asked.
class Unpacking {
 public:
  explicit Unpacking(bool any_size);
  ~Unpacking();
  Unpacking(const Unpacking&) = delete;
  Unpacking& operator=(const Unpacking&) = delete;

  void read(std::uint64_t bytes) { read_ += bytes; }
  // Before so many bytes are allocated for what is called `name`. Errors: range (more than 100 times what was read and
  // 64 MiB, or more than 1 GiB in all).
  Status take(std::uint64_t bytes, const std::string& name);

 private:
  const bool any_size_;
  std::uint64_t read_ = 0, taken_ = 0;
  Unpacking* const outer_;
};

// Where nobody counts, everything fits.
Status unpack(std::uint64_t bytes, const std::string& name);

// A shelf whose files are counted as read.
class CountedShelf final : public Shelf {
 public:
  CountedShelf(Shelf& shelf, Unpacking& unpacking) : shelf_(shelf), unpacking_(unpacking) {}
  bool has(const std::string& path) override { return shelf_.has(path); }
  Result<std::string> read(const std::string& path) override;

 private:
  Shelf& shelf_;
  Unpacking& unpacking_;
};

}  // namespace betwixt

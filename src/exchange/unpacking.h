// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Limits the memory that an untrusted file may unpack to. A picture of 260 kB can have 268 million pixels, and a mesh
// of 400 bytes as many points: both would take gigabytes.
#pragma once

#include <cstdint>
#include <string>

#include "betwixt/result.h"
#include "exchange/file_source.h"

namespace betwixt {

// Counts the unpacked size of one file and of the files that it names. Each thread uses its innermost counter.
class Unpacking {
 public:
  explicit Unpacking(bool any_size);
  ~Unpacking();
  Unpacking(const Unpacking&) = delete;
  Unpacking& operator=(const Unpacking&) = delete;

  void read(std::uint64_t bytes) { read_ += bytes; }
  // Called before `bytes` are allocated for the file `name`. Errors: range (more than 100 times the bytes read plus 64
  // MiB, or more than 1 GiB in all).
  Status take(std::uint64_t bytes, const std::string& name);

 private:
  const bool any_size_;
  std::uint64_t read_ = 0, taken_ = 0;
  Unpacking* const outer_;
};

// Always succeeds if the thread has no counter.
Status unpack(std::uint64_t bytes, const std::string& name);

// A files that counts the files read from it.
class CountedFiles final : public FileSource {
 public:
  CountedFiles(FileSource& files, Unpacking& unpacking) : files_(files), unpacking_(unpacking) {}
  bool has(const std::string& path) override { return files_.has(path); }
  Result<std::string> read(const std::string& path) override;

 private:
  FileSource& files_;
  Unpacking& unpacking_;
};

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The place of a film until it is complete.
#pragma once

#include <optional>
#include <string>

#include "betwixt/result.h"
#include "film/output.h"

namespace betwixt {

// A hidden file or folder beside the film, which is removed with this. It is locked while its maker runs. An unlocked
// one is the remains of a killed process, and is removed by the next process that makes the same film on that machine.
class Partial {
 public:
  enum class What { file, folder };
  explicit Partial(const Output& place, What what);
  Partial(const Partial&) = delete;
  Partial& operator=(const Partial&) = delete;
  ~Partial();

  Status make();  // errors: machine
  const std::string& path() const { return path_; }
  Status written() const;          // of a file: flushed to the disk. Errors: machine
  std::uint64_t size() const;      // of a file
  void moved() { made_ = false; }  // it has its final name

 private:
  int try_to_make();
  void clear_left() const;

  const Output place_;
  const What what_;
  const std::string tail_;
  std::string path_;
  int lock_ = -1;
  bool made_ = false;
};

}  // namespace betwixt

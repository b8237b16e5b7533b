// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a film gathers until it is whole.
#pragma once

#include <optional>
#include <string>

#include "betwixt/result.h"
#include "film/output.h"

namespace betwixt {

// A hidden file or folder beside the film, which goes with this. It is locked while its maker lives: what stands there
// unlocked is what one who was killed has left, and is cleared away by the next who makes the same film on that
// machine.
class Partial {
 public:
  enum class What { file, folder };
  explicit Partial(const Output& place, What what);
  Partial(const Partial&) = delete;
  Partial& operator=(const Partial&) = delete;
  ~Partial();

  Status make();  // errors: machine
  const std::string& path() const { return path_; }
  Status written() const;          // a file's: on the disk. Errors: machine
  std::uint64_t size() const;      // a file's
  void moved() { made_ = false; }  // it has got its name

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

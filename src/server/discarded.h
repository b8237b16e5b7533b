// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Frees what takes long to free (a document of a million objects takes half a second) on a thread of its own, so that
// nobody waits for it.
#pragma once

#include <memory>

namespace betwixt {

class Discarded {
 public:
  Discarded();
  ~Discarded();  // does not wait until all is free
  Discarded(const Discarded&) = delete;
  Discarded& operator=(const Discarded&) = delete;

  // Frees it soon; at once where no thread is to be had.
  void take(std::shared_ptr<const void>);

 private:
  struct Shared;
  const std::shared_ptr<Shared> shared_;  // with the thread, which may outlive us
};

}  // namespace betwixt

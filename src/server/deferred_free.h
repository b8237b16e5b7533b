// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Frees large things on a thread of its own, so that no other thread waits for it: a document of a million objects
// takes half a second.
#pragma once

#include <memory>

namespace betwixt {

class DeferredFree {
 public:
  DeferredFree();
  ~DeferredFree();  // does not wait until everything is freed
  DeferredFree(const DeferredFree&) = delete;
  DeferredFree& operator=(const DeferredFree&) = delete;

  // Frees the object soon, or at once if no thread can be started.
  void take(std::shared_ptr<const void>);

 private:
  struct Shared;
  const std::shared_ptr<Shared> shared_;  // owned by the thread too, which may outlive this object
};

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Frees large things on a thread of its own, so that no other thread waits for it: a document of a million objects
// takes half a second. Then returns freed memory to the system, because each thread's heap keeps it otherwise. The
// thread starts with this object, at its maker's ordinary priority: a low-priority thread that holds a heap's lock
// would block all others.
#pragma once

#include <memory>

namespace betwixt {

class MemoryReturn {
 public:
  MemoryReturn();
  ~MemoryReturn();  // does not wait until everything is freed
  MemoryReturn(const MemoryReturn&) = delete;
  MemoryReturn& operator=(const MemoryReturn&) = delete;

  // Frees the object soon, or at once if no thread can be started.
  void take(std::shared_ptr<const void>);
  // Returns memory in a second, when the work that used it has freed it.
  void soon();

 private:
  struct Shared;
  const std::shared_ptr<Shared> shared_;  // owned by the thread too, which may outlive this object
};

}  // namespace betwixt

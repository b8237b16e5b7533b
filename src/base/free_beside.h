// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Frees something large on a thread of its own, because that may take long.
#pragma once

#include <system_error>
#include <thread>
#include <utility>

namespace betwixt {

template <class T>
void free_beside(T gone) {
  try {
    std::thread([held = std::move(gone)] {}).detach();
  } catch (const std::system_error&) {  // it has been freed here
  }
}

}  // namespace betwixt

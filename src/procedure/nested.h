// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The depth of procedures that read each other on this thread. It is limited because each level uses the thread's
// stack.
#pragma once

#include "betwixt/result.h"

namespace betwixt {

class Nested {
 public:
  static constexpr int most = 300;
  Nested() { ++depth; }
  ~Nested() { --depth; }
  Nested(const Nested&) = delete;
  Nested& operator=(const Nested&) = delete;
  static int level() { return depth; }  // 1: the outermost
  static bool too_deep() { return depth > most; }
  static Error error() { return fail(ErrorCode::range, "procedures call each other more than 300 levels deep"); }

 private:
  static inline thread_local int depth = 0;
};

}  // namespace betwixt

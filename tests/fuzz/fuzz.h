// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers of the fuzz targets.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

// Sanitizer options that save a tenth of the time: no stacks of allocations, and a small quarantine of freed memory.
// For the stacks of a found failure set ASAN_OPTIONS=malloc_context_size=30.
extern "C" const char* __asan_default_options() {
  return "malloc_context_size=0:quarantine_size_mb=8:thread_local_quarantine_size_kb=64";
}

namespace betwixt {

inline void insist(bool holds, const char* what, std::string_view where = {}) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n%.*s\n", what, static_cast<int>(where.size()), where.data());
  std::abort();
}

// Returns whether a text has a range to more than 999. To make or copy so many objects takes as long as ten thousand
// other texts.
inline bool makes_many(std::string_view text) {
  for (std::size_t at = text.find(".."); at != std::string_view::npos; at = text.find("..", at + 1)) {
    const std::size_t end = text.find_first_not_of("0123456789", at + 2);
    if (std::min(end, text.size()) - (at + 2) > 3) return true;
  }
  return false;
}

// Measures the time of one input. An input that takes too long is tested, but not added to the corpus.
class Slow {
 public:
  int verdict() const { return now() - begun_ > most ? -1 : 0; }

 private:
  static constexpr double most = 0.03;  // seconds of processor time
  static double now() {
    timespec t{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }
  const double begun_ = now();
};

}  // namespace betwixt

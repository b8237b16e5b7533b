// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Checks that a value has the same bits in any order of questions and from any thread.
#pragma once

#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "support/loaded_film.h"

namespace betwixt {

// Reads a target at times in seconds: each from a film of its own, and from four threads that ask one film, each in
// another order.
inline void expect_same_in_any_order(const std::string& text, std::string_view target,
                                     const std::vector<double>& seconds) {
  const auto read = [&](const LoadedFilm& s, double t) { return s.read(target, fmt::format("{}s", t)); };
  std::vector<Value> alone;
  for (const double t : seconds) alone.push_back(read(LoadedFilm(text), t));
  const LoadedFilm shared(text);
  std::vector<std::vector<Value>> found(4);
  std::vector<std::thread> threads;
  for (std::size_t n = 0; n < found.size(); ++n)
    threads.emplace_back([&, n] {
      for (std::size_t i = 0; i < seconds.size(); ++i)
        found[n].push_back(read(shared, seconds[(i + n) % seconds.size()]));
    });
  for (std::thread& t : threads) t.join();
  for (std::size_t n = 0; n < found.size(); ++n)
    for (std::size_t i = 0; i < seconds.size(); ++i)
      EXPECT_EQ(found[n][i], alone[(i + n) % seconds.size()]) << target << " at " << seconds[(i + n) % seconds.size()];
}

}  // namespace betwixt

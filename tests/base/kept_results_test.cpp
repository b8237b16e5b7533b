// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/kept_results.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

TEST(KeptResults, AreMadeOnceWhileTheyAreKept) {
  int made = 0;
  const auto get = [&](const char* what, const char* of) { return KeptResults::get(what, of, [&] { return ++made; }); };
  EXPECT_EQ(get("file", "a"), 1);
  EXPECT_EQ(get("file", "a"), 2) << "nobody keeps anything";
  KeptResults::Store store;
  {
    const KeptResults first(store);
    EXPECT_EQ(get("file", "a"), 3);
    EXPECT_EQ(get("file", "a"), 3);
    EXPECT_EQ(get("code", "a"), 4);
    EXPECT_EQ(get("file", "b"), 5);
    EXPECT_ANY_THROW(KeptResults::get("file", "c", []() -> int { throw 1; }));
    KeptResults::Store inner;
    {
      const KeptResults second(inner);
      EXPECT_EQ(get("file", "a"), 6);
    }
    EXPECT_EQ(get("file", "c"), 7) << "what failed is not kept";
  }
  EXPECT_EQ(get("file", "a"), 8);
  const KeptResults again(store);
  EXPECT_EQ(get("file", "a"), 3);
}

}  // namespace
}  // namespace betwixt

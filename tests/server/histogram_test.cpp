// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/histogram.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <vector>

namespace betwixt {
namespace {

TEST(Histogram, KnowsQuantilesToThreePercent) {
  EXPECT_TRUE(rc::check("beside the sorted numbers", [] {
    auto numbers = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::uint64_t>>(
        rc::gen::map(rc::gen::pair(rc::gen::arbitrary<std::uint64_t>(), rc::gen::inRange(0, 64)),
                     [](const auto& p) { return p.first >> p.second; })));
    Histogram h;
    for (const std::uint64_t n : numbers) h.add(n);
    std::sort(numbers.begin(), numbers.end());
    RC_ASSERT(h.largest() == numbers.back());
    for (const double part : {0.01, 0.5, 0.9, 0.99, 1.0}) {
      const auto rank = static_cast<std::size_t>(std::ceil(part * static_cast<double>(numbers.size())));
      const std::uint64_t exact = numbers[std::max<std::size_t>(rank, 1) - 1];
      const std::uint64_t said = h.quantile(part);
      RC_ASSERT(said >= exact);
      RC_ASSERT(static_cast<double>(said - exact) <= 0.032 * static_cast<double>(exact));
    }
  }));
  EXPECT_EQ(Histogram().quantile(0.5), 0u);
}

}  // namespace
}  // namespace betwixt

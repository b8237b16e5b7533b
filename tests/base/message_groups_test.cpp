// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/message_groups.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

TEST(MessageGroups, SaysTheSameOfManyThingsOnce) {
  MessageGroups all;
  for (int i = 1; i <= 17; ++i) EXPECT_EQ(all.add("b" + std::to_string(i) + ".radius: it errs", "2:18"), 0u);
  EXPECT_EQ(all.text(0), "b1.radius: it errs; likewise 16 others: b2.radius, b3.radius, b4.radius, b5.radius, …");
  EXPECT_EQ(all.add("c.radius: it errs", "3:18"), 1u);  // elsewhere
  EXPECT_EQ(all.add("b1.radius: it is lost", "2:18"), 2u);
  EXPECT_EQ(all.add("b1.radius: it errs", "2:18"), 0u);  // again
  EXPECT_EQ(all.text(1), "c.radius: it errs");
  EXPECT_EQ(all.size(), 3u);
  all.add("d.radius: it errs", "3:18");
  EXPECT_EQ(all.text(1), "c.radius: it errs; likewise d.radius");
}

TEST(MessageGroups, CodeMayBeAnotherForEach) {
  MessageGroups all;
  all.add("a1.size: the procedure \"local i = 1 return x.y\" gives no value: x is nil");
  EXPECT_EQ(all.add("a2.size: the procedure \"local i = 2 return x.y\" gives no value: x is nil"), 0u);
  EXPECT_EQ(all.add("a3.size: the procedure \"local i = 3 return x.y\" gives no value: y is nil"), 1u);
}

TEST(MessageGroups, WhatIsAboutNothingStandsAlone) {
  MessageGroups all;
  EXPECT_EQ(all.add("one frame takes too many steps"), 0u);
  EXPECT_EQ(all.add("the twerper 'a' gives no number"), 1u);
  EXPECT_EQ(all.add("one frame takes too many steps"), 0u);
  EXPECT_EQ(all.text(0), "one frame takes too many steps");
  EXPECT_EQ(all.add(""), 2u);
  EXPECT_EQ(all.text(2), "");
}

}  // namespace
}  // namespace betwixt

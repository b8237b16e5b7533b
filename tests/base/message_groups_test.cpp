// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/message_groups.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

Problem about(const std::string& subject, const std::string& message) { return {Problem::other, subject, {}, message}; }

TEST(MessageGroups, SaysTheSameOfManyThingsOnce) {
  MessageGroups all;
  for (int i = 1; i <= 17; ++i) EXPECT_EQ(all.add(about("b" + std::to_string(i) + ".radius", ": it errs"), "2:18"), 0u);
  EXPECT_EQ(all.text(0), "b1.radius: it errs; likewise 16 others: b2.radius, b3.radius, b4.radius, b5.radius, …");
  EXPECT_EQ(all.add(about("c.radius", ": it errs"), "3:18"), 1u);  // elsewhere
  EXPECT_EQ(all.add(about("b1.radius", ": it is lost"), "2:18"), 2u);
  EXPECT_EQ(all.add(about("b1.radius", ": it errs"), "2:18"), 0u);  // again
  EXPECT_EQ(all.text(1), "c.radius: it errs");
  EXPECT_EQ(all.size(), 3u);
  all.add(about("d.radius", ": it errs"), "3:18");
  EXPECT_EQ(all.text(1), "c.radius: it errs; likewise d.radius");
}

TEST(MessageGroups, CodeMayBeAnotherForEach) {
  MessageGroups all;
  const auto add = [&](Problem::What what, const char* subject, const char* name, const char* why, int line = 0) {
    return all.add({what, subject, name, why, "return x.y", line});
  };
  EXPECT_EQ(add(Problem::procedure, "a1.size", "local i = 1 return x.y", "x is nil"), 0u);
  EXPECT_EQ(add(Problem::procedure, "a2.size", "local i = 2 return x.y", "x is nil"), 0u);
  EXPECT_EQ(add(Problem::procedure, "a3.size", "local i = 3 return x.y", "y is nil"), 1u);
  EXPECT_EQ(add(Problem::procedure, "a4.size", "local i = 4 …", "x is nil", 2), 2u);
  EXPECT_EQ(add(Problem::filter, "a1.size", "smoother", "x is nil"), 3u);
  EXPECT_EQ(add(Problem::filter, "a2.size", "slower", "x is nil"), 4u);
  EXPECT_EQ(all.text(0),
            "a1.size: the procedure \"local i = 1 return x.y\" gives no value: x is nil; likewise a2.size");
  EXPECT_EQ(all.text(2), "a4.size: the procedure \"local i = 4 …\" gives no value: line 2: x is nil");
  EXPECT_EQ(all.text(3), "a1.size: the filter 'smoother' is left out: x is nil");
}

TEST(MessageGroups, WhatIsAboutNothingStandsAlone) {
  MessageGroups all;
  EXPECT_EQ(all.add(about("", "one frame takes too many steps")), 0u);
  EXPECT_EQ(all.add({Problem::twerper, {}, "a", "it is nil", "nil", 0}), 1u);
  EXPECT_EQ(all.add(about("", "one frame takes too many steps")), 0u);
  EXPECT_EQ(all.text(0), "one frame takes too many steps");
  EXPECT_EQ(all.text(1), "the twerper 'a' returned no number and is linear there: it is nil");
  EXPECT_EQ(all.add(about("", "")), 2u);
  EXPECT_EQ(all.text(2), "");
}

}  // namespace
}  // namespace betwixt

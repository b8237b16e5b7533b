// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/own_functions.h"

#include <gtest/gtest.h>

namespace betwixt {
namespace {

// Each is found at the place of its definition, however their names are ordered.
TEST(OwnFunctions, AreFoundByTheirNames) {
  const char* const names[] = {"heat", "a", "zeal", "heats", "hea", "mood"};
  OwnFunctions all;
  EXPECT_FALSE(all.find("heat"));
  for (const char* name : names) all.push_back({.name = name, .rest = 1.0});
  ASSERT_EQ(all.size(), 6u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all.find(names[i]), i);
    EXPECT_EQ(all[i].name, names[i]);
  }
  for (const char* name : {"", "he", "heat2", "zz", "A"}) EXPECT_FALSE(all.find(name)) << name;
  OwnFunctions other = all;
  EXPECT_TRUE(other == all);
  other.set_default(2, 3.0);
  EXPECT_FALSE(other == all);
  EXPECT_EQ(other.find("zeal"), 2u);
}

}  // namespace
}  // namespace betwixt

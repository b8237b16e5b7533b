// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/fonts.h"

#include <gtest/gtest.h>

#include "exchange/geometry.h"
#include "exchange/some_shapes.h"
#include "scene/topology.h"

namespace betwixt {
namespace {

TEST(Fonts, MissingOnesHaveANearMiss) {
  EXPECT_TRUE(find_font("DejaVu Sans"));
  EXPECT_TRUE(find_font("dejavu sans"));
  const auto missing = find_font("DejaVu Sons");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::name);
  EXPECT_EQ(missing.error().message, "this machine has no font called \"DejaVu Sons\"");
  EXPECT_EQ(missing.error().hint, "did you mean \"DejaVu Sans\"?");
  EXPECT_FALSE(text_outline("x", "No Such Font At All").contours.empty()) << "another one stands in";
}

TEST(Fonts, ContoursBelongToLetters) {
  const Outline outline = text_outline("ai b\ne\u0301:", "DejaVu Sans");
  std::vector<std::pair<std::string, std::size_t>> got;
  for (const auto& letter : outline.letters) got.emplace_back(letter.text, letter.first);
  // An a, a b and an e have a hole each, an i has a dot, and an accent goes with its letter.
  EXPECT_EQ(got, (decltype(got){{"a", 0}, {"i", 2}, {"b", 4}, {"e\u0301", 6}, {":", 9}}));
  EXPECT_EQ(outline.contours.size(), 11U);
  EXPECT_TRUE(text_outline(" \n ", "DejaVu Sans").letters.empty());
}

}  // namespace
}  // namespace betwixt

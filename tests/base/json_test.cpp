// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

namespace betwixt {
namespace {

const std::string hostile = "a\"\\\x1b]0;x\x07\n\t\x7f é \u009b2J \u202e\u2066 \u2028 中";

TEST(Json, TextsAreTheSameOnceTheyAreRead) {
  EXPECT_EQ(nlohmann::json::parse(json_text(hostile)).get<std::string>(), hostile);
  EXPECT_EQ(nlohmann::json::parse(json_text("\xff")).get<std::string>(), "\uFFFD");
}

// Whoever shows an answer as it came shows nothing that a terminal obeys.
TEST(Json, HasNothingThatATerminalObeys) {
  const std::string text = json_text(hostile);
  for (const char c : text) EXPECT_TRUE(static_cast<unsigned char>(c) >= ' ' && c != 0x7f) << static_cast<int>(c);
  for (const char* raw : {"\u009b", "\u202e", "\u2066", "\u2028"}) EXPECT_EQ(text.find(raw), text.npos);
  EXPECT_NE(text.find("é"), text.npos);
  EXPECT_NE(text.find("中"), text.npos);
}

// Of words for a person, whoever reads the answer has nothing of it either.
TEST(Json, WordsStayVisible) {
  const auto words = nlohmann::json::parse(json_words("no '\x1b[2J\u202e'\nhere")).get<std::string>();
  EXPECT_EQ(words, "no '\\x1b[2J\\u{202e}'\nhere");
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace betwixt {
namespace {

// How the standard writes a code point.
std::string written(unsigned c) {
  const auto rest = [&](unsigned shift) { return static_cast<char>(0x80 | (c >> shift & 0x3F)); };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xC0 | c >> 6), rest(0)};
  if (c < 0x10000) return {static_cast<char>(0xE0 | c >> 12), rest(6), rest(0)};
  return {static_cast<char>(0xF0 | c >> 18), rest(12), rest(6), rest(0)};
}

TEST(Utf8, EveryCodePointIsACharacterButSurrogates) {
  for (unsigned c = 0; c < 0x110000; ++c) {
    const std::string s = written(c);
    const bool surrogate = c >= 0xD800 && c < 0xE000;
    ASSERT_EQ(character_length(s, 0), surrogate ? 0 : s.size()) << c;
    if (s.size() == 1) continue;
    ASSERT_EQ(character_length(s.substr(0, s.size() - 1), 0), 0U) << c << ", cut off";
  }
}

TEST(Utf8, NothingElseIs) {
  const auto too_long = [](unsigned c, std::size_t bytes) {  // with zeros in front
    std::string s(1, static_cast<char>((0xF00U >> bytes & 0xFF) | (bytes == 2 ? c >> 6 : 0)));
    for (std::size_t k = bytes - 1; k > 0; --k) s += static_cast<char>(0x80 | (c >> 6 * (k - 1) & 0x3F));
    return s;
  };
  for (const unsigned c : {0U, 0x2FU, 0x7FU}) EXPECT_EQ(character_length(too_long(c, 2), 0), 0U) << c;
  for (const unsigned c : {0U, 0x7FFU}) EXPECT_EQ(character_length(too_long(c, 3), 0), 0U) << c;
  for (const unsigned c : {0U, 0xFFFFU}) EXPECT_EQ(character_length(too_long(c, 4), 0), 0U) << c;
  for (const char* s : {"\x80", "\xbf", "\xc0\xaf", "\xc1\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xfe", "\xff",
                        "\xe2\x82X", "\xc3X"})
    EXPECT_EQ(character_length(s, 0), 0U) << s;
}

TEST(Utf8, CharactersAreCounted) {
  const std::string text = "aé€😀z";  // of 1, 2, 3, 4 and 1 bytes
  EXPECT_EQ(count_characters(text), 5U);
  EXPECT_EQ(count_characters(""), 0U);
  const std::size_t bytes[] = {0, 1, 3, 6, 10, 11, 11};
  for (std::size_t n = 0; n < std::size(bytes); ++n) EXPECT_EQ(first_characters(text, n).size(), bytes[n]) << n;
  EXPECT_EQ(character_length(text, 6), 4U);
}

// Every code point: what is shown has no control characters, and nothing is changed that may be seen.
TEST(Utf8, VisibleTextHasNothingHidden) {
  const auto utf8 = [](unsigned c) {
    std::string out;
    if (c < 0x80) return out += static_cast<char>(c);
    const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
    static constexpr unsigned leads[] = {0, 0xC0, 0xE0, 0xF0};
    out += static_cast<char>(leads[more] | c >> (6 * more));
    for (int k = more - 1; k >= 0; --k) out += static_cast<char>(0x80 | (c >> (6 * k) & 0x3F));
    return out;
  };
  int hidden = 0;
  for (unsigned c = 0; c < 0x110000; ++c) {
    const std::string text = utf8(c), out = visible(text);
    if (out == text) continue;
    ++hidden;
    EXPECT_TRUE(out.starts_with('\\')) << c;
    for (const char byte : out) EXPECT_TRUE(byte >= ' ' && byte < 127) << c;
  }
  // C0 and DEL, C1, marks of direction, lines and their embeddings, isolates, annotations, no characters; 2048
  // surrogates are no UTF-8.
  EXPECT_EQ(hidden, 33 + 32 + 1 + 2 + 7 + 10 + 3 + 2 + 2048);
  EXPECT_EQ(visible("a\tb\n\x1b[0m\xC2\x9B\xE2\x80\xAE\xFF ö"), "a\\x09b\\n\\x1b[0m\\u{9b}\\u{202e}\\xff ö");
  EXPECT_EQ(visible("a\tb", true), "a\tb");
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests which characters of one piece of code go where in another.
#include "exchange/code_match.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

namespace betwixt {
namespace {

// The characters of `from` without a partner, blanks left out.
std::string alone(const std::string& from, const std::string& to) {
  std::string out;
  const auto all = match_code(from, to, "python");
  for (std::size_t i = 0; i < from.size(); ++i)
    if (all[i] == no_partner && from[i] != ' ' && from[i] != '\n') out += from[i];
  return out;
}

TEST(CodeMatch, LinesThatStayGoToThemselves) {
  const std::string from = "a = 1\nb = 2\nc = 3", to = "a = 1\nnew = 0\n    b = 2\nc = 3";
  const auto all = match_code(from, to, "python");
  EXPECT_EQ(alone(from, to), "");
  EXPECT_EQ(all[0], 0U);
  EXPECT_EQ(all[6], to.find("b = 2"));  // its indentation is another one
  EXPECT_EQ(all[12], to.find("c = 3"));
}

TEST(CodeMatch, LinesThatMoveGoToTheirNewPlaces) {
  const std::string from = "first()\nsecond()\nthird()", to = "second()\nthird()\nfirst()";
  EXPECT_EQ(alone(from, to), "");
  EXPECT_EQ(match_code(from, to, "python")[0], to.find("first"));
}

TEST(CodeMatch, WordsOfChangedLinesGoToTheirTwins) {
  const std::string from = "total = price * count", to = "total = price * count * (1 + tax)";
  EXPECT_EQ(alone(from, to), "");
  EXPECT_EQ(alone("for item in items:\n    total += item", "total = sum(items)"), "foritemin:+item");
}

TEST(CodeMatch, ABracketDoesNotFlyAcrossTheBlock) {
  const std::string from = "f(x)\nkeep = 1", to = "y\nkeep = 1\ng(2)";
  const auto all = match_code(from, to, "python");
  EXPECT_EQ(all[from.find('(')], no_partner);
}

// For random edits: only equal characters are paired, no place is taken twice, and a line that both texts have once
// goes there as a whole.
TEST(CodeMatch, HoldsForRandomEdits) {
  std::mt19937 random(11);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const char* const words[] = {"a", "total", "(", ")", "+", "for", "in", "x1", ":", "\"s\"", "# no"};
  for (int round = 0; round < 400; ++round) {
    std::vector<std::string> lines;
    const auto line = [&] {
      std::string out(2 * below(3), ' ');
      for (std::size_t n = 1 + below(5); n-- > 0;) out += std::string(words[below(std::size(words))]) + " ";
      return out + std::to_string(random() % 100000);
    };
    for (std::size_t n = below(12); n-- > 0;) lines.push_back(line());
    auto other = lines;
    for (std::size_t n = below(4); n-- > 0 && !other.empty();) switch (below(3)) {
        case 0:
          other.erase(other.begin() + static_cast<std::ptrdiff_t>(below(other.size())));
          break;
        case 1:
          other.insert(other.begin() + static_cast<std::ptrdiff_t>(below(other.size() + 1)), line());
          break;
        default:
          std::swap(other[below(other.size())], other[below(other.size())]);
      }
    const auto text = [](const std::vector<std::string>& all) {
      std::string out;
      for (const std::string& l : all) (out += out.empty() ? "" : "\n") += l;
      return out;
    };
    const std::string from = text(lines), to = text(other);
    const auto all = match_code(from, to, "python");
    std::set<std::size_t> taken;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i] == no_partner) continue;
      ASSERT_LT(all[i], to.size());
      EXPECT_EQ(from[i], to[all[i]]);
      EXPECT_TRUE(taken.insert(all[i]).second);
    }
    for (const std::string& l : lines) {
      const std::string bare = l.substr(l.find_first_not_of(' '));
      if (from.find(bare) != from.rfind(bare) || to.find(bare) == to.npos || to.find(bare) != to.rfind(bare)) continue;
      for (std::size_t i = 0; i < bare.size(); ++i)
        if (bare[i] != ' ') EXPECT_EQ(all[from.find(bare) + i], to.find(bare) + i) << from << "\n---\n" << to;
    }
  }
}

}  // namespace
}  // namespace betwixt

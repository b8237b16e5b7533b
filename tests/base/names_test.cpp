// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "base/names.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <random>

namespace betwixt {
namespace {

std::vector<std::string> expanded(std::string_view s) {
  auto r = expand_braces(s);
  return r ? *r : std::vector<std::string>{"error: " + r.error().message};
}

TEST(Names, AreLettersDigitsAndSlashes) {
  for (const char* yes : {"a", "ball", "Ball2", "car/wheel", "a-b_c/d9", "x-", "a/2"}) EXPECT_TRUE(is_name(yes)) << yes;
  for (const char* no : {"", "2ball", "-a", "/a", "a/", "a//b", "a.b", "a b", "b\xc3\xa4r", "_a", "a*"})
    EXPECT_FALSE(is_name(no)) << no;
  EXPECT_TRUE(is_name(std::string(1000, 'a')));
  EXPECT_FALSE(is_name(std::string(1001, 'a')));
}

// shows: G2 G64
TEST(Braces, AreWrittenOutInOrder) {
  using V = std::vector<std::string>;
  EXPECT_EQ(expanded("ball"), V{"ball"});
  EXPECT_EQ(expanded("{left,right}-arm"), (V{"left-arm", "right-arm"}));
  EXPECT_EQ(expanded("b{1..3}"), (V{"b1", "b2", "b3"}));
  EXPECT_EQ(expanded("b{3..1}"), (V{"b3", "b2", "b1"}));
  EXPECT_EQ(expanded("b{-1..1}"), (V{"b-1", "b0", "b1"}));
  EXPECT_EQ(expanded("b{08..11}"), (V{"b08", "b09", "b10", "b11"}));
  EXPECT_EQ(expanded("b{7..7}"), V{"b7"});
  EXPECT_EQ(expanded("{a,b}{1..2}"), (V{"a1", "a2", "b1", "b2"}));
  EXPECT_EQ(expanded("{a,b{1..2},{c,d}e}"), (V{"a", "b1", "b2", "ce", "de"}));
  EXPECT_EQ(expanded("x{,y}"), (V{"x", "xy"}));
  EXPECT_EQ(expanded("x{}"), V{"x"});
  EXPECT_EQ(expanded("x{1..b}"), V{"x1..b"});
  EXPECT_EQ(expanded("ball{1..100}").size(), 100U);
}

TEST(Braces, ThatCannotBeWrittenOutAreErrors) {
  EXPECT_EQ(expanded("a{b"), std::vector<std::string>{"error: the brace in 'a{b' is not closed"});
  EXPECT_EQ(expanded("{1..2000000}"), std::vector<std::string>{"error: '{1..2000000}' makes more than 1000000 names"});
  EXPECT_EQ(expanded("{-9223372036854775808..9223372036854775807}")[0].substr(0, 5), "error");
  EXPECT_EQ(expanded("{9223372036854775807..-9223372036854775808}")[0].substr(0, 5), "error");
  EXPECT_EQ(expanded("{9223372036854775806..9223372036854775807}").size(), 2U);
  EXPECT_EQ(expanded("{1..2000}{1..2000}"), std::vector<std::string>{"error: the braces make more than 1000000 names"});
  const auto few = expand_braces("{1..11}", 10);
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().code, ErrorCode::range);
  // A pattern is matched against very many names; a plain name may be as long as it likes.
  EXPECT_TRUE(expand_braces(std::string(4000, '?')));
  const auto too_long = expand_braces("{a,b}" + std::string(4000, '?'));
  ASSERT_FALSE(too_long);
  EXPECT_EQ(too_long.error().code, ErrorCode::range);
  EXPECT_TRUE(expand_braces(std::string(5000, 'x')));
  // Neither long names a million times, nor a million zeros in front, fill the memory.
  EXPECT_EQ(expanded("{1..900000}" + std::string(10'000, 'x')),
            std::vector<std::string>{"error: the braces make names that are too long"});
  EXPECT_EQ(expanded("{" + std::string(100'000, '0') + "1..900000}"),
            std::vector<std::string>{"error: the braces make names that are too long"});
  std::string many;
  for (int i = 0; i < 200; ++i) many += "{a}";
  EXPECT_EQ(expanded(many), std::vector<std::string>{"error: a name with more than 100 braces"});
}

TEST(Patterns, CrossNeitherSlashNorDot) {
  EXPECT_TRUE(matches("wheel*", "wheel"));
  EXPECT_TRUE(matches("wheel*", "wheel12"));
  EXPECT_FALSE(matches("wheel*", "wheel/rim"));
  EXPECT_TRUE(matches("car/*", "car/wheel"));
  EXPECT_FALSE(matches("car/*", "car/wheel/rim"));
  EXPECT_TRUE(matches("*/*", "car/wheel"));
  EXPECT_FALSE(matches("*", "a.b"));
  EXPECT_FALSE(matches("a?b", "a/b"));
  EXPECT_FALSE(matches("a[!x]b", "a/b"));
  EXPECT_FALSE(matches("a[.-0]b", "a/b"));
  EXPECT_TRUE(matches("b[a-c1]ll", "ball"));
  EXPECT_TRUE(matches("b[a-c1]ll", "b1ll"));
  EXPECT_FALSE(matches("b[!a-c1]ll", "b1ll"));
  EXPECT_TRUE(matches("b[^a-c]ll", "bell"));
  EXPECT_TRUE(matches("[a-]", "-"));
  EXPECT_FALSE(matches("b[a", "ba"));
  EXPECT_TRUE(is_pattern("a[b]") && is_pattern("{a}") && is_pattern("?") && !is_pattern("a-b/c.d"));
}

// By trying everything: the definition.
bool brute(std::string_view p, std::string_view s) {
  if (p.empty()) return s.empty();
  const auto stop = [](char c) { return c == '/' || c == '.'; };
  if (p[0] == '*') {
    for (std::size_t n = 0;; ++n) {
      if (brute(p.substr(1), s.substr(n))) return true;
      if (n == s.size() || stop(s[n])) return false;
    }
  }
  if (s.empty()) return false;
  if (p[0] == '?') return !stop(s[0]) && brute(p.substr(1), s.substr(1));
  if (p.substr(0, 4) == "[ab]") return (s[0] == 'a' || s[0] == 'b') && brute(p.substr(4), s.substr(1));
  if (p.substr(0, 4) == "[!a]") return s[0] != 'a' && !stop(s[0]) && brute(p.substr(4), s.substr(1));
  return p[0] == s[0] && brute(p.substr(1), s.substr(1));
}

// shows: G64
TEST(Patterns, MatchAsTryingEverythingDoes) {
  const char* pieces[] = {"*", "*", "?", "a", "b", "/", ".", "[ab]", "[!a]"};
  std::mt19937 random(1);
  int both = 0;
  for (int i = 0; i < 50'000; ++i) {
    std::string p, s;
    for (auto n = random() % 7; n-- > 0;) p += pieces[random() % 9];
    for (auto n = random() % 7; n-- > 0;) s += "aab/."[random() % 5];
    both += brute(p, s);
    ASSERT_EQ(matches(p, s), brute(p, s)) << p << " " << s;
  }
  EXPECT_GT(both, 1000);  // not all of them misses
  // Where a matcher that tries everything would never come back.
  std::string stars, name(2000, 'a');
  for (int i = 0; i < 200; ++i) stars += "*a";
  EXPECT_TRUE(matches(stars, name));
  EXPECT_FALSE(matches(stars + "b", name));
}

TEST(NaturalOrder, ComparesRunsOfDigitsAsNumbers) {
  std::vector<std::string> v{"ball10", "ball2", "ball", "ball1", "a", "ball2b", "ball02", "car/w10", "car/w9"};
  std::sort(v.begin(), v.end(), natural_less);
  EXPECT_EQ(
      v, (std::vector<std::string>{"a", "ball", "ball1", "ball02", "ball2", "ball2b", "ball10", "car/w9", "car/w10"}));
  EXPECT_TRUE(natural_less("b99999999999999999999998", "b99999999999999999999999"));
}

TEST(NaturalOrder, IsAnOrder) {
  EXPECT_TRUE(rc::check("strict, total", [] {
    const auto word =
        rc::gen::resize(6, rc::gen::container<std::string>(rc::gen::element('0', '0', '1', '2', 'a', '-')));
    const auto a = *word, b = *word, c = *word;
    RC_ASSERT(!natural_less(a, a));
    RC_ASSERT((a == b) == (!natural_less(a, b) && !natural_less(b, a)));
    RC_ASSERT(!(natural_less(a, b) && natural_less(b, a)));
    if (natural_less(a, b) && natural_less(b, c)) RC_ASSERT(natural_less(a, c));
  }));
}

TEST(NearMisses, AreSuggested) {
  const std::vector<std::string_view> kinds{"sphere", "box", "cylinder", "plane"};
  EXPECT_EQ(did_you_mean("sphre", kinds).text, "did you mean 'sphere'?");
  EXPECT_EQ(did_you_mean("shpere", kinds).text, "did you mean 'sphere'?");
  EXPECT_EQ(did_you_mean("cilynder", kinds).text, "did you mean 'cylinder'?");
  EXPECT_EQ(did_you_mean("bx", kinds).text, "did you mean 'box'?");
  EXPECT_EQ(did_you_mean("bx", kinds).instead, "box");
  EXPECT_EQ(did_you_mean("torus", kinds).text, "");
  EXPECT_EQ(did_you_mean("", kinds).text, "");
  EXPECT_EQ(did_you_mean(std::string(65, 'a'), kinds).text, "");
}

TEST(UnknownNames, AreTheSubjectOfTheirError) {
  const Error one = unknown_name("object", std::string(100, 'a'), correction("ball"));
  EXPECT_EQ(one.code, ErrorCode::name);
  EXPECT_EQ(one.subject, std::string(100, 'a')) << "the message shows its beginning only";
  EXPECT_EQ(one.instead, "ball");
  EXPECT_LT(one.message.size(), one.subject.size());
  EXPECT_EQ(nothing_named("b*").code, ErrorCode::name);
  EXPECT_EQ(nothing_named("b*").subject, "b*");
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/code_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace betwixt {
namespace {

std::string free_in(std::string_view code) { return fmt::format("{}", fmt::join(free_names(code), " ")); }

TEST(CodeNames, AreThoseThatCodeDoesNotMake) {
  EXPECT_EQ(free_in("k * i + 2e3*n"), "k i n");
  EXPECT_EQ(free_in("a.b + c:d() .. e..f"), "a c e f");
  EXPECT_EQ(free_in("'k' .. \"i\\\"j\" .. [[l]] .. [=[ ]] m ]=] .. o -- p\n+ q --[[ r\ns ]] + u"), "o q u");
  EXPECT_EQ(free_in("local a, b = c, d return a + b + e"), "c d return e");
  EXPECT_EQ(free_in("for i = 1, n do s = s + i end"), "n do s end");
  EXPECT_EQ(free_in("for k, v in pairs(w) do f(k, v) end"), "in pairs w do f end");
  EXPECT_EQ(free_in("local function f(x, ...) return x + y end return f(z)"), "return y end z");
  EXPECT_EQ(free_in("function(u) return u * v end"), "return v end");
  EXPECT_EQ(free_in("({3, 4})[i]"), "i");
  EXPECT_EQ(free_in("'never closed i"), "");
  EXPECT_EQ(free_in(""), "");
}

TEST(CodeNames, ValuesStandForNamesInFormulas) {
  const auto number = [](double d) {
    Quantity q;
    q.value = d;
    return Let(q);
  };
  const Lets lets{{"a", number(-2)}, {"x", number(7)}, {"sin", number(7)}, {"word", Text(std::string("b'c"))}};
  EXPECT_EQ(with_values("a*sin(x)^a + b.a", &lets, {}), "(-2)*sin(x)^(-2) + b.a");
  EXPECT_EQ(with_values("(function() local a = 3 return a * x end)()", &lets, {}),
            "(function() local a = 3 return a * x end)()");
  EXPECT_EQ(with_values("value('a') + aa", &lets, {}), "value('a') + aa");
  EXPECT_EQ(with_values("a", &lets, {}), "(-2)");
  EXPECT_EQ(with_values("", &lets, {}), "");
  PatternPlace third;
  third.i = 3, third.n = 5;
  EXPECT_EQ(with_values("i * x / n + a.i", nullptr, third), "3 * x / 5 + a.i");
  EXPECT_EQ(with_values("i * a", &lets, third), "3 * (-2)");
}

TEST(CodeNames, TellALineThatSpeaksOfPlaces) {
  const auto speaks = [](std::string_view line) {
    return code_speaks_of_place(line.data(), line.data() + line.size());
  };
  EXPECT_TRUE(speaks("set b*.radius = \"i / n\""));
  EXPECT_TRUE(speaks("1f =\"i2\" linear"));
  EXPECT_TRUE(speaks("set b*.radius = \"\"\"local a = 2\nreturn a * i\"\"\""));
  EXPECT_FALSE(speaks("set b*.radius = \"t\"\nset c*.radius = \"i\""));
  EXPECT_FALSE(speaks("set b*.text \"i\""));
  EXPECT_FALSE(speaks("set b*.radius = \"value('i') + i5 + ii\""));
  EXPECT_FALSE(speaks("set b*.radius = \"i"));
  EXPECT_FALSE(speaks("\"i\""));
}

}  // namespace
}  // namespace betwixt

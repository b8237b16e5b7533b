// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares formulas with numbers computed by hand, and with the arithmetic of C and Lua.
#include "language/formula.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "procedure/routines.h"

namespace betwixt {
namespace {

struct Read {
  Quantity value;
  std::string error, hint, rest;
};
Read read_formula(std::string_view text, const Lets& lets = {}, PatternPlace place = {}) {
  Cursor c(text);
  c.lets = &lets, c.place = place;
  Read r;
  if (!formula(c, r.value)) r.error = c.error ? c.error->message : "?", r.hint = c.error ? c.error->hint : "";
  r.rest = std::string(c.at, c.end);
  return r;
}
double value_of(std::string_view text) {
  const Read r = read_formula(text);
  EXPECT_EQ(r.error, "") << text;
  EXPECT_EQ(r.rest, "") << text;
  return r.value.value;
}

TEST(Formula, OperatorsBindAsInMathematics) {
  const std::pair<const char*, double> table[] = {{"2*3", 6},
                                                  {"1+2*3", 7},
                                                  {"(1+2)*3", 9},
                                                  {"2^3^2", 512},
                                                  {"-2^2", -4},
                                                  {"2^-1", 0.5},
                                                  {"7//2", 3},
                                                  {"-7//2", -4},
                                                  {"7%3", 1},
                                                  {"-7%3", 2},
                                                  {"1-2-3", -4},
                                                  {"8/2/2", 2},
                                                  {"1 - 2", 1},
                                                  {"(1 - 2)", -1},
                                                  {"( 4 / 2 )*3", 6},
                                                  {"--3", 3},
                                                  {"1e2*1.5", 150},
                                                  {".5*4", 2},
                                                  {"min(3,1,2)", 1},
                                                  {"max(1 -2)", 1},
                                                  {"max( 1 - 2 , -3 )", -1},
                                                  {"sqrt(2)^2", 2},
                                                  {"floor(-1.5)", -2},
                                                  {"ceil(1.2)", 2},
                                                  {"round(2.5)", 3},
                                                  {"round(-2.5)", -2},
                                                  {"sign(-3)", -1},
                                                  {"sign(0)", 0},
                                                  {"mix(1,3,0.25)", 1.5},
                                                  {"clamp(5,0,2)", 2},
                                                  {"smoothstep(0,2,1)", 0.5},
                                                  {"abs(-3)", 3},
                                                  {"2*pi-tau", 0},
                                                  {"e", std::exp(1.0)},
                                                  {"sin(30deg)", 0.5},
                                                  {"cos(pi)", -1},
                                                  {"tan(45deg)", 1},
                                                  {"sin(1turn/4)", 1},
                                                  {"90deg/1turn", 0.25},
                                                  {"3m/30cm", 10},
                                                  {"2s/500ms", 4},
                                                  {"24f/12f", 2},
                                                  {"24f/1s", 1},
                                                  {"hash(3)", value_of("hash(3)")}};
  for (const auto& [text, want] : table) {
    const Read r = read_formula(text);
    EXPECT_EQ(r.error, "") << text;
    EXPECT_NEAR(r.value.value, want, 1e-14) << text;
    EXPECT_EQ(r.value.of, Quantity::Of::number) << text;
  }
  EXPECT_EQ(read_formula("1 -2").rest, " -2");  // two numbers
  EXPECT_EQ(read_formula("2..5").rest, "..5");
}

TEST(Formula, KeepsWhatItIsOf) {
  using Of = Quantity::Of;
  const std::tuple<const char*, Of, double, double> table[] = {
      {"2*45deg", Of::angle, 90, 0},    {"asin(1)", Of::angle, 90, 0},
      {"atan(1,1)", Of::angle, 45, 0},  {"0.5turn+90deg", Of::angle, 270, 0},
      {"2m+50cm", Of::length, 2.5, 0},  {"max(1m,120cm)", Of::length, 1.2, 0},
      {"1f+3*12f", Of::time, 0, 37},    {"2s+500ms", Of::time, 2.5, 0},
      {"12f-1s/2", Of::time, -0.5, 12}, {"30t*2", Of::time, 2, 0},
      {"abs(-3deg)", Of::angle, 3, 0},  {"7deg%4deg", Of::angle, 3, 0}};
  for (const auto& [text, of, value, frames] : table) {
    const Read r = read_formula(text);
    EXPECT_EQ(r.error, "") << text;
    EXPECT_EQ(r.value.of, of) << text;
    EXPECT_NEAR(r.value.value, value, 1e-12) << text;
    EXPECT_NEAR(r.value.frames, frames, 1e-12) << text;
  }
}

TEST(Formula, NamesAndPlaces) {
  const Lets lets{{"beat", Quantity{Quantity::Of::time, 0, 12, true}},
                  {"p", Vec3{1, 2, 3}},
                  {"warm", Color{1, 0, 0}},
                  {"big", Quantity{Quantity::Of::number, 7, 0, false}}};
  const PatternPlace place{3, 10, {2, 5}};
  const auto number = [&](std::string_view text) {
    const Read r = read_formula(text, lets, place);
    EXPECT_EQ(r.error, "") << text;
    return r.value.value + 100 * r.value.frames;
  };
  EXPECT_EQ(number("i*n"), 30);
  EXPECT_EQ(number("i1-i2"), -3);
  EXPECT_EQ(number("p.y*big"), 14);
  EXPECT_EQ(number("beat*2"), 2400);
  EXPECT_EQ(read_formula("beat..beat*2", lets).rest, "..beat*2");
}

TEST(Formula, EveryErrorInWords) {
  const Lets lets{{"p", Vec3{1, 2, 3}}, {"warm", Color{1, 0, 0}}, {"beat", Quantity{}}};
  const std::pair<const char*, const char*> table[] = {
      {"2f+3deg", "a time and an angle cannot be added"},
      {"2m-3", "a length and a number cannot be subtracted"},
      {"2f*3s", "a time cannot be multiplied by a time"},
      {"2/3s", "a number cannot be divided by a time"},
      {"2deg^2", "'^' needs plain numbers on both sides"},
      {"1/0", "this formula divides by zero"},
      {"1%0", "this formula divides by zero"},
      {"10^400", "the result of this formula is not finite"},
      {"sqrt(-1)", "the result of this formula is not finite"},
      {"1e308*10", "the result of this formula is not finite"},
      {"nosuch*2", "there is no number 'nosuch'"},
      {"bea*2", "there is no number 'bea'"},
      {"sinn(2)", "there is no function 'sinn' in formulas"},
      {"sin()", "sin takes 1 number, not 0"},
      {"sin(1,2)", "sin takes 1 number, not 2"},
      {"hash(1,2,3,4)", "hash takes 1 to 3 numbers, not 4"},
      {"sin(2f)", "sin takes an angle, not a time"},
      {"floor(2deg)", "floor takes plain numbers, not an angle"},
      {"max(2deg,1)", "max takes numbers of one kind, not a number and an angle"},
      {"mix(1m,2m,1m)", "mix takes plain numbers, not a length"},
      {"3km*2", "'km' is not a unit"},
      {"p*2", "'p' is a vector, not a number"},
      {"warm*2", "'warm' is a colour, not a number"},
      {"i1*2", "the pattern has no first range for i1 to count"},
      {"(1+2", "a bracket is not closed before the text ends"},
      {"(1 -2)", "a closing bracket ')' is missing before '-2'"}};
  for (const auto& [text, words] : table) EXPECT_EQ(read_formula(text, lets).error, words) << text;
  EXPECT_EQ(read_formula("bea*2", lets).hint, "did you mean 'beat'?");
  for (const std::string& deep : {std::string(100'000, '(') + "1", std::string(100'000, '-') + "1"}) {
    EXPECT_EQ(read_formula(deep).error, "a formula can be at most 100 brackets deep");
  }
  std::string powers = "1";
  for (int i = 0; i < 100'000; ++i) powers += "^1";
  EXPECT_EQ(read_formula(powers).error, "a formula can be at most 100 brackets deep");
  std::string sums = "0";
  for (int i = 0; i < 100'000; ++i) sums += "+1";
  EXPECT_EQ(value_of(sums), 100'000);
}

// Random formulas mean what the same text means in Lua.
TEST(Formula, AgreesWithCode) {
  std::mt19937 random(7);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const std::function<std::string(int)> any = [&](int depth) -> std::string {
    if (depth == 0 || pick(4) == 0)
      return fmt::format("{}", (pick(2000) - 1000) / 100.0 == 0 ? 0.5 : std::abs(pick(2000) - 1000) / 100.0);
    static constexpr const char* unary[] = {"sin", "cos", "abs", "floor", "ceil", "round", "sign", "hash", "noise"};
    static constexpr const char* binary[] = {"min", "max", "atan"};
    static constexpr const char* operators[] = {"+", "-", "*", "/", "//", "%"};
    switch (pick(5)) {
      case 0:
        return fmt::format("{}({})", unary[pick(9)], any(depth - 1));
      case 1:
        return fmt::format("{}({},{})", binary[pick(2)], any(depth - 1), any(depth - 1));
      case 2:
        return fmt::format("mix({},{},{})", any(depth - 1), any(depth - 1), any(depth - 1));
      case 3:
        return fmt::format("-({})", any(depth - 1));
      default:
        return fmt::format("({}){}({})", any(depth - 1), operators[pick(6)], any(depth - 1));
    }
  };
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string text = any(4);
    const Read r = read_formula(text);
    const auto other = betwixt::value(text);
    if (!r.error.empty() || !other) continue;
    ++compared;
    const double* n = std::get_if<double>(&*other);
    ASSERT_TRUE(n) << text;
    EXPECT_NEAR(r.value.value, *n, 1e-9 * (1 + std::abs(*n))) << text;
  }
  EXPECT_GT(compared, 2000);
}

TEST(Formula, IsWrittenSoThatItReadsBackTheSame) {
  for (const char* text : {"12f", "0.1s*3", "1f+0.1s", "2.5m", "37.5deg", "1/3", "1f-2s"}) {
    const Read first = read_formula(text), again = read_formula(write_quantity(first.value));
    EXPECT_EQ(again.error, "") << text;
    EXPECT_TRUE(again.value == first.value) << text << " " << write_quantity(first.value);
  }
}

}  // namespace
}  // namespace betwixt

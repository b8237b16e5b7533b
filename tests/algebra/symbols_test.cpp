// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "betwixt/symbols.h"

#include <gtest/gtest.h>

#include <random>

#include "algebra/precise.h"
#include "support/motions.h"

namespace betwixt {
namespace {

Symbols symbols_of(const Motion& motion) {
  auto symbols = in_symbols(motion);
  EXPECT_TRUE(symbols) << (symbols ? "" : symbols.error().message);
  return symbols ? *symbols : Symbols{};
}
// A row of the plane: the numbers of x, of y and beside them.
std::string row(const std::string& text, std::size_t r) {
  const Symbols s = symbols_of(parsed(text));
  return to_string(s.sums[4 * r], s) + " | " + to_string(s.sums[4 * r + 1], s) + " | " +
         to_string(s.sums[4 * r + 3], s);
}

// By hand; the source's section 4.3, with the slips of its second row put right.
TEST(Symbols, AreThoseOfTheSource) {
  EXPECT_EQ(row("R(1rad @ 1 4)", 0), "c | -s | (1 - c) x + s y");
  EXPECT_EQ(row("R(1rad @ 1 4)", 1), "s | c | -s x + (1 - c) y");
  EXPECT_EQ(row("T(5 3)", 0), "1 | 0 | u");
  EXPECT_EQ(row("T(0 3)", 0), "1 | 0 | 0");
  EXPECT_EQ(row("S(2 3 @ 5 2)", 0), "g | 0 | (1 - g) x");
  EXPECT_EQ(row("S(2 3 @ 5 2)", 1), "0 | h | (1 - h) y");
  EXPECT_EQ(row("S(2 @ 5 2)", 1), "0 | g | (1 - g) y");
  EXPECT_EQ(row("T(5 3) R(1rad @ 0 1)", 0), "c2 | -s2 | u1 + s2 y2");
  EXPECT_EQ(row("R(1rad) T(5 3)", 1), "s1 | c1 | s1 u2 + c1 v2");
  EXPECT_EQ(row("R(1rad) R(2rad)", 0), "c1 c2 - s1 s2 | -c1 s2 - s1 c2 | 0");
  EXPECT_EQ(row("", 1), "0 | 1 | 0");
}

TEST(Symbols, TurnAboutAnyAxis) {
  const Symbols x = symbols_of(parsed("R(1rad @ 0 0 0 axis x)")),
                back = symbols_of(parsed("R(1rad @ 0 0 axis 0 0 -2)"));
  EXPECT_EQ(to_string(x.sums[0], x), "1");
  EXPECT_EQ(to_string(x.sums[6], x), "-s");
  EXPECT_EQ(to_string(x.sums[9], x), "s");
  EXPECT_EQ(to_string(back.sums[1], back), "s");
  const Symbols any = symbols_of(parsed("R(1rad @ 0 0 0 axis 1 2 2)"));
  EXPECT_EQ(to_string(any.sums[0], any), "c - c l^2 + l^2");
  EXPECT_EQ(to_string(any.sums[1], any), "-c l m - s n + l m");
}

// Whatever the letters are at a time, the sums of them are the matrix of that time. The other route: products of
// quadruple precision.
TEST(Symbols, AreTheMatrixWithItsNumbersIn) {
  std::mt19937 random(11);
  double worst = 0;
  int written_out = 0;
  for (int round = 0; round < 600; ++round) {
    const Motion motion = random_motion(random, 1 + round % 4, round % 2 == 1);
    const auto symbols = in_symbols(motion);
    if (!symbols) continue;
    ++written_out;
    const std::int64_t k = static_cast<std::int64_t>(random() % 41) - 10, steps = 20;
    const std::vector<double> letters =
        values_of(*symbols, motion, static_cast<double>(k) / static_cast<double>(steps));
    for (const Vec3 p : {Vec3{}, Vec3{1, 0, 0}, Vec3{-0.5, 2, 1}, Vec3{3.25, -1.75, -2}}) {
      const precise::Point q = precise::moved(motion, k, steps, p);
      const double size = 1 + std::abs(q.at(0)) + std::abs(q.at(1)) + std::abs(q.at(2));
      for (int c = 0; c < 3; ++c) {
        const auto number = [&](int column) {
          return value_of(symbols->sums[static_cast<std::size_t>(4 * c + column)], letters);
        };
        const double is = number(0) * p.x + number(1) * p.y + number(2) * p.z + number(3);
        worst = std::max(worst, std::abs(is - q.at(c)) / (size * q.largest));
      }
    }
  }
  EXPECT_GT(written_out, 450);
  EXPECT_LE(worst, 1e-12);
}

TEST(Symbols, SayWhatTheyStandFor) {
  const auto meaning = [](const std::string& text) {
    const Motion motion = parsed(text);
    std::string all;
    for (const Symbol& letter : symbols_of(motion).letters)
      all += (all.empty() ? "" : ", ") + letter.name + " = " + meaning_of(letter, motion);
    return all;
  };
  EXPECT_EQ(meaning("T(5 0 -3)"), "u = 5 t, w = -3 t");
  EXPECT_EQ(meaning("R(90deg @ 1 4)"), "c = cos(90deg t), s = sin(90deg t), x = 1, y = 4");
  EXPECT_EQ(meaning("R(-1turn) S(2 0.5 @ 3 0)"),
            "c1 = cos(-1turn t), s1 = sin(-1turn t), g2 = 2^t, h2 = 0.5^t, x2 = 3");
  EXPECT_EQ(meaning("S(0.5 3 linear)"), "g = 1 - 0.5 t, h = 1 + 2 t");
  EXPECT_EQ(meaning("R(1rad axis 0 3 4)"), "c = cos(1rad t), s = sin(1rad t), m = 0.6, n = 0.8");
}

TEST(Symbols, AreNotWrittenOutWithoutEnd) {
  Motion arms;
  for (int i = 0; i < 12; ++i) arms.factors.push_back(rotate_by(1, {1.0 + i, 2, 0}));
  const auto symbols = in_symbols(arms);
  ASSERT_FALSE(symbols);
  EXPECT_EQ(symbols.error().message, "an element of this matrix has more than 64 terms");
}

}  // namespace
}  // namespace betwixt

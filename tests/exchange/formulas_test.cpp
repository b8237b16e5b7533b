// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the setter of formulas against TeX's own numbers, and how it says what is wrong.
#include "exchange/formulas.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "base/child.h"
#include "exchange/tex.h"
#include "exchange/typefaces.h"

namespace betwixt {
namespace {

// The measures of Computer Modern at 10pt (The TeXbook, appendix G; cmsy10.tfm, cmex10.tfm), in em.
constexpr double axis = 0.25, bar = 0.04, numerator_up = 0.676508, denominator_down = 0.685951;
constexpr double beside_fraction = 0.12, width_of_a = 0.528589, script_size = 0.7;
constexpr double within = 0.002;  // em: the font is not the same to the last digit, and curves are flattened

Outline set(const std::string& formula) {
  const auto made = set_formula_text(formula);
  EXPECT_TRUE(made) << formula << ": " << (made ? "" : made.error().message);
  return made ? **made : Outline{};
}

struct Span {
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
  double width() const { return right - left; }
  double height() const { return top - bottom; }
  double middle() const { return (left + right) / 2; }
};
Span span_of(const Outline& o, std::size_t first, std::size_t end) {
  Span s;
  for (std::size_t i = first; i < end; ++i)
    for (const Vec3 p : o.contours[i])
      s = {std::min(s.left, p.x), std::max(s.right, p.x), std::min(s.bottom, p.y), std::max(s.top, p.y)};
  return s;
}
Span letter(const Outline& o, std::size_t i) {
  return span_of(o, o.letters[i].first, i + 1 < o.letters.size() ? o.letters[i + 1].first : o.contours.size());
}
Span whole(const Outline& o) { return span_of(o, 0, o.contours.size()); }
std::string wrong(const std::string& formula, std::size_t at, std::size_t length = 1) {
  const auto made = set_formula_text(formula);
  if (made) return "no error";
  EXPECT_EQ(made.error().place.column, static_cast<int>(at) + 1) << formula;
  EXPECT_EQ(made.error().place.length, static_cast<int>(length)) << formula;
  return made.error().message + (made.error().hint.empty() ? "" : " (" + made.error().hint + ")");
}

class Formulas : public testing::Test {
 protected:
  void SetUp() override {
    if (!find_font(std::string(formula_font_name))) GTEST_SKIP() << "no font for formulas";
  }
};

TEST_F(Formulas, AFractionIsWhereTeXPutsIt) {
  const Outline o = set("\\frac{a}{b}");
  ASSERT_EQ(o.letters.size(), 3U);
  const Span over = letter(o, 0), line = letter(o, 1), under = letter(o, 2);
  EXPECT_NEAR(line.bottom, axis - bar / 2, 1e-9);
  EXPECT_NEAR(line.top, axis + bar / 2, 1e-9);
  EXPECT_NEAR(line.left, beside_fraction, 1e-9);
  EXPECT_NEAR(line.width(), width_of_a, within);
  const Span a = whole(set("a")), b = whole(set("b"));
  EXPECT_NEAR(over.bottom - a.bottom, numerator_up, within);
  EXPECT_NEAR(under.bottom - b.bottom, -denominator_down, within);
}

// The shifts sup2 and sub2 of cmsy10; the font has only these.
TEST_F(Formulas, ScriptsAreSmallAndWhereTeXPutsThem) {
  const Outline o = set("a^a_a");
  ASSERT_EQ(o.letters.size(), 3U);
  const Span base = letter(o, 0), up = letter(o, 1), down = letter(o, 2);
  EXPECT_NEAR(up.height() / base.height(), script_size, 0.01);
  EXPECT_NEAR(up.left, down.left, within);
  const Span alone = letter(set("a^a"), 1);
  EXPECT_NEAR(alone.bottom - script_size * base.bottom, 0.362892, within);
  const Span lower = letter(set("a_a"), 1);
  EXPECT_NEAR(lower.bottom - script_size * base.bottom, -0.247217, within);
  const Span twice = letter(set("a^{a^a}"), 2);
  EXPECT_NEAR(twice.height() / base.height(), 0.5, 0.01);
}

TEST_F(Formulas, LimitsAreCentred) {
  const Outline o = set("\\sum_{0}^{0}");
  ASSERT_EQ(o.letters.size(), 3U);
  const Span sum = letter(o, 0), up = letter(o, 1), down = letter(o, 2);
  EXPECT_NEAR(up.middle(), sum.middle(), 0.01);
  EXPECT_NEAR(down.middle(), sum.middle(), 0.01);
  EXPECT_GT(up.bottom, sum.top);
  EXPECT_LT(down.top, sum.bottom);
  EXPECT_NEAR((sum.top + sum.bottom) / 2, axis, within);
  const Outline beside = set("\\sum\\nolimits_{0}^{0}");
  EXPECT_GT(letter(beside, 1).left, letter(beside, 0).right - 0.05);
  const Outline integral = set("\\int_0^1");
  EXPECT_GT(letter(integral, 1).left, letter(integral, 2).left) << "the upper limit leans over";
}

// Thin, medium and thick spaces are 3, 4 and 5 eighteenths of an em.
TEST_F(Formulas, SpacesFollowFromTheKindsOfSigns) {
  const auto between = [](const std::string& formula) {
    const Outline o = set(formula);
    return letter(o, 1).left - letter(o, 0).right;
  };
  const double close = between("a{+}b");
  EXPECT_NEAR(between("a+b") - close, 4.0 / 18, 1e-6);
  EXPECT_NEAR(between("a\\mathrel+b") - close, 5.0 / 18, 1e-6);
  EXPECT_NEAR(between("a\\,{+}b") - close, 3.0 / 18, 1e-6);
  EXPECT_NEAR(between("a\\mathpunct+b") - close, 0, 1e-6);
  EXPECT_NEAR(letter(set("-b"), 1).left, letter(set("{-}b"), 1).left, 1e-9) << "a sign before a number has no space";
  EXPECT_NEAR(letter(set("(-b"), 2).left, letter(set("({-}b"), 2).left, 1e-9);
  const Outline script = set("x^{a+b}"), tight = set("x^{a{+}b}");
  EXPECT_NEAR(whole(script).width(), whole(tight).width(), 1e-9) << "in scripts there is no medium space";
}

TEST_F(Formulas, DelimitersAndRootsGrow) {
  double before = 0;
  for (const char* inside :
       {"x", "\\frac{a}{b}", "\\frac{a}{\\frac{b}{c}}", "\\begin{matrix}a\\\\b\\\\c\\\\d\\\\e\\end{matrix}"}) {
    const Outline o = set(fmt::format("\\left({}\\right)", inside));
    const Span fence = letter(o, 0);
    EXPECT_GT(fence.height(), before) << inside;
    EXPECT_NEAR((fence.top + fence.bottom) / 2, axis, 0.01) << inside;
    EXPECT_GT(fence.height(), 0.85 * whole(set(inside)).height());
    before = fence.height();
    const Outline root = set(fmt::format("\\sqrt{{{}}}", inside));
    EXPECT_NEAR(letter(root, 0).top, letter(root, 1).top, 0.005) << "the sign meets the bar";
    EXPECT_NEAR(letter(root, 0).right, letter(root, 1).left, 0.03);
  }
}

TEST_F(Formulas, TablesAreAligned) {
  const Outline o = set("\\begin{aligned} a &= b \\\\ aaa &= c \\end{aligned}");
  ASSERT_EQ(o.letters.size(), 8U);
  EXPECT_NEAR(letter(o, 1).left, letter(o, 6).left, 1e-9);
  EXPECT_NEAR(letter(o, 0).right, letter(o, 5).right, 1e-9);
  const Outline same = set("a &= b \\\\ aaa &= c");
  ASSERT_EQ(same.letters.size(), 8U);
  EXPECT_NEAR(letter(same, 1).left, letter(same, 6).left, 1e-9);
  const Outline m = set("\\begin{pmatrix} 1 & 0 \\\\ 0 & 1 \\end{pmatrix}");
  ASSERT_EQ(m.letters.size(), 6U);
  EXPECT_NEAR(letter(m, 1).middle(), letter(m, 3).middle(), 0.01) << "but for the space about each";
  EXPECT_NEAR((letter(m, 0).top + letter(m, 0).bottom) / 2, axis, 0.01);
}

TEST_F(Formulas, TheyHaveMarkedParts) {
  const Outline o = set("{{a}}^2 + {{b}}^2 = \\sqrt{{{a}} + {{\\frac{1}{2}}}}");
  std::string parts;
  for (const Letter& l : o.letters) parts += l.part + ";";
  EXPECT_EQ(parts, "a;;;b;;;;;a#2;;\\frac{1}{2};\\frac{1}{2};\\frac{1}{2};");
  EXPECT_EQ(o.contours, set("a^2 + b^2 = \\sqrt{a + \\frac{1}{2}}").contours) << "the marks change no place";
  EXPECT_EQ(set("a {{=}} b").contours, set("a = b").contours);
  EXPECT_EQ(set("a {{+ b}}").contours, set("a + b").contours);
  EXPECT_EQ(set("\\frac{{{a}}}{{b}+c}").letters[0].part, "a");
}

TEST_F(Formulas, WhatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(wrong("1 + \\fracc{a}{b}", 4, 6),
            "the formula has an error: there is no command '\\fracc' (did you mean '\\frac'?)");
  EXPECT_EQ(wrong("a_{b", 2), "the formula has an error: '{' is never closed");
  EXPECT_EQ(wrong("a}b", 1), "the formula has an error: this } closes nothing (write \\} for a brace)");
  EXPECT_EQ(wrong("x^2^3", 3),
            "the formula has an error: this is a second superscript (put what belongs together into braces)");
  EXPECT_EQ(wrong("\\frac{a}", 0, 5), "the formula has an error: '\\frac' needs something behind it");
  EXPECT_EQ(wrong("\\left( x", 0, 5), "the formula has an error: this \\left has no \\right");
  EXPECT_EQ(wrong("x \\right)", 2, 6), "the formula has an error: '\\right' has no \\left before it");
  EXPECT_EQ(
      wrong("\\left x y", 6),
      "the formula has an error: '\\left' needs a delimiter behind it, not 'x' (such as ( [ \\{ | or . for none)");
  EXPECT_EQ(wrong("\\begin{pmatrx}a\\end{pmatrx}", 6),
            "the formula has an error: there is no environment 'pmatrx' (did you mean 'pmatrix'?)");
  EXPECT_EQ(wrong("\\begin{matrix}a\\end{pmatrix}", 15, 4),
            "the formula has an error: \\end{pmatrix} cannot end \\begin{matrix}");
  EXPECT_EQ(wrong("x # y", 2), "the formula has an error: '#' has no meaning in a formula (write \\# for the sign)");
  EXPECT_EQ(wrong("a \\text{日}", 2, 5), "the font of formulas has no sign U+65E5 here");
  EXPECT_EQ(wrong("a\\limits_b", 1, 7),
            "the formula has an error: '\\limits' can only follow a big operator or a function");
}

TEST_F(Formulas, WorkIsBounded) {
  std::string deep;
  for (int i = 0; i < 3000; ++i) deep += "\\sqrt{";
  EXPECT_EQ(set_formula_text(deep).error().code, ErrorCode::range);
  std::string chain;
  for (int i = 0; i < 3000; ++i) chain += "\\sqrt";
  EXPECT_FALSE(set_formula_text(chain));
  EXPECT_EQ(set_formula_text(std::string(20'001, 'x')).error().code, ErrorCode::range);
  EXPECT_TRUE(set_formula_text(std::string(20'000, 'x')));
}

// Random words of TeX: each is set or refused, and none takes long.
TEST_F(Formulas, AnyWordsAreSetOrRefused) {
  static constexpr const char* words[] = {"{",
                                          "}",
                                          "{{",
                                          "}}",
                                          "^",
                                          "_",
                                          "'",
                                          "&",
                                          "\\\\",
                                          "\\frac",
                                          "\\sqrt",
                                          "[",
                                          "]",
                                          "\\left",
                                          "\\right",
                                          "\\middle",
                                          "(",
                                          ")",
                                          "|",
                                          ".",
                                          "\\begin{matrix}",
                                          "\\end{matrix}",
                                          "\\begin{array}{c|c}",
                                          "\\end{array}",
                                          "\\begin{cases}",
                                          "\\end{cases}",
                                          "x",
                                          "1",
                                          "+",
                                          "=",
                                          "\\sum",
                                          "\\int",
                                          "\\limits",
                                          "\\hat",
                                          "\\vec",
                                          "\\overline",
                                          "\\overbrace",
                                          "\\underbrace",
                                          "\\text{ab}",
                                          "\\mathbb",
                                          "\\mathrm",
                                          "\\rm",
                                          "\\displaystyle",
                                          "\\scriptstyle",
                                          "\\over",
                                          "\\choose",
                                          "\\binom",
                                          "\\big",
                                          "\\Bigg",
                                          "\\xrightarrow",
                                          "\\overset",
                                          "\\cancel",
                                          "\\boxed",
                                          "\\phantom",
                                          "\\not",
                                          "\\pmod",
                                          "\\operatorname",
                                          "\\substack",
                                          "\\hline",
                                          "\\alpha",
                                          "\\,",
                                          "\\lim",
                                          "\\",
                                          "%",
                                          "\n",
                                          "~",
                                          "#",
                                          "\xff",
                                          "\u00e9",
                                          "\\quad",
                                          "\\mathop",
                                          "\\begin",
                                          "\\end",
                                          "\\sin",
                                          "\\to",
                                          "\\{",
                                          "\\langle"};
  std::mt19937 dice(20261128);
  const auto begun = std::chrono::steady_clock::now();
  int set_ones = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string formula;
    const auto count = 1 + dice() % 24;
    for (unsigned k = 0; k < count; ++k) formula += words[dice() % std::size(words)], formula += dice() % 3 ? "" : " ";
    const auto made = set_formula_text(formula);
    if (!made) {
      EXPECT_FALSE(made.error().message.empty()) << formula;
      EXPECT_LE(static_cast<std::size_t>(made.error().place.column), formula.size() + 1) << formula;
      continue;
    }
    ++set_ones;
    for (const Contour& c : (*made)->contours)
      for (const Vec3 p : c) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << formula;
  }
  EXPECT_GT(set_ones, 500);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(60));
}

TEST_F(Formulas, TheyAreAsWideAsLaTeXsOnes) {
  if (find_program("latex").empty() || find_program("dvisvgm").empty()) GTEST_SKIP() << "no TeX";
  for (const char* formula :
       {"a^2 + b^2 = c^2", "\\frac{-b \\pm \\sqrt{b^2 - 4ac}}{2a}",
        "\\sum_{n=1}^\\infty \\frac{1}{n^2} = \\frac{\\pi^2}{6}", "\\int_0^1 x^2\\,dx",
        "\\begin{pmatrix} 1 & 0 \\\\ 0 & 1 \\end{pmatrix}", "\\lim_{h \\to 0} \\frac{f(x+h) - f(x)}{h}",
        "\\left(x + \\frac{b}{2a}\\right)^2", "\\binom{n}{k} = \\frac{n!}{k!\\,(n-k)!}",
        "\\sin(a + b) = \\sin a \\cos b", "x \\in \\mathbb{R} \\Rightarrow x^2 \\ge 0"}) {
    const auto theirs = set_by_tex(formula);
    ASSERT_TRUE(theirs) << formula;
    const double ours = whole(set(formula)).width(), width = whole(**theirs).width();
    EXPECT_NEAR(ours / width, 1, 0.02) << formula;
    EXPECT_NEAR(whole(set(formula)).height() / whole(**theirs).height(), 1, 0.04) << formula;
    EXPECT_EQ(set(formula).letters.size(), (*theirs)->letters.size()) << formula;
  }
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests which signs of one formula go where in another, and what is drawn on the way.
#include "exchange/text_match.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "exchange/formulas.h"
#include "exchange/outline_morph.h"
#include "exchange/shapes.h"
#include "exchange/typefaces.h"

namespace betwixt {
namespace {

std::vector<MatchedSign> signs_of(const Outline& o) {
  std::vector<MatchedSign> out;
  for (const Letter& l : o.letters) out.push_back({l.text, l.part, o.contours[l.first].front()});
  return out;
}

Shape shape_of_formula(const std::string& tex, bool matches) {
  Shape s;
  s.kind = Kind::text;
  const auto made = set_formula_text(tex);
  EXPECT_TRUE(made) << tex << ": " << (made ? "" : made.error().message);
  if (made) s.formula = *made;
  s.matches = matches;
  return s;
}

// Twice the area that contours enclose.
double enclosed(const std::vector<Contour>& all) {
  double sum = 0;
  for (const Contour& c : all)
    for (std::size_t i = 0; i < c.size(); ++i) sum += cross(c[i], c[(i + 1) % c.size()]).z;
  return sum;
}

Box box_of(const std::vector<Contour>& all) {
  Box b;
  for (const Contour& c : all)
    for (const Vec3 p : c) b.add(p);
  return b;
}

struct Step {
  std::string before, after;
};
std::vector<Step> derivations() {
  std::ifstream in(SOURCE_DIR "/tests/exchange/data/derivations.txt");
  std::vector<Step> out;
  for (std::string line; std::getline(in, line);)
    if (const auto arrow = line.find(" => "); !line.starts_with('#') && arrow != line.npos)
      out.push_back({line.substr(0, arrow), line.substr(arrow + 4)});
  return out;
}

class TextMatch : public testing::Test {
 protected:
  void SetUp() override {
    if (!find_font(std::string(formula_font_name))) GTEST_SKIP() << "no font for formulas";
  }
};

// Of each sign, as many go to the other side as both sides have.
TEST_F(TextMatch, NoSignWithATwinFades) {
  const auto all = derivations();
  ASSERT_EQ(all.size(), 100U);
  for (const auto& [before, after] : all) {
    const Shape a = shape_of_formula(before, false), b = shape_of_formula(after, true);
    ASSERT_TRUE(a.formula && b.formula);
    std::map<std::string, int> here, there, paired;
    for (const Letter& l : a.formula->letters) ++here[l.text];
    for (const Letter& l : b.formula->letters) ++there[l.text];
    std::vector<bool> taken(b.formula->letters.size());
    for (const auto& [i, j] : match_signs(signs_of(*a.formula), signs_of(*b.formula))) {
      EXPECT_EQ(a.formula->letters[i].text, b.formula->letters[j].text) << before << " => " << after;
      EXPECT_FALSE(taken[j]);
      taken[j] = true;
      ++paired[a.formula->letters[i].text];
    }
    for (const auto& [sign, count] : here)
      EXPECT_EQ(paired[sign], std::min(count, there[sign])) << sign << " in " << before << " => " << after;
  }
}

// At both ends the picture is that of the plain formula.
TEST_F(TextMatch, TheEndsAreThePlainFormulas) {
  for (const auto& [before, after] : derivations()) {
    const Shape a = shape_of_formula(before, false), b = shape_of_formula(after, true);
    for (const double u : {0.0, 1.0}) {
      const Outline plain = outline_of(u == 0 ? a : b);
      const auto shown = contours_between(a, b, u).contours;
      EXPECT_NEAR(enclosed(shown), enclosed(plain.contours), 1e-6) << before << " => " << after << " at " << u;
      const Box is = box_of(shown), should = box_of(plain.contours);
      // A sign that comes or goes is a point in its middle.
      for (int k = 0; k < 2; ++k) {
        EXPECT_LE(is.low[k], should.low[k] + 1e-9);
        EXPECT_GE(is.high[k], should.high[k] - 1e-9);
      }
    }
    for (const double u : {0.25, 0.5, 0.75})
      for (const Contour& c : contours_between(a, b, u).contours)
        for (const Vec3 p : c) ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
  }
}

TEST_F(TextMatch, ABarStretchesAndAnExponentFollowsItsBase) {
  const Shape a = shape_of_formula("\\frac{1}{2}", false), b = shape_of_formula("\\frac{1}{2 + 3}", true);
  const Outline bar_a = outline_of(a), bar_b = outline_of(b);
  const auto width = [](const Contour& c) { return box_of({c}).high.x - box_of({c}).low.x; };
  const double from = width(bar_a.contours[bar_a.letters[1].first]), to = width(bar_b.contours[bar_b.letters[1].first]);
  const auto half = contours_between(a, b, 0.5).contours;
  EXPECT_TRUE(std::any_of(half.begin(), half.end(), [&](const Contour& c) {
    return c.size() == 4 && std::abs(width(c) - (from + to) / 2) < 1e-9;
  }));
  const Shape sum = shape_of_formula("{{a}}^2 + {{b}}^2 = {{c}}^2", false),
              difference = shape_of_formula("{{a}}^2 = {{c}}^2 - {{b}}^2", true);
  const auto pairs = match_signs(signs_of(*sum.formula), signs_of(*difference.formula));
  std::map<std::size_t, std::size_t> goes(pairs.begin(), pairs.end());
  EXPECT_EQ(goes[1], 1U) << "the exponent of a";
  EXPECT_EQ(goes[4], 7U) << "the exponent of b";
  EXPECT_EQ(goes[7], 4U) << "the exponent of c";
}

// Each sign is drawn once: by the object of its part, or by the formula.
TEST_F(TextMatch, PartsShareTheDrawing) {
  const std::string before = "{{a}}^2 + {{b}} = 1", after = "{{b}} = 1 - a^2 + {{c}}";
  Shape a = shape_of_formula(before, false), b = shape_of_formula(after, true);
  const double all = enclosed(contours_between(a, b, 0.5).contours);
  double sum = 0;
  const auto add = [&](const char* parts, bool only) {
    a.parts = b.parts = Text(std::string(parts)), a.only_parts = b.only_parts = only;
    sum += enclosed(contours_between(a, b, 0.5).contours);
  };
  add("a\nb\nc", false);
  for (const char* part : {"a", "b", "c"}) add(part, true);
  EXPECT_NEAR(sum, all, 1e-9);
}

TEST(MatchedTexts, WordsGlideToo) {
  Shape a, b;
  a.kind = b.kind = Kind::text;
  a.text = Text(std::string("red and blue")), b.text = Text(std::string("blue and red")), b.matches = true;
  const auto pairs = match_signs(signs_of(outline_of(a)), signs_of(outline_of(b)));
  EXPECT_EQ(pairs.size(), outline_of(a).letters.size());
  EXPECT_NEAR(enclosed(contours_between(a, b, 1).contours), enclosed(outline_of(b).contours), 1e-9);
}

}  // namespace
}  // namespace betwixt

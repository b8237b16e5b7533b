// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/fonts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

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

// Where text is set by itself and put there, its contours as a list that can be compared.
void add_moved(std::vector<Contour>& to, const Outline& outline, Vec3 by) {
  for (Contour c : outline.contours) {
    for (Vec3& p : c) p = p + by;
    to.push_back(std::move(c));
  }
}
void expect_alike(std::vector<Contour> is, std::vector<Contour> wanted, const std::string& about) {
  ASSERT_EQ(is.size(), wanted.size()) << about;
  const auto first = [](const Contour& a, const Contour& b) {
    const Vec3 p = a[0], q = b[0];
    return std::abs(p.y - q.y) > 1e-9 ? p.y < q.y : p.x < q.x;
  };
  std::sort(is.begin(), is.end(), first), std::sort(wanted.begin(), wanted.end(), first);
  for (std::size_t i = 0; i < is.size(); ++i) {
    ASSERT_EQ(is[i].size(), wanted[i].size()) << about;
    for (std::size_t k = 0; k < is[i].size(); ++k) EXPECT_LT(length(is[i][k] - wanted[i][k]), 1e-12) << about;
  }
}

// Kerned pairs, ligatures, accents, letters that join, several lines: the parts together are the whole.
TEST(Fonts, PartsStandWhereTheyStoodInTheWhole) {
  for (const std::string text : {"AVATAR To", "office affine", "two\nlines, of  words\n\n", "e\u0301a\u0308",
                                 "\u0633\u0644\u0627\u0645 \u0628\u0628\u0628", "a", "WA\tVA"})
    for (const Align align : {Align::left, Align::centre, Align::right})
      for (const SplitInto into : {SplitInto::letters, SplitInto::words, SplitInto::lines}) {
        const Letters letters{align, Weight::bold, false};
        std::vector<Contour> parts;
        for (const TextPart& part : text_parts(text, "DejaVu Sans", letters, into))
          add_moved(parts, text_outline(part.text, "DejaVu Sans", {Align::centre, Weight::bold, false}), part.at);
        expect_alike(parts, text_outline(text, "DejaVu Sans", letters).contours, text);
      }
}

TEST(Fonts, PartsAreWhatIsReadInItsOrder) {
  const auto parts = [](const std::string& text, SplitInto into) {
    std::vector<std::string> all;
    for (const TextPart& part : text_parts(text, "DejaVu Sans", {}, into)) all.push_back(part.text);
    return all;
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(parts("a  be\nc", SplitInto::letters), (Texts{"a", "b", "e", "c"}));
  EXPECT_EQ(parts(" a  be\nc d ", SplitInto::words), (Texts{"a", "be", "c", "d"}));
  EXPECT_EQ(parts(" a  be \n\nc", SplitInto::lines), (Texts{"a  be", "c"}));
  EXPECT_EQ(parts(" \n  ", SplitInto::lines), Texts{});
  // From right to left what is read first stands last.
  const auto right_to_left = text_parts("\u05d0\u05d1", "DejaVu Sans", {}, SplitInto::letters);
  ASSERT_EQ(right_to_left.size(), 2U);
  EXPECT_EQ(right_to_left[0].text, "\u05d0");
  EXPECT_GT(right_to_left[0].at.x, right_to_left[1].at.x);
}

// The way from one letter to the next is how wide a letter is: six of them reach six ways.
TEST(Fonts, LinesBeginEndOrHaveTheirMiddlesAtTheOrigin) {
  const auto left = [](const std::string& text, Align align) {
    double x = INFINITY;
    for (const Contour& c : text_outline(text, "DejaVu Sans", {align}).contours)
      for (const Vec3 p : c) x = std::min(x, p.x);
    return x;
  };
  const Outline two = text_outline("HH", "DejaVu Sans");
  ASSERT_EQ(two.contours.size(), 2U);
  const double advance = two.contours[1][0].x - two.contours[0][0].x, bearing = left("H", Align::left);
  EXPECT_GT(bearing, 0);
  EXPECT_LT(bearing, advance / 4);
  for (const std::string text : {"HHHHHH", "H\nHHHHHH", "HHHHHH\nHH"}) {
    EXPECT_NEAR(left(text, Align::left), bearing, 1e-9) << text;
    EXPECT_NEAR(left(text, Align::centre), bearing - 3 * advance, 1e-9) << text;
    EXPECT_NEAR(left(text, Align::right), bearing - 6 * advance, 1e-9) << text;
  }
}

TEST(Fonts, TypedLettersStandWhereTheyStandInTheWhole) {
  const std::string text = "AV To\ne\u0301i";
  const Outline whole = text_outline(text, "DejaVu Sans");
  std::size_t before = 0;
  for (std::uint32_t typed = 0; typed <= 10; ++typed) {
    const Outline some = text_outline(text, "DejaVu Sans", {.typed = typed});
    ASSERT_LE(some.contours.size(), whole.contours.size());
    EXPECT_GE(some.contours.size(), before);
    before = some.contours.size();
    for (std::size_t i = 0; i < some.contours.size(); ++i) EXPECT_EQ(some.contours[i], whole.contours[i]) << typed;
    // Five letters, an end of the line, a letter of two characters, one more; three of them draw nothing new.
    static constexpr std::array<std::size_t, 11> seen{0, 1, 2, 2, 3, 4, 4, 4, 5, 6, 6};
    EXPECT_EQ(some.letters.size(), seen[typed]) << typed;
  }
  EXPECT_EQ(before, whole.contours.size());
}

Extent reach(const Outline& o) {
  Extent all;
  for (const Contour& c : o.contours)
    for (const Vec3 p : c) all.add(p);
  return all;
}

// A wrapped text is the same text with line ends at the places of the breaks.
TEST(Fonts, LinesBreakBetweenWords) {
  const auto wrapped = [](const std::string& text, double wrap, Align align = Align::centre) {
    return text_outline(text, "DejaVu Sans", {.align = align, .wrap = wrap}).contours;
  };
  const auto alike = [&](const std::string& text, double wrap, const std::string& lines) {
    for (const Align align : {Align::left, Align::centre, Align::right})
      EXPECT_EQ(wrapped(text, wrap, align), wrapped(lines, 0, align)) << text << " at " << wrap;
  };
  const Extent five = reach(text_outline("HHHHH", "DejaVu Sans"));
  const double letter = (five.high.x - five.low.x) / 5;  // hardly narrower than an H
  alike("HH HH HH", 0, "HH HH HH");
  alike("HH HH HH", 20 * letter, "HH HH HH");
  alike("HH HH HH", 5.5 * letter, "HH HH\nHH");
  alike("HH HH HH", 2.5 * letter, "HH\nHH\nHH");
  alike("HH   HH\nH HHH H", 4.5 * letter, "HH\nHH\nH\nHHH\nH");
  alike("HHHHHHH HH", 3.5 * letter, "HHH\nHHH\nH\nHH");
  alike("H HHHHHHH", 3.5 * letter, "H\nHHH\nHHH\nH");
  alike("HHHH", 0.01 * letter, "H\nH\nH\nH");
  alike("\n\nH H", 1.5 * letter, "\n\nH\nH");
  // Accents and letters of several bytes stay whole.
  alike("e\u0301e\u0301e\u0301", 0.1, "e\u0301\ne\u0301\ne\u0301");
}

// No line is wider than asked, and the next word would not have fitted.
TEST(Fonts, LinesAreAsFullAsTheyCanBe) {
  std::mt19937 dice(5);
  for (int round = 0; round < 60; ++round) {
    std::string text;
    for (unsigned words = 1 + dice() % 30; words-- > 0;) {
      for (unsigned letters = 1 + dice() % 8; letters-- > 0;) text += static_cast<char>('a' + dice() % 26);
      text += ' ';
    }
    const double wrap = 6 + dice() % 10, bearings = 0.3;
    std::vector<std::string> lines;
    for (const TextPart& part : text_parts(text, "DejaVu Sans", {.wrap = wrap}, SplitInto::lines))
      lines.push_back(part.text);
    std::string all;
    const auto width = [](const std::string& line) {
      const Extent e = reach(text_outline(line, "DejaVu Sans"));
      return e.high.x - e.low.x;
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
      all += lines[i] + " ";
      EXPECT_LE(width(lines[i]), wrap) << lines[i];
      if (i + 1 < lines.size())
        EXPECT_GT(width(lines[i] + " " + lines[i + 1].substr(0, lines[i + 1].find(' '))), wrap - bearings) << lines[i];
    }
    EXPECT_EQ(all, text);
  }
}

TEST(Fonts, TextsHaveAnAnchor) {
  const auto rows = [](const std::string& text, Anchor anchor) {
    const Extent e = reach(text_outline(text, "DejaVu Sans", {.anchor = anchor}));
    return std::pair(e.low.y, e.high.y);
  };
  for (const std::string text : {"H", "H\nH", "H\nH\nH"}) {
    const auto [low, high] = rows(text, Anchor::baseline);
    EXPECT_NEAR(high, 0.729, 1e-3);  // DejaVu Sans has capitals of 1493 of 2048 units
    EXPECT_NEAR(rows(text, Anchor::top).second, 0, 2e-3);
    EXPECT_NEAR(rows(text, Anchor::bottom).first, 0, 2e-3);
    const auto [under, above] = rows(text, Anchor::middle);
    EXPECT_NEAR(under + above, 0, 2e-3);
    EXPECT_NEAR(above - under, high - low, 1e-9);
  }
}

double area(const Outline& o) {
  double sum = 0;
  for (const Contour& c : o.contours)
    for (std::size_t i = 0; i < c.size(); ++i) sum += cross(c[i], c[(i + 1) % c.size()]).z / 2;
  return sum;
}

TEST(Fonts, WeightsAreHeavierAndWhatIsMissingIsSaid) {
  EXPECT_GT(area(text_outline("HOx", "DejaVu Sans", {.weight = Weight::bold})),
            1.2 * area(text_outline("HOx", "DejaVu Sans")));
  EXPECT_TRUE(find_style({"DejaVu Sans", Weight::bold}));
  EXPECT_TRUE(find_style({"No Such Font At All", Weight::bold})) << "that was said already";
  const Status missing = find_style({"DejaVu Sans", Weight::black, true});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().message, "the font \"DejaVu Sans\" has no style \"black italic\" on this machine");
  EXPECT_NE(missing.error().hint.find("regular, bold"), std::string::npos) << missing.error().hint;
  // The nearest that there is stands in.
  EXPECT_EQ(font_file({"DejaVu Sans", Weight::black}).path, font_file({"DejaVu Sans", Weight::bold}).path);
  const Typeface italic{"DejaVu Sans", Weight::regular, true};
  EXPECT_EQ(static_cast<bool>(find_style(italic)), font_file(italic).path != font_file({"DejaVu Sans"}).path);
}

}  // namespace
}  // namespace betwixt

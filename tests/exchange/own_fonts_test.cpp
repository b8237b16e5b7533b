// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fonts that a film brings along as files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "base/files.h"
#include "exchange/files.h"
#include "exchange/font_face.h"
#include "exchange/fonts.h"

namespace betwixt {
namespace {

class OwnFonts : public Files {
 protected:
  static std::string usual() { return *read_whole(font_file({"DejaVu Sans"}).path); }
  FontName read(const std::string& bytes) const {
    const auto font = load_font(put("own.ttf", bytes));
    EXPECT_TRUE(font) << (font ? "" : font.error().message);
    return {"own.ttf", font ? *font : nullptr};
  }
};

// An own font is shaped in another process and an installed one in this, by the same rules.
TEST_F(OwnFonts, GiveWhatTheInstalledFontGives) {
  const FontName own = read(usual());
  for (const char* text : {"Fig", "office \ufb03", "two\nlines", "e\u0301a\u0308", "\u05d0\u05d1\u05d2", "\u0628\u0628",
                           "", "AVAW To.", "1 \u2192 2"})
    for (const Align align : {Align::left, Align::centre, Align::right}) {
      const Outline here = text_outline(text, "DejaVu Sans", {align}), there = text_outline(text, own, {align});
      EXPECT_EQ(here.contours, there.contours) << text;
      ASSERT_EQ(here.letters.size(), there.letters.size()) << text;
      for (std::size_t i = 0; i < here.letters.size(); ++i) EXPECT_EQ(here.letters[i].text, there.letters[i].text);
    }
  for (const auto into : {SplitInto::letters, SplitInto::words, SplitInto::lines}) {
    const auto here = text_parts("two words\nAV", "DejaVu Sans", {}, into),
               there = text_parts("two words\nAV", own, {}, into);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i)
      EXPECT_TRUE(here[i].text == there[i].text && here[i].at == there[i].at);
  }
}

TEST_F(OwnFonts, HaveOneStyle) {
  const FontName own = read(usual());
  EXPECT_EQ(text_outline("HO", own, {.weight = Weight::bold}).contours, text_outline("HO", own).contours);
}

TEST_F(OwnFonts, AreRefusedInWords) {
  const auto why = [&](const std::string& path) {
    const auto font = load_font(path);
    return font ? "" : font.error().message;
  };
  const std::string path = put("bad.ttf", "no font");
  EXPECT_EQ(why(path), path + ": the font is not a font with outlines");
  EXPECT_EQ(why(at("none.ttf")), "there is no file '" + at("none.ttf") + "'");
  EXPECT_EQ(why(put("large.ttf", std::string((32 << 20) + 1, 'x'))), at("large.ttf") + " has more than 32 MiB");
}

// Whatever a damaged font does, it does in another process.
TEST_F(OwnFonts, DoNoHarmIfTheyAreDamaged) {
  const std::string good = usual();
  std::mt19937 random(11);
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string bad = good;
    const std::size_t reach = i % 2 ? bad.size() : 4096;  // the tables' places stand at the beginning
    for (unsigned n = 1 + random() % 40; n > 0; --n) bad[random() % reach] = static_cast<char>(random());
    if (i % 5 == 0) bad.resize(random() % bad.size());
    const auto font = load_font(put(fmt::format("bad{}.ttf", i), bad));
    refused += !font;
    if (!font) continue;
    for (const Contour& c : text_outline("office\n\u0628\u0628 12", {"bad.ttf", *font}).contours)
      for (const Vec3& p : c) ASSERT_TRUE(std::abs(p.x) < 1e7 && std::abs(p.y) < 1e7);
  }
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace betwixt

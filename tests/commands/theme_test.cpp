// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests themes.
#include "scene/theme.h"

#include <cmath>

#include "scene/document.h"
#include "scene/functions.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

Color color_of(const LoadedFilm& s, const std::string& name) { return std::get<Color>(s.read(name + ".color", "1f")); }

// The contrast of two colours by WCAG 2.
double contrast(Color a, Color b) {
  const auto light = [](Color c) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  };
  const double x = light(a), y = light(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

TEST(Themes, CanBeRead) {
  for (const Theme& t : themes()) {
    EXPECT_GE(contrast(t.paper, t.ink), 7) << t.name;
    EXPECT_GE(contrast(t.paper, t.label), 4.5) << t.name;
    EXPECT_GE(contrast(t.panel, t.ink), 7) << t.name;
    for (const Color& c : t.palette) EXPECT_GE(contrast(t.paper, c), 2.5) << t.name;
    for (std::size_t i = 1; i < t.code.size(); ++i) EXPECT_GE(contrast(t.panel, t.code[i]), 2.7) << t.name << i;
  }
}

TEST(Themes, ColorWhatHasNoColor) {
  const LoadedFilm s(
      "create before circle\ntheme light\ncreate t text text=\"a\"\ncreate b{1..3} circle\ncreate r rectangle\n"
      "create own circle color=red\ncreate w line\ncreate again circle\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const Theme& t = *find_theme("light");
  EXPECT_EQ(s.loaded.document.scene().background, t.paper);
  EXPECT_EQ(color_of(s, "t"), t.ink);
  EXPECT_EQ(color_of(s, "w"), t.ink);
  EXPECT_EQ(color_of(s, "b1"), color_of(s, "b3"));
  EXPECT_NE(color_of(s, "b1"), color_of(s, "r"));
  EXPECT_NE(color_of(s, "r"), color_of(s, "again"));
  EXPECT_EQ(color_of(s, "own"), (Color{1, 0, 0}));
  EXPECT_EQ(s.loaded.document.scene().objects[0].find(fn::color), nullptr);
}

// Few words are listed, and many are not if one of them is near.
TEST(Materials, AWordThatIsNoneIsToldBriefly) {
  const auto hint_of = [](const char* line) {
    const Loaded l = load_text(line, "test.bx");
    return l.diagnostics.empty() ? std::pair<std::string, std::string>()
                                 : std::pair(l.diagnostics[0].what.message, std::string(l.diagnostics[0].what.hint));
  };
  EXPECT_EQ(hint_of("create b sphere material=gould\n"),
            (std::pair<std::string, std::string>("there is no material 'gould'", "did you mean 'gold'?")));
  const auto [message, hint] = hint_of("create b sphere material=qqqqqqqq\n");
  EXPECT_EQ(message, "there is no material 'qqqqqqqq'");
  EXPECT_TRUE(hint.starts_with("material is plastic, matte, metal, glow, gold, ")) << hint;
}

// Without a theme, what names and counts can be read on any even background, and code on its own panel.
TEST(Themes, TheBackgroundChoosesOne) {
  for (const std::string paper : {"white", "#f4f6f9", "#e8e0d0", "#202428", "black", "navy"}) {
    const LoadedFilm s(
        "background " + paper +
        "\ncreate c columns of=(1 2) keys=(\"a\" \"b\")\ncreate k code text=\"x = 1\" language=python\n");
    ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
    EXPECT_GE(contrast(*s.loaded.document.scene().background, color_of(s, "c/a/label")), 4.5) << paper;
    EXPECT_GE(contrast(*s.loaded.document.scene().background, color_of(s, "c/b/number")), 4.5) << paper;
    EXPECT_GE(contrast(color_of(s, "k/panel"), color_of(s, "k")), 4.5) << paper;
  }
  const LoadedFilm s("background white\nbackground transparent\ncreate c columns of=(1 2) keys=(\"a\" \"b\")\n");
  EXPECT_EQ(color_of(s, "c/a/label"), find_theme("dark")->label);
}

// Gold is gold under any theme.
TEST(Themes, LeaveMaterialsTheirColors) {
  const LoadedFilm s("theme dark\ncreate ball sphere material=gold\ncreate plain sphere material=metal\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  const auto& objects = s.loaded.document.scene().objects;
  EXPECT_EQ(objects[0].find(fn::color), nullptr);
  EXPECT_NE(objects[1].find(fn::color), nullptr);
}

TEST(Themes, NamesFollowTheTheme) {
  const LoadedFilm s(
      "theme dark\ntheme light\ntheme lake #102030\ncreate a circle color=lake\ncreate b circle color=leaf\n"
      "create c text text=\"x\" color=ink\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(color_of(s, "a").b, 0x30 / 255.0, 1e-12);
  EXPECT_EQ(color_of(s, "b"), find_theme("light")->palette[2]);
  EXPECT_EQ(color_of(s, "c"), find_theme("light")->ink);
}

TEST(Themes, AnAuthorsNameStays) {
  const LoadedFilm s("let lake = #010203\ntheme light\ncreate a circle color=lake\n");
  ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
  EXPECT_NEAR(color_of(s, "a").g, 2 / 255.0, 1e-12);
}

TEST(Themes, FilmsAreWrittenWithTheirTheme) {
  for (const char* text :
       {"create before circle\ntheme paper\ntheme accent red\nlet again lake = blue\ncreate a circle\ncreate ax axes\n"
        "create f plot on=ax of=\"x\"\nbackground black\n",
        "theme light\nbackground none\ncreate c code language=c text=\"int a;\"\n",
        "theme dark\nbackground transparent\n"}) {
    const LoadedFilm s(text);
    ASSERT_TRUE(s.loaded.diagnostics.empty()) << said(s.loaded.diagnostics);
    const std::string out = write(s.loaded.document);
    const auto again = load_text(out, "again.bx");
    EXPECT_TRUE(again.diagnostics.empty()) << said(again.diagnostics) << out;
    EXPECT_TRUE(again.document == s.loaded.document) << out;
  }
}

TEST(Themes, ErrorsHaveTheirPlaces) {
  for (const auto& [line, code, column] : {std::tuple{"theme bright", ErrorCode::type, 7},
                                           {"theme", ErrorCode::syntax, 6},
                                           {"theme ink", ErrorCode::syntax, 10},
                                           {"theme dark 3", ErrorCode::syntax, 12}}) {
    const auto loaded = load_text(std::string(line) + "\n", "wrong.bx");
    ASSERT_EQ(loaded.diagnostics.size(), 1U) << line;
    EXPECT_EQ(loaded.diagnostics[0].what.code, code) << line << said(loaded.diagnostics);
    EXPECT_EQ(loaded.diagnostics[0].what.place.column, column) << line << said(loaded.diagnostics);
  }
}

}  // namespace
}  // namespace betwixt

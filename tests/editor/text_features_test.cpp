// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests what an editor shows for a text: help, completions, symbols, colours, folds, and formatting of a part.
#include "editor/text_features.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "editor/film_texts.h"

namespace betwixt {
namespace text_sayings_test {

const std::string film =
    "# a film\n# of two\nrate 24\n\nlet beat = 12f\ncreate ball sphere radius=1\n  color=gold\n"
    "create gold box color=rgb(1 0.5 0)\nball.position\n  1f   (0 1 0)\n\n  # later\n  12f  (4 1 0)   linear\n\n"
    "ball.color\n  1f #f00\n  24f hsv(120deg 1 1)\nmake house\n  color teal\n  call roof\n";

std::string said(std::string_view words, std::size_t behind = 0) {
  const FilmTexts f({film});
  const TextNames names = f.names();
  const auto found = hover_at(names, f.texts()[0], 0, f.place(words, 0, behind), f.film().document);
  return found ? film.substr(found->word.at, found->word.size) + ": " + found->said.substr(0, found->said.find('\n'))
               : "";
}

TEST(Sayings, AWordIsWhatItIs) {
  EXPECT_EQ(said("ball.position"), "ball: ball, a sphere");
  EXPECT_EQ(said("beat"), "beat: beat = 12f");
  EXPECT_EQ(said("create ball"),
            "create: create, a command: Makes an object of a kind, a copy of another with everything below it, or all "
            "objects of a scene file.");
  EXPECT_EQ(said("position", 3).substr(0, 30), "position: position, a function");
  EXPECT_EQ(said("linear").substr(0, 26), "linear: linear, a twerper:");
  EXPECT_EQ(said("12f  (4"), "12f: 12f is 0.4583333333s");
  for (const char* words : {"# a film", "(4 1", ") "}) EXPECT_EQ(said(words), "") << words;
}

std::string words_at(const std::string& text) {
  const std::size_t at = text.find('|');
  const FilmTexts f({text.substr(0, at) + text.substr(at + 1)});
  const Completions found = completions_at(f.texts()[0].lines, at, f.film().document, SOURCE_DIR "/examples/meshes");
  return fmt::format("{}<{}", fmt::join(found.words, " "), at - found.from);
}

TEST(Sayings, WordsAreCompletedWhereTheyStand) {
  EXPECT_EQ(words_at("create ball sph|\n"), "sphere<3");
  EXPECT_EQ(words_at("create ball sphere\nball.rad|\nset ball.radius 2\n"), "ball.radius<8");
  EXPECT_EQ(words_at("create ball sphere\nball.color\n  1f gol|\n"), "gold goldenrod<3");
  EXPECT_EQ(words_at("create ball sphere\nball.color\n\n # so\n  1f red lin|\n"), "linear<3");
  EXPECT_EQ(words_at("create ball sphere\non sway ball.color\n  1f red lin|\nlayer sway add\n"), "linear<3");
  EXPECT_EQ(words_at("make house\n  pol|\n"), "polygon<3");
  EXPECT_EQ(words_at("create ball sphere (\n  col|\n"), "collision= color=<3");
  EXPECT_EQ(words_at("create eye camera\nlook through ey|\n"), "eye<2");
  EXPECT_EQ(words_at("use teap|\n"), "teapot.obj<4");
  const std::string lets = "let beat = 12f\nlet blood = #800000\ncreate ball sphere\n";
  EXPECT_EQ(words_at(lets + "at b|\n"), "beat<1");
  EXPECT_EQ(words_at(lets + "ball.radius\n  b|\n"), "beat<1");
  EXPECT_EQ(words_at(lets + "set ball.radius b|\n"), "beat<1");
  EXPECT_EQ(words_at(lets + "ball.color\n  1f bloo|\n"), "blood<4");
  EXPECT_EQ(words_at("undo|\n"), "<4") << "a word of the shell is none of a script";
  EXPECT_EQ(words_at("# crea|\n"), "<0");
  EXPECT_EQ(words_at("at 1f note \"crea|\"\n"), "<0");
  EXPECT_EQ(words_at("cre|"), "create<3");
}

TEST(Sayings, SymbolsAreWhatLinesMakeAndSheets) {
  std::string all;
  for (const TextSymbol& s : symbols(ScriptText(film))) {
    EXPECT_EQ(film.substr(s.word.at, s.word.size), s.name);
    all += fmt::format("{}({}) {} lines\n", s.name, s.detail,
                       1 + std::ranges::count(film.substr(s.whole.at, s.whole.size), '\n'));
  }
  EXPECT_EQ(all,
            "beat(let) 1 lines\nball(sphere) 1 lines\ngold(box) 1 lines\nball.position() 5 lines\n"
            "ball.color() 3 lines\nhouse(make) 3 lines\n");
}

TEST(Sayings, SheetsRemarksAndLongLinesAreFolded) {
  std::string all;
  for (const Fold& f : folds(ScriptText(film + "set ball.radius (1+\n 2)\n")))
    all += fmt::format("{}-{}{} ", f.first, f.last, f.remark ? "#" : "");
  EXPECT_EQ(all, "0-1# 8-12 14-16 17-19 20-21 ");
}

TEST(Sayings, ColoursAreFoundHoweverTheyAreWritten) {
  std::string all;
  for (const ColorAt& c : colors_in(ScriptText(film), FilmTexts({film}).film().document))
    all += fmt::format("{} {} {} {}; ", film.substr(c.span.at, c.span.size), c.color.r, c.color.g, c.color.b);
  EXPECT_EQ(all,
            "gold 1 0.8431372549019608 0; rgb(1 0.5 0) 1 0.5 0; #f00 1 0 0; hsv(120deg 1 1) 0 1 0; "
            "teal 0 0.5019607843137255 0.5019607843137255; ")
      << "a box that is called gold is none";
  EXPECT_EQ(ways_to_write({1, 0, 0}), (std::vector<std::string>{"red", "#ff0000", "rgb(1 0 0)"}));
  EXPECT_EQ(ways_to_write({0.25, 2, -1}), (std::vector<std::string>{"#40ff00", "rgb(0.25 2 -1)"}));
}

TEST(Sayings, AUsedFileStandsWhereItIsNamed) {
  const ScriptText lines("use \"a b.bx\"  # c\nuse d.bx\ncreate use box\n");
  EXPECT_EQ(used_at(lines, 8), "a b.bx");
  EXPECT_EQ(used_at(lines, lines.text().find("d.bx")), "d.bx");
  for (const char* words : {"use \"", "c\n", "use box"})
    EXPECT_FALSE(used_at(lines, lines.text().find(words))) << words;
}

TEST(Sayings, APartIsTidiedAsTheWholeWouldBe) {
  const std::string text =
      "create   ball  sphere\n\nrate 48\nball.position\n  24f (1 2 3)\n  0.1s   (0 0 0)\n\nset  ball.radius   2\n";
  const ScriptText lines(text);
  const auto part = [&](std::string_view words, std::size_t size) {
    return tidied_in(lines, {text.find(words), size});
  };
  EXPECT_EQ(part("ball  ", 1), "create ball sphere\n" + text.substr(text.find('\n') + 1));
  // The whole sheet, where a row is meant; the rate above it counts: 0.1 s come first.
  EXPECT_EQ(
      part("0.1s", 2),
      "create   ball  sphere\n\nrate 48\nball.position\n  0.1s  (0 0 0)\n  24f   (1 2 3)\n\nset  ball.radius   2\n");
  EXPECT_EQ(tidied_in(lines, {0, text.size()}), tidy(text));
  EXPECT_EQ(part("set", 4), text.substr(0, text.find("set")) + "set ball.radius 2\n");
}

TEST(Sayings, TidyingAllInPartsIsTidyingAll) {
  std::mt19937 random(5);
  for (int n = 0; n < 40; ++n) {
    const std::string text = film_by_chance(random);
    ASSERT_EQ(tidied_in(ScriptText(text), {0, text.size()}), tidy(text)) << text;
    const ScriptText lines(text);
    const std::size_t at = random() % text.size(), size = random() % (text.size() - at);
    const std::string once = tidied_in(lines, {at, size});
    ASSERT_EQ(tidy(once), tidy(text)) << text << at << " " << size;
    for (const TextSymbol& s : symbols(lines)) {
      ASSERT_EQ(text.substr(s.word.at, s.word.size), s.name);
      ASSERT_LE(s.whole.at, s.word.at);
      ASSERT_GE(s.whole.end(), s.word.end());
    }
  }
}

}  // namespace text_sayings_test
}  // namespace betwixt

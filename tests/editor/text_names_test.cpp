// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests where names are defined and used, and what renaming does.
#include "editor/text_names.h"

#include <gtest/gtest.h>

#include "betwixt/program.h"
#include "editor/film_texts.h"

namespace betwixt {
namespace {

constexpr const char* film =
    "rate 24\n"                                       // 0
    "let beat = 12f\n"                                // 1
    "define heat number 20\n"                         // 2
    "procedure wobbly twerper lua \"u\"\n"            // 3
    "create ball sphere  # ball is round\n"           // 4
    "create wheel{1..3} cylinder\n"                   // 5
    "create man group\n"                              // 6
    "create man/arm box\n"                            // 7
    "alias toys = ball wheel*\n"                      // 8
    "ball.position\n"                                 // 9
    "  1f+beat  (0 1 0) wobbly\n"                     // 10
    "set ball.radius = \"value('ball.heat') / 2\"\n"  // 11
    "set man/arm.look-at ball\n"                      // 12
    "set toys.heat 3\n"                               // 13
    "at 3f note \"the ball\"\n"                       // 14
    "set {ball,man}.heat 4\n"                         // 15
    "ball.motion\n  1f..24f \"R(1turn @ ball)\"\n"    // 16
    "let slow = 2\nset man.heat = \"slow * 2\"\n";    // 18

// "line:character" of each.
std::string places(const FilmTexts& f, const std::vector<TextSpan>& all) {
  std::string out;
  for (const TextSpan& s : all) {
    const ScriptText& lines = f.texts()[s.text].lines;
    const std::size_t line = lines.line_of(s.span.at);
    out += fmt::format("{}{}:{}", out.empty() ? "" : " ", line, s.span.at - lines.start(line));
  }
  return out;
}
std::string uses(const FilmTexts& f, std::string_view words, std::size_t behind = 0) {
  const TextNames names = f.names();
  const auto name = names.at(0, f.place(words, 0, behind));
  return name ? places(f, names.uses(*name)) : "no name";
}
std::string made(const FilmTexts& f, std::string_view words, std::size_t behind = 0) {
  const TextNames names = f.names();
  const auto name = names.at(0, f.place(words, 0, behind));
  return name ? places(f, names.made(*name)) : "no name";
}

TEST(TextNames, AThingIsFoundWhereverItIsSpokenOf) {
  const FilmTexts f({film});
  EXPECT_TRUE(f.film().diagnostics.empty()) << to_string(f.film().diagnostics[0]);
  // Not in the remark, not in the note; in code in quotes, in a motion behind @.
  EXPECT_EQ(uses(f, "ball.position"), "4:7 8:13 9:0 11:4 11:26 12:20 15:5 16:0 17:21");
  EXPECT_EQ(uses(f, "ball.position", 4), uses(f, "ball.position")) << "behind its last letter too";
  EXPECT_EQ(uses(f, "man/arm.look"), "6:7 7:7 12:4 15:10 19:4") << "man, where man/arm begins with it";
  EXPECT_EQ(uses(f, "man/arm.look", 4), "7:7 12:4") << "man/arm";
  EXPECT_EQ(uses(f, "toys.heat"), "8:6 13:4");
}

TEST(TextNames, WhatLetDefineAndProcedureMakeIsFoundInFormulasAndCode) {
  const FilmTexts f({film});
  EXPECT_EQ(uses(f, "beat"), "1:4 10:5");
  EXPECT_EQ(uses(f, "slow"), "18:4 19:16");
  EXPECT_EQ(uses(f, "heat number"), "2:7 11:31 13:9 15:15 19:8");
  EXPECT_EQ(uses(f, "wobbly"), "3:10 10:19");
}

TEST(TextNames, PlacesThatAreNoNames) {
  const FilmTexts f({film});
  for (const char* words : {"rate 24", "24", "sphere", "# ball", "the ball", "radius", "set ", "(0 1"})
    EXPECT_EQ(uses(f, words), "no name") << words;
  EXPECT_EQ(uses(f, "ball is round"), "no name");
}

TEST(TextNames, APatternMakesWhatItNames) {
  const FilmTexts f({film});
  EXPECT_EQ(made(f, "wheel*"), "5:7");
  EXPECT_EQ(made(f, "{ball,man}", 2), "4:7");
  const FilmTexts more(
      {"create wheel{1..3} box\ncreate wheely box\nset wheel*.color red\nset wheel2.color red\n"
       "create cart like wheel1\n"});
  EXPECT_EQ(made(more, "wheel*"), "0:7 1:7");
  EXPECT_EQ(made(more, "wheel2"), "0:7");
  EXPECT_EQ(made(more, "wheel1"), "0:7");
}

TEST(TextNames, WhatComesFromSomethingElseIsMadeWhereThatIs) {
  const FilmTexts f({"create man group\ncreate man/arm box\ncreate twin like man\nset twin/arm.color red\n"});
  EXPECT_EQ(made(f, "twin/arm", 6), "2:7");
  EXPECT_EQ(f.renamed(0, f.place("twin/arm", 0, 6), "leg")[0],
            "a pattern or another line creates 'twin/arm' together with other objects, so it cannot be renamed alone");
}

TEST(TextNames, APatternBeginsWithANameAboveIt) {
  const FilmTexts f({"create man group\ncreate man/leg{1..2} box\nset man/leg*.color red\nset man/*.color red\n"});
  EXPECT_EQ(uses(f, "man group"), "0:7 1:7 2:4 3:4");
  EXPECT_EQ(f.renamed(0, f.place("man"), "carl")[0],
            "create carl group\ncreate carl/leg{1..2} box\nset carl/leg*.color red\nset carl/*.color red\n");
  EXPECT_EQ(made(f, "man/leg*", 5), "1:7") << "behind that it is the pattern";
}

TEST(TextNames, WordsOfOtherSortsAreNoNames) {
  const FilmTexts f(
      {"create sun light shines=sun\nset sun.shines sun\ncreate look camera\nlook through look\n"
       "create box box\nprocedure tick lua \"1 -- tick\"\n"
       "set sun.intensity = \"tick() + #'tick' + #\\\"tick\\\"\"\n"});
  ASSERT_FALSE(has_errors(f.film().diagnostics)) << to_string(f.film().diagnostics[0]);
  EXPECT_EQ(uses(f, "sun light"), "0:7 1:4 6:4");
  EXPECT_EQ(uses(f, "look camera"), "2:7 3:13");
  EXPECT_EQ(uses(f, "box box"), "4:7");
  EXPECT_EQ(uses(f, "tick lua"), "5:10 5:25 6:21");
}

TEST(TextNames, OtherTextsOfTheFilmCount) {
  const FilmTexts f({"use 0.bx\nset ball.radius 3\n", "create ball sphere\nball.color\n  1f red\n"});
  ASSERT_TRUE(f.film().diagnostics.empty()) << to_string(f.film().diagnostics[0]);
  const TextNames names = f.names();
  const auto name = names.at(0, f.place("ball"));
  ASSERT_TRUE(name);
  EXPECT_EQ(names.made(*name), (std::vector<TextSpan>{{1, {7, 4}}}));
  EXPECT_EQ(f.renamed(0, f.place("ball"), "orb"),
            (std::vector<std::string>{"use 0.bx\nset orb.radius 3\n", "create orb sphere\norb.color\n  1f red\n"}));
}

TEST(Renaming, GivesAnotherNameWhereverItIsSpokenOf) {
  const FilmTexts f({film});
  const std::string orb = f.renamed(0, f.place("ball.position"), "orb")[0];
  EXPECT_NE(orb.find("create orb sphere  # ball is round\n"), std::string::npos) << orb;
  EXPECT_NE(orb.find("value('orb.heat')"), std::string::npos);
  EXPECT_NE(orb.find("note \"the ball\""), std::string::npos);
  EXPECT_NE(orb.find("{orb,man}"), std::string::npos);
  EXPECT_NE(orb.find("R(1turn @ orb)"), std::string::npos);
}

TEST(Renaming, WhatCannotBeRenamedIsRefusedInWords) {
  const FilmTexts f({film});
  const auto said = [&](std::string_view words, const char* to, std::size_t behind = 0) {
    return f.renamed(0, f.place(words, 0, behind), to)[0];
  };
  EXPECT_EQ(said("rate", "x"), "there is no name here that can be renamed");
  EXPECT_EQ(said("ball.position", "2x"), "'2x' cannot be a name here");
  EXPECT_EQ(said("beat", "a-b").substr(0, 6), "'a-b' ");
  EXPECT_NE(said("ball.position", "man").find("'man'"), std::string::npos);
  EXPECT_EQ(said("wheel{", "w"), "'wheel{1..3}' is a pattern; rename one of its objects instead");
  const FilmTexts b({"create ball sphere\ncreate box2 box\nset b*.color red\nset ball.radius 2\n"});
  EXPECT_EQ(b.renamed(0, b.place("ball"), "orb")[0],
            "renaming would change the film: a pattern or code refers to 'ball' in another way");
  EXPECT_EQ(b.renamed(0, b.place("ball"), "beta")[0],
            "create beta sphere\ncreate box2 box\nset b*.color red\nset beta.radius 2\n");
}

TEST(Renaming, ANameThatIsSpokenOfAlreadyIsNotTaken) {
  const FilmTexts f({"create ball sphere\nset ball.environments drift\n"});
  EXPECT_EQ(f.renamed(0, f.place("ball"), "drift")[0],
            "'drift' is already used in a line, although nothing has this name");
}

TEST(Renaming, AFilmWithErrorsIsRenamedWhereThatCanBeTold) {
  const FilmTexts f({"create ball sphere\nset ball.radius\nset ball.color red\n"});
  EXPECT_EQ(f.renamed(0, f.place("ball"), "orb")[0], "create orb sphere\nset orb.radius\nset orb.color red\n");
  const FilmTexts lists({"create ball sphere\nset b*.color red\nset ball.radius\n"});
  EXPECT_EQ(lists.renamed(0, lists.place("ball"), "orb")[0],
            "'ball' cannot be renamed to 'orb' while the script has errors");
}

// What the scene draws at a time, without names: where things are, their colours.
std::vector<Mat4> drawn(const std::string& text) {
  const Program program = Program::compile(load_text(text, "film.bx").document);
  std::vector<Mat4> all;
  for (const int frame : {1, 9, 17})
    for (const Item& i : program.frame(Rate{24, 1}.frame(frame)).items) all.push_back(i.world);
  return all;
}

TEST(Renaming, ThereAndBackIsTheSameText) {
  std::mt19937 random(11);
  int renamed = 0;
  for (int n = 0; n < 25; ++n) {
    const std::string text = film_by_chance(random);
    const FilmTexts f({text});
    ASSERT_FALSE(has_errors(f.film().diagnostics)) << text << to_string(f.film().diagnostics[0]);
    const TextNames names = f.names();
    for (const MadeName& m : names.all()) {
      const std::string name = f.part(m.word);
      const std::string other =
          name.rfind('/') == std::string::npos ? "quite_another" : name.substr(0, name.rfind('/')) + "/other";
      const std::string there = f.renamed(0, m.word.span.end(), other)[0];
      ASSERT_EQ(there.find("would change the film"), std::string::npos) << text << name << "\n" << there;
      const FilmTexts g({there});
      ASSERT_FALSE(has_errors(g.film().diagnostics)) << there << to_string(g.film().diagnostics[0]);
      const std::string back = g.renamed(0, m.word.span.at + other.size(), name)[0];
      ASSERT_EQ(back, text) << there;
      ASSERT_EQ(drawn(there), drawn(text));
      ++renamed;
    }
  }
  EXPECT_GT(renamed, 200);
}

}  // namespace
}  // namespace betwixt

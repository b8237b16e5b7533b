// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the formatter of scripts, `betwixt tidy`.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

TEST(Tidy, SortsRowsWithTheirComments) {
  EXPECT_EQ(tidy("create  ball sphere radius =1.50,color= gold # shiny\n\n\n\nball.position\n"
                 "    24.0f (8, 10 0)   ease-in = 4f # last\n  # the first\n 1f   (0  10 0.0)\n    12f (4 1 0) "
                 "linear\nset ball.radius 2"),
            "create ball sphere radius=1.5 color=gold  # shiny\n"
            "\n"
            "ball.position\n"
            "  # the first\n"
            "  1f   (0 10 0)\n"
            "  12f  (4 1 0)   linear\n"
            "  24f  (8 10 0)  ease-in=4f  # last\n"
            "set ball.radius 2\n");
}

TEST(Tidy, BracketsOfFormulasStayClose) {
  const std::string text =
      "let m = 2\ncreate o{1..3} sphere position=(3*cos(i*tau/n)  (1+2)*m -(2)^m)\n"
      "set o1.radius  2*(3-1)\no2.position.x\n  1f (1+2)*m   linear\n  9f -(m+1)*hash(2,3)\n";
  const std::string tidied = tidy(text);
  EXPECT_EQ(tidied,
            "let m = 2\ncreate o{1..3} sphere position=(3*cos(i*tau/n) (1+2)*m -(2)^m)\n"
            "set o1.radius 2*(3-1)\no2.position.x\n  1f  (1+2)*m           linear\n  9f  -(m+1)*hash(2 3)\n");
  EXPECT_EQ(tidy(tidied), tidied);
  EXPECT_EQ(read(tidied).document, read(text).document);
}

// Tidying what is tidy changes nothing, also where the line cannot be read.
TEST(Tidy, SignBehindASymbolGoesWhetherOrNotABlankIsThere) {
  for (const char* const text : {"create a sphere heat=+0.50\n", "create a sphere heat= +0.50\n"})
    EXPECT_EQ(tidy(text), "create a sphere heat=0.5\n");
  EXPECT_EQ(tidy("a.motion\n  1f..9f R(1deg @+0.50 @ +2)\n"), "a.motion\n  1f..9f  R(1deg @ 0.5 @ 2)\n");
  EXPECT_EQ(tidy("{1..3} h.eat=+0.50\n"), "{1..3} h.eat = 0.5\n");
}

TEST(Tidy, RowsThatCountFromTheOneAboveStayBehindIt) {
  const std::string text = "create b sphere\nb.radius\n  37f 3\n  +12.0f 5\n  1f 1\n  +0.50s 2\n  +12f 4\n";
  EXPECT_EQ(tidy(text), "create b sphere\nb.radius\n  1f     1\n  +0.5s  2\n  +12f   4\n  37f    3\n  +12f   5\n");
  EXPECT_EQ(read(tidy(text)).document, read(text).document);
  const std::string clock = "create b sphere\nb.radius\n  1f 1\n  +00:01 2\n  5f 3\n";
  EXPECT_EQ(read(tidy(clock)).document, read(clock).document);
}

// Which of two rows comes first says which one counts where they meet: here for the second ball.
TEST(Tidy, RowsAtTimesWithNamesStayInTheirOrder) {
  const std::string text =
      "let beat = 12f\ncreate b{1..3} sphere\nb*.radius\n  20f-i*4f 3.0\n  10f+i*1f 1\n  60f-beat 5\n"
      "b1.position\n  1f+24f (1 0 0)\n  2.0s (2 0 0)\n  1f (0 0 0)\n";
  const std::string tidied = tidy(text);
  EXPECT_EQ(tidied,
            "let beat = 12f\ncreate b{1..3} sphere\nb*.radius\n  20f-i*4f  3\n  10f+i*1f  1\n  60f-beat  5\n"
            "b1.position\n  1f      (0 0 0)\n  1f+24f  (1 0 0)\n  2s      (2 0 0)\n");
  EXPECT_EQ(read(tidied).document, read(text).document);
}

// A change that lasts begins with the value that the rows before it have given.
TEST(Tidy, RowsThatLastStayInTheirOrder) {
  const std::string text =
      "create t text tex=\"x\"\nt.tex\n  25f \"y\" for 36f\n  813f \"z\" for 24f\n  187f \"w\" for 24f\n";
  EXPECT_EQ(read(tidy(text)).document, read(text).document);
}

TEST(Tidy, EveryExampleMeansTheSame) {
  int films = 0;
  for (const auto& file : std::filesystem::directory_iterator(SOURCE_DIR "/examples")) {
    if (file.path().extension() != ".bx") continue;
    ++films;
    std::ifstream in(file.path());
    const std::string text{std::istreambuf_iterator<char>(in), {}}, tidied = tidy(text);
    const Loaded before = load_text(text, file.path()), after = load_text(tidied, file.path());
    EXPECT_EQ(said(after.diagnostics), said(before.diagnostics)) << file.path();
    EXPECT_EQ(after.document, before.document) << file.path();
    EXPECT_EQ(tidy(tidied), tidied) << file.path();
  }
  EXPECT_GE(films, 20);
}

TEST(Tidy, TheExampleIsTidyAlready) {
  std::ifstream in(SOURCE_DIR "/examples/bounce.bx");
  const std::string bounce{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(read(tidy(bounce)).document, read(bounce).document);
}

TEST(Tidy, LeavesAloneWhatCannotBeRead) {
  for (const char* text : {"set  a.b (1  2\nset", "create  a text text=\"open\n", "  )  \n", "a  \"\"\"x"})
    EXPECT_EQ(tidy(text), text);
}

TEST(Tidy, OrderOfEqualTimesSurvivesARateFromElsewhere) {
  // At 25 frames a second 26f is 1s, and the later row counts; tidying cannot know the rate that the other file says.
  const std::string text = "use rate.bx\nb.radius\n  26f 1\n  1s 2\n";
  EXPECT_EQ(tidy(text), "use rate.bx\nb.radius\n  26f  1\n  1s   2\n");
}

TEST(Tidy, ByteOrderMarkGoes) { EXPECT_EQ(tidy("\xEF\xBB\xBFrate  25\n"), "rate 25\n"); }

// shows: G58
TEST(Tidy, KeepsTheSheetsOfLayers) {
  const std::string script = "create a sphere\nlayer l add\non l a.position\n  1f  (0 0 0)\n  9f  (1 2 3)  linear\n";
  EXPECT_EQ(tidy(script), script);
  EXPECT_EQ(read(tidy(script)).document, read(script).document);
}

}  // namespace
}  // namespace betwixt

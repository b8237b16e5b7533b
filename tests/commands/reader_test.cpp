// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests how a script is read line by line: sheets and their rows, the places of errors, and texts that are no scripts.
#include <ctime>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

// shows: G33
TEST(Sheets, RowsInAnyOrderWithCommentsAndBlankLines) {
  const Document wanted = read("create b sphere\nb.radius\n 1f 1 linear\n 3f 3\n 5f 9\n").document;
  EXPECT_EQ(read("create b sphere\nb.radius\n\t5f 9\n\n# here\n  1f 1 linear   # there\n\n      3f 3").document,
            wanted);
  EXPECT_EQ(read("create b sphere\r\nb.radius\r\n  1f 1 linear\r\n  3f 3\r\n  5f 9\r\n").document, wanted);
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "create b sphere\nb.radius\n  1f 1 linear\n  3f 3\n  5f 9\n")
                .document,
            wanted);
  EXPECT_EQ(read("create b sphere\nb.radius\n  5f 9\nb.radius\n  3f 3\n  1f 2\n  1f 1 linear\n").document, wanted);
  EXPECT_EQ(read("create b sphere\nalias all = b\nall.radius\n  1f 1 linear\n  3f 3\n  5f 9\n").document.names().size(),
            1u);
}

// shows: G2 G26
TEST(Sheets, ManyObjectsAndComponents) {
  const LoadedFilm s("create b{1..2} sphere\nb*.position.y\n  1f 0 linear\n  3f 2\nb1.position\n  2f (1 1 1)\n");
  expect_numbers(s, "b2.position", "2f", {0, 1, 0}, 1e-9);
  expect_numbers(s, "b1.position", "2f", {1, 1, 1}, 1e-9);
}

TEST(Sheets, RowsOfOneTimeAreWarnedOf) {
  const LoadedFilm twice("create a sphere\na.position\n 1f (0 0 0)\n 1f (4 0 0)\n");
  EXPECT_EQ(remarks_told(twice.loaded), std::vector<std::string>{"warning syntax 4:5 (4 0 0)"});
  expect_numbers(twice, "a.position", "1f", {4, 0, 0});
  // Another sheet may well replace an event.
  const LoadedFilm again("create a sphere\na.position\n 1f (0 0 0)\na.position\n 1f (4 0 0)\n");
  EXPECT_TRUE(again.loaded.diagnostics.empty());
}

TEST(Reader, LineAndCaret) {
  const Loaded l = read("create ball sphere\nset ball.rádius 1\n");
  EXPECT_EQ(said(l.diagnostics), R"(test.bx:2:10: error: 'ball', a sphere, has no function 'rádius'
  set ball.rádius 1
           ^~~~~~
  did you mean 'radius'?
)");
  EXPECT_EQ(told("create é sphere"), "syntax 1:8 é");
  // Columns count characters, tabs are kept above the caret.
  EXPECT_EQ(said(read("create t text text=\"ä\"\tcolour=red").diagnostics),
            "test.bx:1:24: error: a text has no 'colour'\n"
            "  create t text text=\"ä\"\tcolour=red\n"
            "                        \t^~~~~~\n"
            "  did you mean 'color'?\n");
}

TEST(Reader, AllOfAFileInItsOrder) {
  const Loaded l = read(
      "rat 24\ncreate ball sphere\n\nball.postion\n  1f (0 0 0)\n  what is this\n\n  9f junk\nball.position\n  1f (0)\n"
      "  2f (1 1 1) liner\n  3 (1 1 1)\n  x (1 1 1)\n  4f (4 4 4)\nset ball.radius\ncreate ball box\nballs\n  1f 2\n  "
      "2f 3\n");
  EXPECT_EQ(all_told(l), (std::vector<std::string>{
                             "name 1:1 rat",
                             "name 4:6 postion",
                             "type 10:6 (0)",
                             "name 11:14 liner",
                             "type 12:3 3",
                             "syntax 13:3 x",
                             "syntax 15:16",
                             "name 16:8 ball",
                             "name 17:1 balls",
                         }))
      << said(l.diagnostics);
  EXPECT_EQ(l.document, read("create ball sphere\nball.position\n  4f (4 4 4)\n").document);
}

TEST(Reader, ABracketThatIsNotClosedSpoilsOnlyItsLine) {
  const Loaded l =
      read("create ball sphere\nball.position\n  1f (0 0 0\n  2f (1 1 1)\n  3f (2 2 2)\nset ball.radius 4\n");
  EXPECT_EQ(all_told(l), (std::vector<std::string>{"syntax 3:6 ("})) << said(l.diagnostics);
  EXPECT_EQ(l.document,
            read("create ball sphere\nball.position\n  2f (1 1 1)\n  3f (2 2 2)\nset ball.radius 4\n").document);
  const Loaded text = read("create a text text=\"\"\"open\ncreate b sphere\n");
  EXPECT_EQ(all_told(text), (std::vector<std::string>{"syntax 1:20 \"\"\""}));
  EXPECT_EQ(text.document.names(), (std::vector<std::string>{"b"}));
}

TEST(Reader, NotAText) {
  using namespace std::literals;
  for (const auto& [text, wanted, byte] :
       std::vector<std::tuple<std::string, std::string, const char*>>{{"rate 24\n\0"s, "file 2:1", "0x00"},
                                                                      {"rate\x80"s, "file 1:5", "0x80"},
                                                                      {"# \xC3\x28"s, "file 1:3", "0xc3"},
                                                                      {"# \xE2\x82"s, "file 1:3", "0xe2"},
                                                                      {"# \xC0\xAF"s, "file 1:3", "0xc0"},
                                                                      {"# \xED\xA0\x80"s, "file 1:3", "0xed"},
                                                                      {"# \xF4\x90\x80\x80"s, "file 1:3", "0xf4"},
                                                                      {"\x7F"
                                                                       "ELF\x02\x01"s,
                                                                       "file 1:5", "0x02"}}) {
    EXPECT_EQ(all_told(read(text)), std::vector<std::string>{wanted});
    EXPECT_TRUE(mentions(text, byte)) << byte;
    EXPECT_EQ(read(text).document, read("").document);
  }
  EXPECT_EQ(read("# \xF0\x9F\x8E\xAC é €\n# \xC3\xA9").diagnostics.size(), 0u);
}

TEST(Reader, AbsurdTextsAreRefusedSoon) {
  const auto begun = std::clock();  // of processors, whatever else the machine does
  const std::string open(100'000, '('), deep = open + std::string(100'000, ')');
  for (const std::string& text :
       {"set ball.position " + deep, "create p polygon points=" + deep, open, deep, "create b sphere radius=" + open,
        "create " + std::string(100'000, '{') + " sphere", "alias a = " + std::string(100'000, '{'),
        "create a" + std::string(1'000'000, 'a') + " sphere", "at " + std::string(1'000'000, '9') + "f note \"\"",
        "set a." + std::string(1'000'000, '*') + " 1", std::string(1'000'000, '"')}) {
    const Loaded l = read(text + "\ncreate ball sphere\n");
    EXPECT_EQ(all_told(l).size(), 1u) << text.substr(0, 60);
    EXPECT_LT(said(l.diagnostics).size(), 1000u);
    EXPECT_EQ(l.document.names().size(), 1u) << text.substr(0, 60);
  }
  std::string garbage;
  for (int i = 0; i < 100'000; ++i) garbage += fmt::format("what is this line {} (((\n", i);
  const Loaded l = read(garbage);
  ASSERT_EQ(l.diagnostics.size(), 1001u);
  EXPECT_EQ(l.diagnostics.back().what.message, "there are more than 1000 errors; the others are not shown");
  EXPECT_EQ(l.diagnostics[999].what.place.line, 1000);
  EXPECT_LT(std::clock() - begun, 60 * CLOCKS_PER_SEC) << "not a measure, only a bound";
}

// A text need not end with a zero, nor a command with a line. (The address sanitizer sees where one was looked for.)
TEST(Reader, WhatStandsBehindATextIsNotRead) {
  const std::string text =
      "create o sphere\nanimate spin every 1t by rotate(1deg, y)\nmake l\n  point (0 0)\nstart l\nat 2f delete l\n"
      "set o.environments (spin)\nat 9f note \"x\"\no.radius\n  1f 2 linear\nset o.radius = \"t\"\nstart o";
  for (std::size_t n = 0; n <= text.size(); ++n) {
    const std::vector<char> exactly(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(n));
    load_text({exactly.data(), n}, "test.bx");
  }
  const std::vector<char> exactly(text.begin(), text.end());
  EXPECT_EQ(all_told(load_text({exactly.data(), exactly.size()}, "test.bx")), std::vector<std::string>{"name 12:7 o"});
}

TEST(Reader, NothingIsFine) {
  for (const char* text :
       {"", "\n", "\n\n  \n", "# only a comment", "#", "#!/usr/bin/betwixt play\nrate 24", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(read(text).diagnostics.size(), 0u) << text;
  }
}

TEST(Sheets, ARowWithAPlusComesAfterTheOneAbove) {
  const LoadedFilm s("create a sphere\na.radius\n  12f 1 linear\n  +12f 2\n  +0.5s 3\n  60f 4\n  +1f 5\n");
  expect_numbers(s, {{"a.radius", "12f", {1}},
                     {"a.radius", "18f", {1.5}},
                     {"a.radius", "24f", {2}},
                     {"a.radius", "36f", {3}},
                     {"a.radius", "60f", {4}},
                     {"a.radius", "61f", {5}}});
  EXPECT_EQ(all_told(read("create a sphere\na.radius\n  12f 1\na.radius\n  +12f 1\n")),
            std::vector<std::string>{"syntax 5:3 +12f"});
}

TEST(Reader, SaysHowManyAPatternNamesWhereThatIsAsked) {
  const char* text =
      "create s{1..3}-{1..4} box position=(i2 i1 0)\ncreate ball sphere\nset s*.color red\nset ball.color red\n"
      "s1-*.position\n  1f (i 0 0)\n  +12f (i 1 0)\nstagger s*.position by 1f\nat 3f hide s{1,2}-*\n"
      "set none*.color red\nremove s1-*\n";
  const auto counts = [&](bool asked) {
    std::vector<std::string> all;
    for (const Diagnostic& d : load_text(text, "t", {.counts = asked}).diagnostics)
      if (const std::string& m = d.what.message; d.severity == Severity::notice)
        all.push_back(m.ends_with(" objects") ? fmt::format("{}: {}", d.what.place.line, m) : told(d));
    return all;
  };
  EXPECT_EQ(counts(true), (std::vector<std::string>{"1: 12 objects", "3: 12 objects", "5: 4 objects", "8: 12 objects",
                                                    "9: 8 objects", "notice name 10:5 none*", "11: 4 objects"}));
  EXPECT_EQ(counts(false), std::vector<std::string>{"notice name 10:5 none*"});
}

}  // namespace
}  // namespace betwixt

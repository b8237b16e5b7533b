// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests commands of the author's own that have named parameters, and the sheets and times that they write.
#include <random>

#include "language/values.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

const std::string hop =
    "create ball sphere\ncreate cube box\nrate 24\n"
    "procedure hop command (who object, at time, height number = 1, tint color = none) \"Hops once.\" lua \"\"\"\n"
    "  sheet(who .. '.position.y', {{at, 0, 'smooth'}, {at + 0.5, height}, {at + 1, 0, 'hold ease-in=2f'}})\n"
    "  if tint then sheet(who .. '.color', {{at, tint}}) end\n\"\"\"\n";

// shows: S8 G6
TEST(CommandParameters, MakeTheEventsThatOneWouldWrite) {
  const std::string by_hand =
      "create ball sphere\ncreate cube box\nrate 24\n"
      "ball.position.y\n  13f 0 smooth\n  25f 2.5\n  37f 0 hold ease-in=2f\nat 13f ball.color rgb(1 0.5 0)\n"
      "cube.position.y\n  49f 0 smooth\n  61f 1\n  73f 0 hold ease-in=2f\n";
  for (const char* call : {"hop ball 13f 2.5 rgb(1 0.5 0)\nhop cube 2s\n",
                           "hop tint=rgb(1 0.5 0) at=0.5s who=ball height=2.5\nhop cube at=49f tint=none\n",
                           "let half = 0.5s\nhop ball at=half height=10/4 tint=#ff8000\nhop cube, at=49f\n"})
    for (const char* target : {"ball.position.y", "cube.position.y"})
      EXPECT_EQ(write_rows(read(hop + call).document, find_targets(target, read(hop).document)->front()),
                write_rows(read(by_hand).document, find_targets(target, read(by_hand).document)->front()))
          << call;
  expect_numbers(LoadedFilm(hop + "hop ball 13f 2.5 rgb(1 0.5 0)\n"), "ball.color", "13f", {1, 0.5, 0}, 1e-6);
}

TEST(CommandParameters, ReachTheCodeWithTheirTypes) {
  const Loaded film = read(
      "create a{1..3} sphere\ncreate road curve points=((0 0 0) (4 0 0))\n"
      "procedure tell command (one object, all objects, from time, long length, n number, turn angle, v vector, c "
      "color,"
      " yes boolean, words text, gone text = none, late time = 2s) lua \"\"\"\n"
      "  local p = place('road', 0.25, 0)\n"
      "  run('at 1f note \"' .. one .. ' ' .. table.concat(all, '+') .. ' ' .. from .. ' ' .. long .. ' ' .. n .. ' ' "
      "..\n"
      "      string.format('%.6f', turn) .. ' ' .. v.y .. ' ' .. c.g .. ' ' .. tostring(yes) .. ' ' .. words .. ' ' "
      "..\n"
      "      tostring(gone) .. ' ' .. late .. ' ' .. p.x .. ' ' .. when(1.5) .. ' ' .. when(1/7) .. '\"')\n\"\"\"\n"
      "tell a2 a* 25f long=12f n=-1.5 turn=90deg v=(1 2 3) c=#00ff00 yes=on words=\"it's here\"\n");
  EXPECT_FALSE(has_errors(film.diagnostics)) << said(film.diagnostics);
  const auto notes = film.document.notes(earliest_time, latest_time);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].text, "a2 a1+a2+a3 1 0.5 -1.5 1.570796 2 1 true it's here nil 2 1 37f 0.1428571429s");
}

TEST(CommandParameters, CanBeDeclaredOverSeveralLines) {
  const LoadedFilm film(
      "create a sphere\nprocedure put command (who object,  # whom\n  at time = -5s,\n  n number = 3) lua "
      "\"sheet(who .. '.radius', {{at, n, 'hold'}, {at + 1, 2 * n}})\"\nput a\nput a at=-4s n=(1 + 1)\n");
  expect_numbers(film, {{"a.radius", "-4.5s", {3}}, {"a.radius", "-3.5s", {2}}, {"a.radius", "1f", {4}}});
}

TEST(CommandParameters, WarningsOfTheirLinesAreSaid) {
  const Loaded film = read("create a sphere\nprocedure put command lua \"sheet('a.radius', {{1, 2}, {1, 3}})\"\nput\n");
  ASSERT_EQ(film.diagnostics.size(), 1u);
  EXPECT_EQ(film.diagnostics[0].severity, Severity::warning);
  EXPECT_EQ(film.diagnostics[0].what.place.line, 3);
  // An error names the line of the code in its file.
  EXPECT_NE(said(read("procedure put command lua \"\"\"\n  local x = 1\n  x()\n\"\"\"\nput\n").diagnostics)
                .find("test.bx:3: "),
            std::string::npos);
}

TEST(CommandParameters, TimesComeBackToTheFlick) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 40; ++i) {
    const Time t{static_cast<std::int64_t>(random() % (705'600'000ull * 3600 * 10))};
    const Loaded film = read(
        fmt::format("create a sphere\nprocedure put command (at time) lua \"run('at ' .. when(at) .. ' a.radius 2') "
                    "sheet('a.shininess', {{{{at, 0.5}}}})\"\nput {}\n",
                    fmt::format("{:.12f}s", t.seconds())));
    ASSERT_FALSE(has_errors(film.diagnostics)) << said(film.diagnostics);
    EXPECT_EQ(film.document.range().second.flicks, t.flicks);
  }
}

TEST(CommandParameters, AreWrittenAndReadBack) {
  const Loaded first = read(hop + "procedure plain command \"Says hello.\" lua \"run('range 1f 5f')\"\n");
  EXPECT_FALSE(has_errors(first.diagnostics)) << said(first.diagnostics);
  const Loaded second = read(write(first.document));
  EXPECT_FALSE(has_errors(second.diagnostics)) << write(first.document) << said(second.diagnostics);
  EXPECT_EQ(first.document, second.document);
  EXPECT_NE(first.document, read(hop).document);
}

TEST(CommandParameters, ErrorsByTheirPlace) {
  for (const auto& [line, wanted] : std::vector<std::pair<std::string, std::string>>{
           {"hop ball", "syntax 1:1 hop"},
           {"hop bal at=1s", "name 1:5 bal"},
           {"hop ball at=1s hight=3", "name 1:16 hight"},
           {"hop ball at=soon", "syntax 1:13 soon"},
           {"hop ball at=1s at=2s", "syntax 1:16 at"},
           {"hop who=ball 1s", "syntax 1:14 1"},
           {"hop ball 1s 2 red 4", "syntax 1:19"},
           {"hop ball 1s two", "syntax 1:13 two"},
           {"hop ball 1s tint=reddish", "name 1:18 reddish"},
           {"hop ball 1s height=none", "syntax 1:20 none"},
           {"procedure x command (a time, a time) lua \"1\"", "name 1:30 a"},
           {"procedure x command (end time) lua \"1\"", "syntax 1:22 end"},
           {"procedure x command (a-b time) lua \"1\"", "syntax 1:22 a-b"},
           {"procedure x command (a tme) lua \"1\"", "name 1:24 tme"},
           {"procedure x command (a) lua \"1\"", "syntax 1:23"},
           {"procedure x command (a time = soon) lua \"1\"", "syntax 1:31 soon"},
           {"procedure x command (a time) lua \"a +\"", "syntax 1:34"},
           {"procedure x twerper (a time) lua \"1\"", "syntax 1:21"}}) {
    expect_refused(hop, line, wanted);
  }
}

TEST(CommandParameters, WrongSheetsLeaveNothingBehind) {
  const std::string head = "create ball sphere\n";
  const Loaded good = read(head);
  for (const char* code :
       {"sheet('ball.position', {{1, vec(1, 2, 3)}, {2}})", "sheet('ball.position', {{1, vec(1, 2, 3)}, {2, 'soon'}})",
        "sheet('ball.nothing', {{1, 2}})", "sheet('ball.world', {{1, 2}})", "sheet('nobody.position', {})",
        "sheet(3, {})", "sheet('ball.position', 3)", "sheet('ball.radius', {{'x', 2}})", "sheet('ball.radius', {3})",
        "sheet('ball.radius', {{1, 2, 3}})", "sheet('ball.radius', {{{2, 1}, 2}})", "sheet('ball.radius', {{1/0, 2}})",
        "sheet('ball.radius', {{1, 2}}) run('bad')", "when('x')", "when(1/0)", "place('ball', 0.5, 0)",
        "place('ball', 0.5)"}) {
    const Loaded bad = read(head + "procedure x command lua \"" + code + "\"\nx\nprocedure x command lua \"1\"\n");
    EXPECT_EQ(all_told(bad).size(), 1u) << code << "\n" << said(bad.diagnostics);
    const Loaded unused = read(head + "procedure x command lua \"" + code + "\"\nprocedure x command lua \"1\"\n");
    EXPECT_EQ(bad.document, unused.document) << code;
  }
}

}  // namespace
}  // namespace betwixt

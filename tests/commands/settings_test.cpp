// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the settings of the whole document.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

TEST(Settings, SettingsOfTheDocument) {
  const LoadedFilm s("rate 30000/1001\nticks 60\nrange 1f 100f\nbackground #336699\nnotes off\npolicy ignore\n");
  EXPECT_EQ(s.loaded.document.rate(), (Rate{30000, 1001}));
  EXPECT_EQ(s.loaded.document.frame_count(), 100);
  EXPECT_NEAR(s.program.frame({}).background->x, std::pow((0.2 + 0.055) / 1.055, 2.4), 1e-12);
  EXPECT_EQ(LoadedFilm("").loaded.document.frame_count(), 24);
}

// shows: G27
TEST(Settings, PolicyDecidesWhatAMeaninglessValueGets) {
  const LoadedFilm translate("create b sphere\npolicy translate\nset b.radius (3 4 0)\nset b.position 2\n");
  expect_numbers(translate, "b.radius", "1f", {5});
  expect_numbers(translate, "b.position", "1f", {2, 2, 2});
  const Loaded ignore = read("create b sphere\npolicy ignore\nset b.radius (3 4 0)\nset b.radius 2\n");
  ASSERT_EQ(ignore.diagnostics.size(), 1u);
  EXPECT_EQ(told(ignore.diagnostics[0]), "warning type 3:14 (");
  EXPECT_EQ(all_told(read("create b sphere\nset b.radius (3 4 0)\n")), (std::vector<std::string>{"type 2:14 ("}));
}

// shows: G27
TEST(Policy, TranslateFitsOneValueToEachOfSeveralTypes) {
  const LoadedFilm film(
      "rate 24\npolicy translate\ncreate {a,b} sphere\nset {a,b}.{radius,position,color} 2\n"
      "at 25f {a,b}.{radius,position} (3 4 0)\nset a.{display,transparency} 0\n");
  for (const char* name : {"a", "b"}) {
    const std::string o = name;
    expect_numbers(film, o + ".position", "24f", {2, 2, 2}, 1e-12);
    expect_numbers(film, o + ".radius", "24f", {2}, 1e-12), expect_numbers(film, o + ".radius", "25f", {5}, 1e-12);
    expect_numbers(film, o + ".position", "25f", {3, 4, 0}, 1e-12);
  }
  EXPECT_EQ(film.frame("1f").items.size(), 1u);  // a is off
  EXPECT_EQ(all_told(read("create a sphere\nset a.{radius,position} 2\n")),
            std::vector<std::string>{"type 2:7 {radius,position}"});
}

TEST(Targets, EachWordInBracesMustBeAFunctionOfOneOfThem) {
  EXPECT_EQ(told("create a sphere\ncreate b torus\nset {a,b}.{radius,tube} 0.2\n"), "");  // each has one of them
  EXPECT_EQ(told("create a sphere\nset a.{radius,tube} 0.2\n"), "");  // it lacks it, and is left out
  EXPECT_EQ(told("create a sphere\nset a.{radius,shinines} 2\n"), "name 2:7 {radius,shinines}");
  EXPECT_TRUE(mentions("create a sphere\nset a.{radius,shinines} 2\n", "'shinines'"));
  const Loaded l = read("create a sphere\nset a.{position,scale.y} 3\n");
  ASSERT_EQ(all_told(l), std::vector<std::string>{"name 2:7 {position,scale.y}"});
  EXPECT_TRUE(mentions(l, "'scale.y'"));
  EXPECT_EQ(l.diagnostics[0].what.hint, "write the component after the braces: {position,scale}.y");
}

// A light's `shadow` is a word, everybody else's on or off; a text's `size` a number, a box's three.
TEST(Targets, OneValueReachesAllWhomItFits) {
  const std::string head = "create b{1..6} sphere\ncreate lamp light\ncreate t text text=\"a\"\ncreate q box\n";
  const LoadedFilm film(head + "set *.shadow off\nset {q,t}.size 2\n");
  for (const char* thing : {"b1", "b6", "q", "t"}) expect_numbers(film, std::string(thing) + ".shadow", "1f", {0});
  EXPECT_EQ(film.text("lamp.shadow", "1f"), "off");
  expect_numbers(film, "t.size", "1f", {2});
  expect_numbers(film, "q.size", "1f", {1, 1, 1});
  const auto notices = [&](const std::string& line) {
    std::vector<std::string> said;
    const Loaded l = read(head + line + "\n");
    for (const Diagnostic& d : l.diagnostics)
      said.push_back(
          fmt::format("{}: {} ({})", d.severity == Severity::notice ? "notice" : "error", d.what.message, d.what.hint));
    return said;
  };
  using Said = std::vector<std::string>;
  EXPECT_EQ(notices("set *.shadow off"), Said{});
  EXPECT_EQ(notices("at 1f *.shadow on"), Said{});
  EXPECT_EQ(notices("set {lamp,q}.shadow soft"),
            Said{"notice: left out: q, whose shadow is on or off (expected on or off here)"});
  EXPECT_EQ(remarks_told(head + "at 1f *.shadow soft\n"), Said{"notice syntax 5:7 *.shadow"});
  EXPECT_TRUE(mentions(head + "at 1f *.shadow soft\n", "b1, b2, b3, b4 and 4 more"));
  EXPECT_EQ(notices("set {q,t}.size 2").size(), 1u);
  EXPECT_EQ(all_told(head + "set {q,t}.size red\n"), Said{"type 5:16 red"});
  EXPECT_EQ(remarks_told(head + "{t,q}.size\n  1f 2\n"), Said{"notice syntax 5:1 {t,q}.size"});
  EXPECT_TRUE(mentions(head + "{t,q}.size\n  1f 2\n", "q, whose size"));
}

TEST(Settings, PolicyTranslatesTypesUnitsAndSizes) {
  const LoadedFilm s(
      "policy translate\ncreate b sphere\ncreate p plane\ncreate eye camera\ncreate word text text=\"a\"\n"
      "set b.rotation.x 90\nset b.radius 45deg\nset p.rotation 10\nset p.size (3 4 5)\nset b.position (1 2)\n"
      "set b.shininess 25%\nset b.color 0.5\nset b.display 0\nset word.text 5\nset eye.fov 60\nset p.shininess on\n"
      "set word.rotation axis(z, 90)\nset b.transparency 50cm\n"
      "at 1f p.position 7\nspread p.position.{x,y} from 1 to (0 3 4)\n");
  expect_numbers(s, "b.rotation", "1f", {pi / 2, 0, 0});
  expect_numbers(s, "p.rotation", "1f", {pi / 18, pi / 18, pi / 18});
  expect_numbers(s, "b.radius", "1f", {45});
  expect_numbers(s, "p.size", "1f", {3, 4, 0});
  expect_numbers(s, "b.position", "1f", {1, 2, 0});
  expect_numbers(s, "b.shininess", "1f", {0.25});
  expect_numbers(s, "b.transparency", "1f", {0.5});
  expect_numbers(s, "b.color", "1f", {0.5, 0.5, 0.5});
  expect_numbers(s, "b.display", "1f", {0});
  expect_numbers(s, "p.shininess", "1f", {1});
  expect_numbers(s, "eye.fov", "1f", {pi / 3});
  expect_numbers(s, "word.rotation", "1f", {std::sqrt(0.5), 0, 0, std::sqrt(0.5)});
  EXPECT_EQ(s.text("word.text", "1f"), "5");
}

// shows: G27
TEST(Settings, PolicyIgnoresTypesUnitsAndSizes) {
  for (const char* line :
       {"set b.rotation.x 90", "set b.radius 45deg", "set b.rotation 10", "set b.position (1 2 3 4)", "set b.color 0.5",
        "set b.display 0", "set b.shininess 25%", "set word.text 5deg", "at 3f b.position 7",
        "copy a*.position 1f..9f to 9f on c*.position", "rotate b.rotation 1f..9f 90 y",
        "copy b.radius 1f..9f to 9f shift 2deg", "create d sphere radius=on", "move b.radius 1f..9f by 2deg"}) {
    const std::string head =
        "create b sphere\ncreate a{1..3} sphere\ncreate c{1..2} sphere\ncreate word text text=\"a\"\n"
        "at 1f b.radius 1\nat 1f a*.position (1 1 1)\n";
    const Loaded before = read(head + "policy ignore\n"), after = read(head + "policy ignore\n" + line + "\n");
    ASSERT_EQ(after.diagnostics.size(), 1u) << line << "\n" << said(after.diagnostics);
    EXPECT_TRUE(after.diagnostics[0].severity == Severity::warning) << line << "\n" << said(after.diagnostics);
    EXPECT_TRUE(after.document == before.document) << line;
    EXPECT_EQ(all_told(read(head + line + "\n")).size(), 1u) << line;
  }
}

// What only looks at a note, or at its time, is told where it never comes.
// shows: G91
TEST(Settings, NotesBelongToTheRange) {
  EXPECT_EQ(LoadedFilm("create b sphere\nat 12f b.radius 2\nat 30f note \"last\"\n").loaded.document.frame_count(), 30);
  const Loaded cut = read("range 1f 20f\nat 12f note \"seen\"\nat 30f note \"never\"\n");
  ASSERT_EQ(cut.diagnostics.size(), 1u);
  EXPECT_EQ(cut.diagnostics[0].severity, Severity::notice);
  EXPECT_EQ(cut.diagnostics[0].what.message, "the note at 30f is outside the range from 1f to 20f, so it never shows");
}

}  // namespace
}  // namespace betwixt

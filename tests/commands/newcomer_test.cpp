// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the help for newcomers who use environments and display lists in a wrong way: the error, its place, and the
// line to write instead.
#include "support/loaded_film.h"

namespace betwixt {
namespace {

constexpr std::string_view newcomer_film = "animate spin every 1t by rotate(3deg, z)\ncreate ball sphere\n";

struct Slip {
  std::string line, told, hint;
};

TEST(Newcomer, Is_told_what_is_wrong_where_and_what_to_write) {
  const std::string lists = "make NAME makes a display list; objects need no start";
  const std::string rows = "rows are indented, below make NAME or edit NAME";
  const std::string narrow = "the angle of view of a camera must be less than 180deg";
  const Slip table[] = {
      {"couple ball to spin", "type 3:16 spin", "to put an object into it: set ball.environments (spin)"},
      {"start ball", "name 3:7 ball", lists},
      {"edit spin", "name 3:6 spin", lists},
      {"create spin box", "name 3:8 spin", "objects, environments and layers cannot share a name"},
      {"set ball.transform rotate 90deg z", "syntax 3:27 90deg", "as in rotate(90deg, z)"},
      {"set ball.transform translate 1 0 0", "syntax 3:30 1", "as in translate(1 0 0)"},
      {"halt spni", "name 3:6 spni", "did you mean 'spin'?"},
      {"set ball.count 3", "name 3:10 count", ""},
      {"set spin.radius 3", "name 3:10 radius", ""},
      {"point (0 0)", "name 3:1 point", rows},
      {"call star", "name 3:1 call", rows},
      {"make a\n  circle (0 0) 2", "name 4:3 circle",
       "drawing rows are point, vector, polygon, text and call; for all rows: help make"},
      {"make a\nmake b\n  a", "name 5:3 a", "to draw that list: call a"},
      {"make a\n  polygn (0 0)", "name 4:3 polygn", "did you mean 'polygon'?"},
      {"make a\n  perspective 200deg", "range 4:15 200deg", narrow},
      {"create eye camera fov=200deg", "range 3:23 200deg", narrow},
  };
  for (const auto& [line, told, hint] : table) {
    const Loaded loaded = read(std::string(newcomer_film) + line + "\n");
    EXPECT_EQ(all_told(loaded), std::vector<std::string>{told}) << line;
    ASSERT_FALSE(loaded.diagnostics.empty());
    EXPECT_EQ(loaded.diagnostics[0].what.hint, hint) << line;
  }
}

TEST(Newcomer, A_scale_of_nothing_is_pointed_out) {
  for (const char* line :
       {"animate e every 1t by translate(1 0 0) scale(0)", "make a\n  multiply translate(1 0 0) scale(0)",
        "set ball.transform translate(1 0 0) scale(0 0 0)"}) {
    const Loaded loaded = read(std::string(newcomer_film) + line + "\n");
    ASSERT_EQ(loaded.diagnostics.size(), 1u) << line;
    const Diagnostic& d = loaded.diagnostics[0];
    EXPECT_EQ(d.severity, Severity::warning);
    EXPECT_EQ(d.what.message, "a scale of 0 shrinks everything to a point, so nothing is visible");
    EXPECT_EQ(d.line.substr(static_cast<std::size_t>(d.what.place.column) - 1, 7), "scale(0");
  }
  EXPECT_TRUE(read(std::string(newcomer_film) + "set ball.transform scale(1 0 1)\n").diagnostics.empty());  // a shadow
}

// Words that are tried as kinds and as commands say what there is.
TEST(Newcomer, Words_from_elsewhere_lead_to_what_there_is) {
  for (const auto& [word, leads] : {std::pair{"image", "texture=\"photo.png\""},
                                    {"movie", "create clip video file="},
                                    {"svg", "create logo scene file=\"logo.svg\""},
                                    {"particles", "create p{1..200} sphere"},
                                    {"caption", "create caption text"},
                                    {"graph", "curve points="},
                                    {"transition", "look through eye2"},
                                    {"hdri", "sky"},
                                    {"wait", "times are absolute"}})
    for (const std::string& line : {fmt::format("create x {}", word), std::string(word) + " 2s"}) {
      const Loaded loaded = read(line + "\n");
      ASSERT_EQ(loaded.diagnostics.size(), 1u) << line;
      EXPECT_NE(loaded.diagnostics[0].what.hint.find(leads), std::string::npos) << to_string(loaded.diagnostics[0]);
    }
}

// What a refused line would have made is not missed again, by a pattern either.
TEST(Newcomer, What_follows_from_a_refused_line_is_not_said) {
  const Loaded loaded = read(
      "create d{1..3} box position=(1 0 q)\nset d*.position (1 2 3)\nshow d{1..3}\nat 2f hide d2\nset d2.size (1 1 1)\n"
      "d?.position\n  1f (0 0 0)\ncouple d* to d1\nset e*.position (1 2 3)\n");
  EXPECT_EQ(errors(loaded), std::vector<std::string>{"1:34: 'q' is not a number"});
  ASSERT_EQ(loaded.diagnostics.size(), 2u) << said(loaded.diagnostics);
  EXPECT_EQ(loaded.diagnostics[1].what.message, "nothing is named 'e*'");
}

// What `let` would have named stands where a number, a time, a colour or a text does.
TEST(Newcomer, What_follows_from_a_refused_let_is_not_said) {
  const std::string first = "let q = 3 +\ncreate a box\n";
  for (const char* line :
       {"set a.position (2*q 0 0)", "set a.position.x q", "set a.color q", "set a.rotation axis(y q)",
        "set a.display q", "at q a.position (1 2 3)", "at 1f+q a.position (1 2 3)",
        "a.position\n  1f+q (1 2 3)\n  2f q\n", "range 1f q", "create t text text=q", "create u box size=(q[1] 1 1)",
        "let z = q+1", "let again q = 4", "set a.material q", "animate e every q by rotate(1deg z)",
        "set a.scale.x sqrt(q)", "set a.position (1 q/2 2)"})
    EXPECT_EQ(all_told(read(first + line + "\n")), std::vector<std::string>{"syntax 1:11 +"}) << line;
  EXPECT_EQ(all_told(read(first + "set a.position.x r\n")).size(), 2u);  // another word is still wrong
  EXPECT_EQ(all_told(read("let q = 3 +\nlet q = 3\ncreate a box\nset a.display q\n")).size(), 2u);  // it is there now
}

// A scene, a split text and a file that is used make many names.
TEST(Newcomer, What_a_refused_line_would_have_made_in_bulk_is_not_missed) {
  for (const auto& [line, missing] :
       {std::pair{"create man scene file=\"none.glb\"",
                  "set man/leg.color red\ncouple man/arm to man/body\nset man/*.color red\ncreate b like man/a/b"},
        {"split a into lettrs", "set a/1.color red\na/*.position\n  1f (0 0 0)\nat 2f hide a/2"},
        {"use none.bx", "set leg.color red\nb*.position\n  1f (0 0 0)\nset a.heat 3\ncouple a to leg"}}) {
    const Loaded loaded = read("create a text text=\"word\"\n" + std::string(line) + "\n" + missing + "\n");
    EXPECT_EQ(loaded.diagnostics.size(), 1u) << said(loaded.diagnostics);
  }
  EXPECT_EQ(all_told(read("create man scene file=\"none.glb\"\nset woman/leg.color red\n")).size(), 2u);
  EXPECT_EQ(all_told(read("use none.bx\ncreate b box size=oops\n")).size(), 2u);
}

TEST(Newcomer, What_can_be_asked_for_has_no_parts) {
  const Loaded loaded = read(newcomer_film);
  const std::tuple<const char*, const char*, const char*> table[] = {
      {"spin.world.w", "name spin.world", "its position is spin.world.x, .y and .z"},
      {"ball.world.w", "name ball.world", "its position is ball.world.x, .y and .z"},
      {"spin.by.x", "name spin.by", "spin.by is a matrix, row by row"},
      {"spin.count.x", "name spin.count", "read spin.count"},
  };
  for (const auto& [target, wrong, hint] : table) {
    const auto found = find_targets(target, loaded.document);
    ASSERT_FALSE(found) << target;
    EXPECT_EQ(told(found), wrong);
    EXPECT_EQ(found.error().hint, hint);
  }
  EXPECT_EQ(find_targets("spin.world.w", loaded.document).error().message, "'spin.world' has no part 'w'");
}

TEST(Newcomer, Touching_nobody_is_said_with_who_may_be_meant) {
  const LoadedFilm s(std::string(newcomer_film) + "create eye disc\nset eye.radius = \"#touching('bal')\"\n");
  const std::vector<std::string> problems = s.frame("1f").problems;
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("eye.radius: ")) << problems[0];
  EXPECT_NE(problems[0].find("\"#touching('bal')\""), std::string::npos) << problems[0];
  EXPECT_TRUE(problems[0].ends_with("; did you mean 'ball'?")) << problems[0];
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests patterns on both sides of a command, lists, and numbers in texts. Each film must equal the film of the lines
// written one by one.
#include <fmt/format.h>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

// Both make the same film, without a word.
void expect_same(const std::string& before, const std::string& in_short, const std::string& written_out) {
  const Loaded a = read(before + in_short), b = read(before + written_out);
  EXPECT_EQ(told(a), "") << in_short;
  EXPECT_EQ(told(b), "") << written_out;
  EXPECT_EQ(write(a.document), write(b.document)) << in_short;
}

TEST(OneForOne, WhatThingsHangOn) {
  std::string out;
  for (int i = 2; i <= 60; ++i) out += fmt::format("hang arm{} on arm{}\n", i, i - 1);
  for (const char* said : {"hang arm{2..60} on arm{1..59}\n", "hang arm{2..60} on arm{i}\n"})
    expect_same("create arm{1..60} box\n", said, out);
  expect_same("create {a,b} box\ncreate {x,y} box\n", "at 5f attach {a,b} to {y,x} keep-world\n",
              "at 5f attach a to y keep-world\nat 5f attach b to x keep-world\n");
  expect_same("create c{1..3} box\n", "couple c{1..2} to c{n+1}\n", "couple c1 to c3\ncouple c2 to c3\n");
}

TEST(OneForOne, WhateverTakesOneName) {
  const std::string two = "create sun{1..2} sphere\ncreate road{1..2} curve points=((0 0) (1 1))\n";
  expect_same(two, "create t{1..2} trace of=sun{i}\n", "create t1 trace of=sun1\ncreate t2 trace of=sun2\n");
  expect_same(two, "create c{1..2} camera look-at=sun{n-i+1}\n",
              "create c1 camera look-at=sun2\ncreate c2 camera look-at=sun1\n");
  expect_same(two, "create d{1..2} like sun{i}\n", "create d1 like sun1\ncreate d2 like sun2\n");
  expect_same(two + "create b{1..2} box\n", "at 1f..9f b{1..2}.position along road{2,1}\n",
              "at 1f..9f b1.position along road2\nat 1f..9f b2.position along road1\n");
  expect_same(two + "create b{1..2} box\n", "at 1f..9f b*.motion R(1turn @ sun{i})\n",
              "at 1f..9f b1.motion R(1turn @ sun1)\nat 1f..9f b2.motion R(1turn @ sun2)\n");
  expect_same(two + "create b{1..2} box\n", "b*.geometry\n  1f shape(sun{1..2})\n  9f shape(road{i})\n",
              "b1.geometry\n  1f shape(sun1)\n  9f shape(road1)\nb2.geometry\n  1f shape(sun2)\n  9f shape(road2)\n");
  expect_same(two + "animate wind{1..2} every 1t by rotate(1deg, z)\n", "set sun{1..2}.environments (wind{i})\n",
              "set sun1.environments (wind1)\nset sun2.environments (wind2)\n");
}

TEST(OneForOne, WhatIsWrongIsSaid) {
  const std::string four = "create a{1..4} box\n";
  EXPECT_EQ(told(read(four + "hang a{2..4} on a{1..2}\n")), "range 2:17 a{1..2}");
  EXPECT_EQ(told(read(four + "hang a{2..4} on a{i/2}\n")), "range 2:17 a{i/2}");
  EXPECT_EQ(told(read(four + "hang a{2..4} on a{i*1deg}\n")), "type 2:17 a{i*1deg}");
  EXPECT_EQ(told(read(four + "hang a{2..4} on a{i+}\n")), "syntax 2:17 a{i+}");
  EXPECT_EQ(told(read(four + "hang a{2..4} on a{i+3}\n")), "name 2:17 a{i+3}");
  EXPECT_TRUE(mentions(read(four + "hang a{2..4} on a{i+3}\n"), "a5"));
  EXPECT_EQ(told(read(four + "hang a1 on a{2..4}\n")), "range 2:12 a{2..4}");
  // All or nothing.
  EXPECT_EQ(write(read(four + "hang a{2..4} on a{i+2}\n").document), write(read(four).document));
}

// Braces that stood for many before still do.
TEST(OneForOne, PatternsElsewhereAreWhatTheyWere) {
  const std::string two = "create {a,b} sphere\ncreate {c,d} sphere\nat 1f {a,b}.radius 2\nat 9f {a,b}.radius i\n";
  expect_same(two, "copy {a,b}.radius 1f..9f to 1f on {c,d}.radius\n",
              "copy a.radius 1f..9f to 1f on c.radius\ncopy b.radius 1f..9f to 1f on d.radius\n");
  expect_same(two, "alias all = {a,b} {c,d}\nset all.radius 3\n", "alias all = {a,b} {c,d}\nset {a,b,c,d}.radius 3\n");
  expect_same(two, "stagger {a,b}.radius by 2f # {c,d}\n", "stagger {a,b}.radius by 2f\n");
}

TEST(Lists, AreIndexed) {
  const std::string h = "let h = (3 1 4 1 5)\n";
  expect_same(h, "create b{1..5} sphere radius=h[i]\n",
              "create b1 sphere radius=3\ncreate b2 sphere radius=1\ncreate b3 sphere radius=4\n"
              "create b4 sphere radius=1\ncreate b5 sphere radius=5\n");
  expect_same(h, "create b sphere radius=h[2]+2*h[h[2]+2] position=(h[1] -h[3] h[ 4 + 1 ])\n",
              "create b sphere radius=9 position=(3 -4 5)\n");
  expect_same("let c = (gold red #00f)\nlet p = ((0 0) (1 2 3))\n",
              "create b{1..2} sphere color=c[i+1] position=p[i]\nset b1.radius p[2].z\n",
              "create b1 sphere color=red position=(0 0 0) radius=3\ncreate b2 sphere color=#00f position=(1 2 3)\n");
  expect_same("let w = (\"Ann\" \"Bob\")\nlet a = (10deg 1turn)\nlet t = (1f 9f 2s)\n",
              "create b{1..2} text text=w[i] rotation=(0 0 a[i])\nat t[2] b1.size 2\nat t[3] b1.size 3\n",
              "create b1 text text=\"Ann\" rotation=(0 0 10deg)\ncreate b2 text text=\"Bob\" rotation=(0 0 1turn)\n"
              "at 9f b1.size 2\nat 2s b1.size 3\n");
  // A vector's numbers, and a list that begins anew.
  expect_same("let v = (7 8)\n" + h, "create b{1..6} sphere radius=h[(i-1)%5+1]+v[1]\n",
              "create b1 sphere radius=10\ncreate b2 sphere radius=8\ncreate b3 sphere radius=11\n"
              "create b4 sphere radius=8\ncreate b5 sphere radius=12\ncreate b6 sphere radius=10\n");
}

TEST(Lists, AreTablesInCode) {
  const LoadedFilm f(
      "let h = (3 1 4 1)\nlet w = (\"a\\\"b\" \"c\")\ncreate b sphere\ncreate t text\n"
      "set b.radius = \"h[1] + #h\"\nset t.text = \"w[1] .. w[2]\"\n");
  expect_numbers(f, "b.radius", "1f", {7});
  EXPECT_EQ(f.text("t.text", "1f"), "a\"bc");
}

TEST(Lists, WhatIsWrongIsSaid) {
  const std::string h = "let h = (3 1 4 1 5)\ncreate b sphere\n";
  const std::pair<const char*, const char*> cases[] = {
      {"set b.radius h[6]", "range 3:15 [6]"},
      {"set b.radius h[0]", "range 3:15 [0]"},
      {"set b.radius h[1.5]", "range 3:15 [1.5]"},
      {"set b.radius h[1deg]", "type 3:15 [1deg]"},
      {"set b.radius h", "type 3:14 h"},
      {"set b.radius h[2", "syntax 3:17"},
      {"let k = 3\nset b.radius k[1]", "type 4:14 k"},
      {"let e1 = ()", "syntax 3:10 ()"},
      {"let q = (1 2 nix)", "name 3:14 nix"},
      {"set b.color h[1]", "name"},
  };
  for (const auto& [line, wrong] : cases) {
    const std::string said = told(read(h + line + "\n"));
    EXPECT_EQ(said.substr(0, std::string_view(wrong).size()), wrong) << line;
  }
}

TEST(Lists, AreWrittenAsTheyRead) {
  const std::string film = "let h = (3 1 4 1 5)\nlet m = (gold \"x y\" (1 2 3) 10deg 2m 4f)\nlet one = (\"a\")\n";
  const Loaded l = read(film);
  EXPECT_EQ(told(l), "");
  EXPECT_TRUE(read(write(l.document)).document == l.document) << write(l.document);
}

TEST(NumbersAsTexts, AreTheirDigits) {
  expect_same("", "create t{1..3} text text=i\n",
              "create t1 text text=\"1\"\ncreate t2 text text=\"2\"\ncreate t3 text text=\"3\"\n");
  expect_same("let k = 0.5\ncreate t text\n", "at 3f t.text 2*k+1\nat 5f t.text -7\nset t.text k\n",
              "at 3f t.text \"2\"\nat 5f t.text \"-7\"\nset t.text \"0.5\"\n");
  EXPECT_EQ(told(read("create t text text=2s+1s\n")), "type 1:20 2s+1s");
  EXPECT_EQ(told(read("create t text text=hello\n")), "syntax 1:20 hello");
}

// What the words say elsewhere: relatives of one kind.
TEST(CopyShift, LeavesOutWhatItDoesNotFit) {
  const std::string film = "create b sphere\nat 1f b.position (1 2 3)\nat 1f b.radius 2\nat 1f b.color red\n";
  const Loaded l = read(film + "copy b.{position,radius} 1f..1f to 9f shift (1 1 1)\n");
  EXPECT_EQ(told(l), "");
  EXPECT_TRUE(mentions(l, "b.radius"));
  EXPECT_EQ(write(l.document), write(read(film + "at 9f b.position (2 3 4)\n").document));
  EXPECT_EQ(told(read(film + "copy b.{position,radius} 1f..1f to 9f shift on\n")).substr(0, 4), "type");
}

// Code says all of a position: a fall, or a row of one component, would have changed what it was before.
TEST(CodeOfTheWhole, IsNotSplit) {
  const std::string rows = "create b sphere\nb.position\n  1f = \"vec(t, 5, 0)\"\n  25f (1 5 0)\n";
  EXPECT_EQ(told(read(rows + "at 25f fall b\n")), "type 5:13 b");
  EXPECT_EQ(told(read("create b sphere\nset b.position = \"vec(t, 5, 0)\"\nat 25f fall b\n")), "type 3:13 b");
  EXPECT_EQ(told(read(rows + "at 30f b.position.y 2\n")).substr(0, 4), "type");
  EXPECT_EQ(told(read(rows + "bake b.position 1f..25f\nat 25f fall b\n")), "");
}

// A velocity that jumps within a segment is the one that is written as several which hold.
TEST(WanderingAxis, JumpsInTheVelocityAreNoJumpsInTheTurn) {
  const std::string b = "rate 24\ncreate b box\nat 1f b.rotation axis(x, 0deg)\nb.rotation.velocity\n";
  const LoadedFilm steps(b + "  1f axis(x, 90deg) steps(2)\n  25f axis(y, 90deg) hold\n  49f release\n");
  const LoadedFilm holds(b +
                         "  1f axis(x, 90deg) hold\n  13f spin(45deg 45deg 0deg) hold\n  25f axis(y, 90deg) hold\n" +
                         "  49f release\n");
  for (const char* t : {"7f", "12.9f", "13f", "13.01f", "13.2f", "13.5f", "14f", "20f", "25f", "40f"})
    expect_numbers(steps, "b.rotation", t, holds.numbers("b.rotation", t), 1e-7);
}

}  // namespace
}  // namespace betwixt

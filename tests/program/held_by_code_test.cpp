// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares attachments that Lua code makes with the same attachments in event rows.
#include "betwixt/object.h"
#include "betwixt/pose.h"
#include "scene/document.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

// Two hands that move, turn and are stretched, and a ball with a hat.
const std::string hands =
    "rate 24\nrange 1f 49f\ncreate left box\ncreate right box scale=(2 1 1)\ncreate ball sphere position=(1 0 0)\n"
    "create hat box position=(0 1 0)\ncouple hat to ball\n"
    "left.position\n  1f (0 0 0)\n  49f (8 0 0)\nright.position\n  1f (0 5 0) linear\n  49f (8 5 3)\n"
    "right.rotation\n  1f (0 0 0)\n  49f (90deg 0 45deg)\n";

void expect_same(const LoadedFilm& a, const LoadedFilm& b) {
  for (int n = 49; n >= 1; n -= 3) {
    const std::string time = std::to_string(n) + "f";
    const Frame x = a.frame(time), y = b.frame(time);
    ASSERT_TRUE(x.problems.empty()) << x.problems[0];
    ASSERT_EQ(x.items.size(), y.items.size());
    for (std::size_t i = 0; i < x.items.size(); ++i) {
      EXPECT_EQ(x.items[i].world.m, y.items[i].world.m) << time << ", item " << i;
      EXPECT_EQ(x.items[i].body, y.items[i].body) << time << ", item " << i;
    }
    for (const char* name : {"ball", "hat"}) {
      const auto at = parse_time(time, a.loaded.document);
      EXPECT_EQ(a.read(std::string(name) + ".world", time), b.read(std::string(name) + ".world", time));
      const Pose p = pose(a.program, a.loaded.document.find(name), *at),
                 q = pose(b.program, b.loaded.document.find(name), *at);
      EXPECT_EQ(p.parent, q.parent);
      EXPECT_EQ(p.attachment, q.attachment);
    }
  }
}

}  // namespace

// shows: G15
TEST(HeldByCode, TheSameFilmInRows) {
  const LoadedFilm rows(
      hands +
      "attach ball to left\nball.attachment\n  13f couple to right\n  25f detach\n  31f hang on left\n"
      "  40f attach to left keep-world\n  45f letgo\n");
  expect_same(LoadedFilm(hands + "set ball.attachment = \"frame < 13 and 'left' or frame < 25 and couple('right') or "
                                 "frame < 31 and 'none' or hang('left')\"\nball.attachment\n  40f attach to left "
                                 "keep-world\n  45f letgo\n"),
              rows);
  // A row of its own, false for nothing; what is kept and let go is what it was just before.
  expect_same(LoadedFilm(hands + "attach ball to left\nball.attachment\n  13f = \"frame < 25 and couple('right')\"\n"
                                 "  31f = \"hang('left')\"\n  40f attach to left keep-world\n  45f letgo\n"),
              rows);
  const LoadedFilm held(hands + "attach ball to left\nball.attachment\n  20f letgo\n"),
      by_code(hands + "set ball.attachment = \"attach('left')\"\nat 20f letgo ball\n");
  expect_same(by_code, held);
}

TEST(HeldByCode, AnyOrderOfSeeksGivesTheSameBits) {
  const LoadedFilm s(hands + "set ball.attachment = \"floor(frame / 5) % 2 == 0 and 'left' or couple('right')\"\n");
  const Program other = Program::compile(s.loaded.document);
  for (int n = 1; n <= 49; n += 7) {
    const Time t = *parse_time(std::to_string(n) + "f", s.loaded.document);
    const Frame forth = s.program.frame(t),
                back = other.frame(*parse_time(std::to_string(50 - n) + "f", s.loaded.document));
    const Frame again = other.frame(t);
    for (std::size_t i = 0; i < forth.items.size(); ++i) EXPECT_EQ(forth.items[i].world.m, again.items[i].world.m) << n;
  }
}

// Code looks at where things are: whoever is nearer holds the ball.
TEST(HeldByCode, ItAsksWhereThingsAre) {
  const LoadedFilm s(
      "rate 24\ncreate a group position=(0 0 0)\ncreate b group position=(10 0 0)\ncreate goal group\n"
      "goal.position\n  1f (0 0 0) linear\n  25f (10 0 0)\ncreate ball sphere\n"
      "set ball.attachment = \"value('goal.world.x') < 5 and 'a' or 'b'\"\n");
  expect_places(s, "ball", {{"1f", {0, 0, 0}}, {"12f", {0, 0, 0}}, {"14f", {10, 0, 0}}});
}

TEST(HeldByCode, ACircleIsNamedAndTheFrameComes) {
  const std::string head = "rate 24\ncreate a box position=(1 0 0)\ncreate b box position=(2 0 0)\n";
  {
    const LoadedFilm s(head + "attach b to a\nset a.attachment = \"frame > 10 and 'b'\"\n");
    EXPECT_TRUE(s.frame("10f").problems.empty());
    const Frame f = s.frame("11f");
    ASSERT_EQ(f.problems.size(), 1u);
    EXPECT_EQ(f.problems[0], "a.attachment: its code would make a cycle, a → b → a, so the object has no parent");
    ASSERT_EQ(f.reports.size(), 1u);
    EXPECT_EQ(f.reports[0].subject, "a.attachment");
    EXPECT_EQ(f.reports[0].source, "frame > 10 and 'b'");
    EXPECT_EQ(translation_of(f.items[1].world).x, 3);  // b hangs on a, and a on nothing
    expect_place(s, "b", "11f", {3, 0, 0});
    EXPECT_EQ(s.frame("11f").problems.size(), 1u);  // asked twice, said twice
    EXPECT_TRUE(s.frame("5f").problems.empty());
  }
  {  // Both are code's: both are free, and so is nobody who only hangs on one of them.
    const LoadedFilm s(head +
                       "create c box position=(4 0 0)\nset a.attachment = \"'b'\"\nset b.attachment = \"'a'\"\n"
                       "set c.attachment = \"'a'\"\n");
    const Frame f = s.frame("1f");
    EXPECT_EQ(f.problems.size(), 2u);
    for (const auto& [name, x] : {std::pair("a", 1), std::pair("b", 2), std::pair("c", 5)})
      expect_place(s, name, "1f", {static_cast<double>(x), 0, 0});
    EXPECT_EQ(translation_of(f.items[2].world).x, 5);
  }
  {
    const LoadedFilm s(head + "set a.attachment = \"self\"\n");
    EXPECT_NE(s.frame("1f").problems[0].find(", a → a,"), std::string::npos) << s.frame("1f").problems[0];
  }
  {  // Where it is says what holds it says where it is.
    const LoadedFilm s(head + "set a.attachment = \"value('a.world.x') > 0 and 'b'\"\n");
    EXPECT_TRUE(s.frame("1f").problems[0].starts_with("a.attachment ")) << s.frame("1f").problems[0];
    expect_place(s, "a", "1f", {3, 0, 0});
  }
}

TEST(HeldByCode, WhatIsWrongIsSaidAndTheFrameComes) {
  const std::string head = "rate 24\ncreate a box position=(1 0 0)\ncreate b box position=(2 0 0)\nlayer sway add\n";
  for (const auto& [code, why] : std::initializer_list<std::pair<std::string, const char*>>{
           {"'nobody'", "'nobody'"},
           {"couple('nobody')", "'nobody'"},
           {"'sway'", "'sway' has no position, so it cannot be a parent"},
           {"3", "it must return the name of the parent, \"none\" or false"},
           {"true", "\"none\" or false"},
           {"vec(1, 2, 3)", "\"none\" or false"},
           {"nil", "value"},
           {"hang(nil)", "bad argument #1 to 'hang' (string expected, got nil)"}}) {
    // Beside the last plain row: b coupled to a, by code something else.
    const LoadedFilm s(head + "b.attachment\n  1f couple to a\n  9f = \"" + code + "\"\n");
    EXPECT_TRUE(s.frame("8f").problems.empty());
    const Frame f = s.frame("9f");
    ASSERT_EQ(f.problems.size(), 1u) << code;
    EXPECT_TRUE(f.problems[0].starts_with("b.attachment: ")) << f.problems[0];
    EXPECT_NE(f.problems[0].find("\"" + code + "\""), std::string::npos) << f.problems[0];
    EXPECT_NE(f.problems[0].find(why), std::string::npos) << f.problems[0];
    expect_place(s, "b", "9f", {3, 0, 0});
  }
  for (const auto& [line, words] : std::initializer_list<std::pair<const char*, const char*>>{
           {"on sway set b.attachment = \"'a'\"", "type 5:28 \"'a'\""},
           {"at 5f on sway b.attachment = \"'a'\"", "type 5:30 \"'a'\""},
           {"set b.attachment = 'a'", "syntax 5:20 'a'"},
           {"set b.attachment 'a'", "type 5:5 b.attachment"},
           {"extend b.attachment cycle", "type 5:21 cycle"},
           {"create c box attachment=\"'a'\"", "type 5:25 \""}})
    EXPECT_EQ(told(head + line + "\n"), words) << line;
}

TEST(HeldByCode, IsWrittenCopiedRenamedAndBaked) {
  const std::string film = hands + "set ball.attachment = \"frame < 13 and 'left' or couple('right')\"\n";
  const Document d = read(film).document;
  EXPECT_EQ(read(write(d)).document, d) << write(d);
  const LoadedFilm was(film);
  // What stands in quotes follows a name; what is put together from pieces does not.
  const LoadedFilm renamed(film + "rename left hand\n");
  EXPECT_TRUE(renamed.frame("1f").problems.empty());
  EXPECT_EQ(place(renamed, "ball", "5f").x, place(was, "ball", "5f").x);
  const LoadedFilm pieces(hands + "set ball.attachment = \"'le' .. 'ft'\"\nrename left hand\n");
  EXPECT_NE(pieces.frame("1f").problems[0].find("'left'"), std::string::npos);
  // A whole that is copied holds its own.
  const LoadedFilm whole(
      "rate 24\ncreate man group\ncreate man/hand group\ncreate man/cup box position=(1 0 0)\n"
      "set man/cup.attachment = \"'man/hand'\"\ncreate bert like man position=(0 3 0)\n");
  expect_place(whole, "bert/cup", "1f", {1, 3, 0});
  // Rows again: what code said at each frame.
  const LoadedFilm baked(film + "bake ball.attachment 1f..49f\n");
  expect_same(baked, was);
  EXPECT_EQ(write(baked.loaded.document).find("= \"frame"), std::string::npos);
  EXPECT_EQ(attachments(baked.loaded.document, baked.loaded.document.find("ball")).size(),
            4u);  // nothing at first, left, right, the last frame
  EXPECT_EQ(told(film + "at 20f letgo ball\nbake ball.attachment 1f..49f\n"), "type 19:6 ball.attachment");
}

TEST(HeldByCode, OthersKnowOfIt) {
  // What is removed is nobody; what is laid out takes along what code has hang on it; what falls is caught.
  const LoadedFilm gone(hands + "set ball.attachment = \"'left'\"\nremove left\n");
  EXPECT_NE(gone.frame("1f").problems[0].find("'left'"), std::string::npos);
  const LoadedFilm row(
      "create a box\ncreate b box\ncreate flag box position=(0 1 0) size=(3 1 1)\nset flag.attachment = \"'a'\"\n"
      "arrange {a,b} in row gap=0\n");
  EXPECT_NEAR(place(row, "b", "1f").x - place(row, "a", "1f").x, 2, 1e-12);  // 3/2 + 1/2
  const Loaded falls =
      read("rate 24\ncreate a box\ncreate b box position=(0 5 0)\nat 1f fall b\nb.attachment\n  9f = \"'a'\"\n");
  EXPECT_NE(said(falls.diagnostics).find("the fall of b now ends at 9f"), std::string::npos);
  // A hand that code hangs on its arm reaches as one that is coupled.
  const std::string arm =
      "create upper box\ncreate fore box position=(1 0 0)\ncreate palm sphere position=(1 0 0)\ncouple fore to upper\n";
  const LoadedFilm coupled(arm + "couple palm to fore\nreach palm to (1 1 0)\n"),
      computed(arm + "set palm.attachment = \"couple('fore')\"\nreach palm to (1 1 0)\n");
  for (const char* name : {"upper", "fore", "palm"}) {
    const Vec3 there = place(coupled, name, "1f");
    expect_place(computed, name, "1f", there, 1e-12);
  }
  expect_place(computed, "palm", "1f", {1, 1, 0}, 1e-6);
}

}  // namespace betwixt

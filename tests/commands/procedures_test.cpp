// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compares procedures with closed forms, through the whole program.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "support/loaded_film.h"

namespace betwixt {
namespace {

// shows: G54 G55 R-T11
TEST(Procedures, ReadAnyTrackAtAnyTime) {
  const LoadedFilm s(
      "rate 24\ndefine n number\ncreate a sphere\ncreate b sphere\ncouple b to a\n"
      "a.position\n  1f (0 0 0) linear\n  49f (4 2 0)\nset b.position (0 0 1)\n"
      "at 1f b.radius = \"2 + value('a.position.x', t + 0.5)\"\n"
      "at 1f a.n = \"value('a.position.velocity').x + value('.position.y', 1)\"\n"
      "at 1f b.n = \"value('b.world')[4] + value('b.world')[12]\"\n"
      "at 1f b.position.y = \"0.5 * math.sin(tau * t)\"\n");
  expect_numbers(s, {{"b.radius", "1f", {3}},
                     {"b.radius", "25f", {5}},
                     {"b.radius", "45f", {6}},  // past the end
                     {"a.n", "13f", {3}},
                     {"b.n", "25f", {3}},  // x from a, z its own
                     {"b.position", "7f", {0, 0.5, 1}}});
  EXPECT_NEAR(translation_of(s.frame("7f").items[1].world).y, 0.5 + 0.25, 1e-12);
}

// shows: G54 G52
TEST(Procedures, WriteTextsAndStandAmongEvents) {
  const LoadedFilm s(
      "rate 24\ndefine n number\ncreate c text text=\"\"\ncreate a sphere\n"
      "at 1f c.text = \"string.format('%d of %s', math.floor(t * 24 + 1.5), self)\"\n"
      "a.n\n  1f 3 linear\n  25f = \"10 * t\"\n  49f 7 linear\n  73f = \"100 * t\"\n");
  EXPECT_EQ(s.text("c.text", "12f"), "12 of c");
  EXPECT_EQ(s.text("c.text", "30f"), "30 of c");
  expect_numbers(s, {{"a.n", "13f", {6.5}},  // towards what it says at its beginning: 10
                     {"a.n", "37f", {15}},
                     {"a.n", "49f", {7}},
                     {"a.n", "61f", {153.5}}});
}

// shows: G54
TEST(Procedures, StandWhereAValueIsSet) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\ncreate b sphere\nset a.radius = \"1 + t\"\nset b.position = \"vec(t, 2 * t, 3 * t)\"\n"
      "b.position.y\n  25f 7 linear\n  49f 9\n");
  expect_numbers(s, "a.radius", "25f", {2});
  expect_numbers(s, "b.position", "37f", {1.5, 8, 4.5});  // a component has events, the others have the procedure
}

// shows: G15 G17 G103 G105
TEST(Procedures, OfAllRolesAreUsedLikeWhatIsBuiltIn) {
  const LoadedFilm s(
      "rate 24\nprocedure twice lua \"local x = ... return 2 * x\"\nprocedure snap twerper lua \"u * u\"\n"
      "procedure lift filter lua \"input() + (by or 0) * t\"\n"
      "procedure row command lua \"for i = 1, 3 do run('create p' .. i .. ' sphere position=(' .. i .. ' 0 0)') end\"\n"
      "create a sphere\nrow\ndefine n number = \"twice(t)\"\n"
      "a.radius\n  1f 1 snap\n  25f 3\nfilter a.position lift by=0\nfilter a.scale.y lift by=2\n");
  expect_numbers(s, {{"a.radius", "13f", {1.5}},
                     {"p3.position", "1f", {3, 0, 0}},
                     {"p2.n", "13f", {1}},  // every object has it
                     {"a.scale", "13f", {1, 2, 1}}});
  // A command that fails does nothing at all.
  const auto bad =
      all_told(read("procedure row command lua \"run('create p sphere') run('create q nothing')\"\nrow\n"));
  EXPECT_EQ(bad, std::vector<std::string>{"type 2:1 row"});
  EXPECT_TRUE(
      mentions("procedure row command lua \"run('create p sphere') run('create q nothing')\"\nrow\n", "'nothing'"));
}

// shows: G55 R-T11
TEST(Procedures, CirclesAreCutTheSameWhateverIsAskedFirst) {
  const LoadedFilm s(
      "define n number\ncreate {a,b,c,d,e,f} sphere\n"
      "set a.n 1\nset b.n 2\nset c.n 3\nset d.n 4\nset e.n 5\nset f.n 6\n"
      "at 2f a.n = \"value('a.n') + 1\"\n"
      "at 2f b.n = \"value('c.n') + 10\"\nat 2f c.n = \"value('b.n') + 100\"\n"
      "at 2f d.n = \"value('e.n') + 10\"\nat 2f e.n = \"value('f.n') + 100\"\nat 2f f.n = \"value('d.n') + 1000\"\n");
  // Whoever is asked is where its circle is cut: there its last value without a procedure counts.
  const std::vector<std::pair<const char*, double>> wanted = {{"a.n", 2},    {"b.n", 112},  {"c.n", 113},
                                                              {"d.n", 1114}, {"e.n", 1115}, {"f.n", 1116}};
  std::vector<Target> targets;
  for (const auto& [name, v] : wanted) {
    expect_numbers(s, name, "10f", {v});
    targets.push_back(find_targets(name, s.loaded.document)->front());
  }
  std::vector<std::size_t> order{0, 1, 2, 3, 4, 5};
  do {
    std::vector<Target> asked;
    for (const std::size_t k : order) asked.push_back(targets[k]);
    std::vector<std::string> problems;
    const auto all = s.program.read(asked, *parse_time("10f", s.loaded.document), &problems);
    for (std::size_t k = 0; k < 6; ++k) ASSERT_EQ(numbers(all[k])[0], wanted[order[k]].second);
    EXPECT_EQ(problems.size(), 6U);
  } while (std::next_permutation(order.begin(), order.end()));
  const Frame f = s.frame("10f");
  EXPECT_NE(std::find(f.problems.begin(), f.problems.end(),
                      "a.n depends on itself: it uses its last value without code there"),
            f.problems.end());
}

// shows: G54 G1
TEST(Procedures, ThatErrOrNeverEndAreNamedAndTheFrameComes) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere radius=3\ncreate b sphere\na.radius\n  1f 4\n  5f = \"nothing.x\"\n"
      "at 1f b.scale = \"(function() while true do end end)()\"\nat 1f b.shininess = \"value('nobody.radius')\"\n"
      "at 1f b.transparency = \"0 / 0\"\nat 1f b.position = \"'up'\"\n");
  const Frame f = s.frame("10f");
  ASSERT_EQ(f.items.size(), 2U);
  EXPECT_EQ(f.items[0].shape->radius, 4);  // the last value that no procedure makes
  EXPECT_EQ(f.items[1].world, Mat4{});
  ASSERT_EQ(f.problems.size(), 5U);
  const auto said = [&](const char* of, const char* why) {
    return std::any_of(f.problems.begin(), f.problems.end(), [&](const std::string& p) {
      return p.starts_with(std::string(of) + ": the procedure \"") && p.find(why) != std::string::npos;
    });
  };
  EXPECT_TRUE(said("a.radius", "nothing"));
  EXPECT_TRUE(said("b.scale", "stopped: "));
  EXPECT_TRUE(said("b.shininess", "nobody"));
  EXPECT_TRUE(said("b.transparency", "finite")) << fmt::format("{}", fmt::join(f.problems, "\n"));
  EXPECT_TRUE(said("b.position", "not a text"));
  for (const std::string& p : f.problems) EXPECT_LT(p.size(), 300U) << p;
}

// shows: G17
TEST(Procedures, TwerpersThatErrOrNeverEndAreNamedAndLinear) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\nprocedure broken twerper lua \"nothing.x\"\n"
      "procedure endless twerper lua \"(function() while true do end end)()\"\n"
      "procedure wild twerper lua \"1 / 0\"\n"
      "a.radius\n  1f 2 broken\n  25f 4\na.position.x\n  1f 0 endless\n  25f 8\na.position.y\n  1f 0 wild\n  25f 8\n");
  const Frame f = s.frame("13f");
  EXPECT_EQ(f.items[0].shape->radius, 3);
  EXPECT_EQ(translation_of(f.items[0].world), (Vec3{4, 4, 0}));
  ASSERT_EQ(f.problems.size(), 3U) << fmt::format("{}", fmt::join(f.problems, "\n"));
  EXPECT_TRUE(f.problems[0].starts_with("the twerper 'broken' returned no number and is linear there: "))
      << f.problems[0];
  EXPECT_NE(f.problems[1].find("'endless'"), std::string::npos) << f.problems[1];
  EXPECT_NE(f.problems[1].find("1000000"), std::string::npos) << f.problems[1];
  EXPECT_NE(f.problems[2].find("'wild'"), std::string::npos) << f.problems[2];
  EXPECT_NE(f.problems[2].find("finite"), std::string::npos) << f.problems[2];
  std::vector<std::string> problems;
  s.program.read(std::vector{find_targets("a.radius", s.loaded.document)->front()},
                 *parse_time("13f", s.loaded.document), &problems);
  EXPECT_EQ(problems.size(), 1U);
  EXPECT_TRUE(s.frame("1f").problems.empty() || s.frame("1f").problems.size() <= 3U);
}

// shows: G54
TEST(Procedures, ThatCallEachOtherForEverAreNamedOnce) {
  for (const char* form :
       {"procedure ping lua \"pong()\"\nprocedure pong lua \"ping()\"\n",
        "procedure ping lua \"\"\"local x = 1\nreturn pong()\"\"\"\nprocedure pong lua \"ping()\"\n"}) {
    const LoadedFilm s(std::string("create a sphere\n") + form + "set a.radius = \"ping()\"\n");
    const Frame f = s.frame("1f");
    ASSERT_EQ(f.problems.size(), 1U);
    EXPECT_LT(f.problems[0].size(), 160U) << f.problems[0];
    EXPECT_NE(f.problems[0].find("ping: pong: "), std::string::npos) << f.problems[0];
  }
}

// shows: G55 R-T11
TEST(Procedures, WhatTheyReadIsTraced) {
  const LoadedFilm s(
      "define n number\ncreate a sphere\ncreate b sphere\ncreate c sphere\n"
      "at 1f a.n = \"value('b.n', t - 1) + value('c.position.velocity').x\"\nat 1f b.n = \"value('.world')[4]\"\n"
      "at 1f c.n = \"t < 1 and 0 or value('a.radius')\"\n");
  const auto traced = [&](const char* target, const char* time) {
    std::string out;
    for (const Target& t :
         s.program.reads(find_targets(target, s.loaded.document)->front(), *parse_time(time, s.loaded.document)))
      out += s.loaded.document.name(t) + " ";
    return out;
  };
  EXPECT_EQ(traced("a.n", "1f"), "b.n b.world c.position.velocity ");
  EXPECT_EQ(traced("c.n", "1f"), "");
  EXPECT_EQ(traced("c.n", "60f"), "a.radius ");
  EXPECT_EQ(traced("c.radius", "60f"), "");
}

// shows: G59
TEST(Procedures, RenamingReachesIntoThem) {
  const LoadedFilm s(
      "define n number = \"value('ball.radius')\"\ncreate ball sphere radius=3\ncreate balloon sphere radius=5\n"
      "create a sphere\nprocedure r lua \"return value(\\\"ball.radius\\\") + value('balloon.radius')\"\n"
      "at 1f a.radius = \"r() + value('ball.radius') \"\nset a.shininess = \"value('ball.radius') / 10\"\n"
      "at 1f a.position.x = \"value('ball.radius')\"\nrename ball moon\n");
  expect_numbers(
      s, {{"a.radius", "3f", {11}}, {"a.shininess", "3f", {0.3}}, {"a.n", "3f", {3}}, {"a.position.x", "3f", {3}}});
  EXPECT_TRUE(s.frame("3f").problems.empty());
  EXPECT_EQ(load_text(write(s.loaded.document), "w.bx").document, s.loaded.document);
}

// shows: G15
TEST(Procedures, DoNotTakeNamesThatLuaHas) {
  for (const char* name : {"value", "mix", "sin", "t", "end", "vec", "math"})
    EXPECT_EQ(all_told(read(fmt::format("procedure {} lua \"1\"\n", name))),
              std::vector<std::string>{fmt::format("name 1:11 {}", name)});
  EXPECT_EQ(all_told(read("procedure sine lua \"1\"\nprocedure exp twerper lua \"u\"\n")), std::vector<std::string>{});
}

// Only the same component at the same time is a circle.
TEST(Procedures, SiblingsAndEarlierTimesAreNoCircles) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\nat 1f a.position.x = \"t * 2\"\n"
      "at 1f a.position.y = \"value('.position.x') + 1\"\nat 1f a.position.z = \"value('.position.y') * 10\"\n"
      "create e sphere\nset e.radius = \"t <= 0 and 1 or value('.radius', t - 1) * 2\"\n"
      "create p sphere\ncreate q sphere\nset p.radius = \"t <= 0 and 3 or value('q.radius', t - 0.5)\"\n"
      "set q.radius = \"value('p.radius', t - 0.5) + 1\"\n");
  // At 49f, two seconds in: x = 4, y = 5, z = 50; doubled twice: 4; p from 3 by q's steps of a second each: 3 + 2.
  expect_numbers(s, {{"a.position", "49f", {4, 5, 50}}, {"e.radius", "49f", {4}}, {"p.radius", "49f", {5}}});
  EXPECT_TRUE(s.frame("49f").problems.empty()) << s.frame("49f").problems[0];
}

TEST(Procedures, AMemoryWithoutABeginningEnds) {
  const LoadedFilm s("create a sphere\nset a.radius = \"value('.radius', t - 0.001) + 1\"\n");
  const auto problems = s.frame("24f").problems;
  ASSERT_FALSE(problems.empty());
  EXPECT_EQ(problems[0],
            "a.radius reads its own past through more than 200 earlier times. Beyond them it uses its last value "
            "without code, so from here on the result is wrong: read the past in longer steps, or compute the value "
            "from t alone; to sum up changes, compute a.radius.velocity instead");
  const LoadedFilm word("create a text text=\"o\"\nset a.text = \"value('.text', t - 0.001)\"\n");
  EXPECT_EQ(word.frame("24f").problems[0].find("velocity"), std::string::npos);
}

TEST(Procedures, WhatIsDefinedForAllIsNothingWhereItMeansNothing) {
  const LoadedFilm s(
      "rate 24\ncreate a sphere\na.position\n  1f (0 0 0) linear\n  25f (3 4 0)\nlayer sway add\n"
      "animate wind every 1t by translate(0.1 0 0)\ncreate lamp light\n"
      "define speed number = \"length(value('.position.velocity'))\"\ndefine wide number = \"2 * value('.radius')\"\n");
  EXPECT_TRUE(s.frame("13f").problems.empty()) << s.frame("13f").problems[0];
  expect_numbers(s, {{"a.speed", "13f", {5}}, {"a.wide", "13f", {2}}, {"lamp.wide", "13f", {0}}});
  // What nothing has is a mistake everywhere.
  const LoadedFilm wrong("create a sphere\ndefine wide number = \"value('.radios')\"\n");
  EXPECT_EQ(wrong.frame("1f").problems.size(), 1u);
}

TEST(Procedures, WhatIsNeverSeenIsNeverAsked) {
  const LoadedFilm s("rate 24\ncreate a sphere\nset a.radius = \"1/0\"\na.radius\n  1f 1\n  24f 3\n");
  EXPECT_TRUE(s.frame("1f").problems.empty());
  EXPECT_TRUE(s.frame("12f").problems.empty());
  EXPECT_FALSE(s.frame("0f").problems.empty());
  // Nor what a cut or a hold keeps apart; but a neighbour is.
  const std::string rows = "rate 24\ncreate a sphere\na.radius\n  1f = \"1/0\" ";
  const LoadedFilm held(rows + "hold\n  13f 1 smooth\n  25f 2\n"), seen(rows + "smooth\n  13f 1 smooth\n  25f 2\n");
  EXPECT_TRUE(held.frame("19f").problems.empty());
  expect_numbers(held, "a.radius", "19f", {1.5});
  EXPECT_FALSE(seen.frame("19f").problems.empty());
}

}  // namespace
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests random films without code, in which objects rest, move, hide, and change looks and parents. An evaluation that
// visits times in any order must give the same as a new evaluation at each time.
#include <rapidcheck.h>

#include <random>
#include <thread>

#include "scene/functions.h"
#include "support/loaded_film.h"
#include "support/plain_film.h"

namespace betwixt {
namespace {

std::vector<Time> times_of(const Document& d, std::mt19937_64& random) {
  std::vector<Time> out;
  for (int k = 0; k < 40; ++k)
    out.push_back(*parse_time(fmt::format("{}f", 0.5 * static_cast<double>(random() % 160)), d));
  if (random() % 2) std::sort(out.begin(), out.end());
  if (random() % 4 == 0) std::reverse(out.begin(), out.end());
  return out;
}

Loaded plain_film(std::uint64_t seed) {
  return read(PlainFilm(seed).script());  // a line may be refused, where a motion is under way; the others count
}

TEST(Evaluation, GivesTheSameWhereverItWasBeforeAndSaysWhatChanged) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const Loaded l = plain_film(seed);
    std::mt19937_64 random(seed);
    const Program p = Program::compile(l.document);
    Evaluation e(p);
    std::vector<Seen> before;
    for (const Time t : times_of(l.document, random)) {
      if (random() % 8 == 0) {  // a new one that was prepared, at this time or another one
        e = Evaluation(p), before.clear();
        e.prepare(random() % 2 == 0 ? t : l.document.rate().frame(static_cast<double>(random() % 60)));
      }
      e.to(t);
      const std::vector<Seen> now = seen(e), alone = seen_alone(p, t);
      const std::string where = format_time(t, l.document) + "\n" + PlainFilm(seed).script();
      if (const auto wrong = differing(now, alone); !wrong.empty())
        RC_FAIL(fmt::format("{} differs at {}", l.document.name(e.drawables()[wrong[0]]), where));
      for (std::size_t i = 0; i < now.size(); ++i) {  // by another road: value by value
        const ObjectId id = e.drawables()[i];
        const auto number = [&](FunctionId f) { return std::get<double>(p.read({id, f}, t)); };
        if (p.read({id, Query::world}, t) != Value(Matrix(now[i].world)) ||
            std::get<bool>(p.read({id, fn::display}, t)) != now[i].look.visible ||
            (now[i].look.visible && number(fn::transparency) != now[i].look.transparency))
          RC_FAIL(fmt::format("{} is not as it is read at {}", l.document.name(id), where));
      }
      Evaluation other(p);
      other.to(t);
      if (!same_frame(e.frame(), other.frame()) || !same_frame(p.frame(t), other.frame())) RC_FAIL("frame at " + where);
      const std::vector<std::uint32_t> said(e.changed().begin(), e.changed().end());
      if (before.empty()) {
        RC_ASSERT(said.size() == now.size());
      } else if (said != differing(now, before)) {
        RC_FAIL("changed at " + where);
      }
      before = now;
    }
  }));
}

TEST(Evaluation, OfFourThreadsEachHasItsOwn) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const Loaded l = plain_film(seed);
    const Program p = Program::compile(l.document);
    std::array<int, 4> wrong{};
    const auto play = [&](std::size_t who) {
      std::mt19937_64 random(seed * 4 + who);
      Evaluation e(p);
      for (const Time t : times_of(l.document, random)) {
        e.to(t);
        wrong[who] += !differing(seen(e), seen_alone(p, t)).empty();
      }
    };
    std::vector<std::thread> threads;
    for (std::size_t who = 0; who < 4; ++who) threads.emplace_back(play, who);
    for (std::thread& t : threads) t.join();
    EXPECT_EQ(wrong, (std::array<int, 4>{})) << PlainFilm(seed).script();
  }
}

// shows: G87
TEST(Evaluation, GoesOnWithAnEditedProgram) {
  EXPECT_TRUE(rc::check([] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const Loaded one = plain_film(seed);
    const Loaded two = read(PlainFilm(seed).script() + "at 30f o1.position (1 2 3)\nset c.color teal\n");
    std::mt19937_64 random(seed);
    const Program a = Program::compile(one.document), b = Program::compile(two.document);
    Evaluation e(a);
    bool other = false;
    std::vector<Seen> before;
    for (const Time t : times_of(one.document, random)) {
      if (random() % 3 == 0) e.use((other = !other) ? b : a);
      e.to(t);
      const auto now = seen(e);
      RC_ASSERT(differing(now, seen_alone(other ? b : a, t)).empty());
      if (!before.empty())
        RC_ASSERT((std::vector<std::uint32_t>(e.changed().begin(), e.changed().end())) == differing(now, before));
      before = now;
    }
  }));
}

TEST(Evaluation, OtherDrawablesHaveAllChanged) {
  const LoadedFilm one("create a sphere\ncreate b box\n"), two("create a sphere\ncreate g group\ncreate c box\n");
  Evaluation e(one.program);
  e.to({});
  EXPECT_EQ(e.changed().size(), 2u);
  e.to({});
  EXPECT_EQ(e.changed().size(), 0u);
  e.use(one.program);
  e.to({});
  EXPECT_EQ(e.changed().size(), 0u);
  e.use(two.program);
  e.to({});
  EXPECT_EQ(e.changed().size(), 2u);
  EXPECT_EQ(two.loaded.document.name(e.drawables()[1]), "c");
}

// Who has missed a time sees it.
TEST(Evaluation, RevisionsCountTimesAndTellProgramsApart) {
  const LoadedFilm s("create a sphere\n");
  Evaluation e(s.program), f(s.program);
  const auto first = e.revision();
  EXPECT_NE(first.program, f.revision().program);
  e.to({}), e.to({}), e.to({1});
  EXPECT_EQ(e.revision().program, first.program);
  EXPECT_EQ(e.revision().times, first.times + 3);
  e.use(s.program);
  EXPECT_NE(e.revision().program, first.program);
  EXPECT_NE(e.revision().program, f.revision().program);
}

// What nobody sees is not worked out; that a twerper errs there is said all the same.
TEST(Evaluation, TwerpersThatErrAreNamedWhereverTheyStand) {
  const LoadedFilm s(
      "create b box\ndefine heat number\nprocedure bad twerper lua \"0 / 0\"\nb.heat\n  1f 0 bad\n  24f 1\n");
  ASSERT_EQ(s.frame("12f").problems.size(), 1u);
  EXPECT_NE(s.frame("12f").problems[0].find("'bad'"), std::string::npos);
  EXPECT_TRUE(s.frame("30f").problems.empty());
  EXPECT_EQ(s.frame("12f").problems.size(), 1u);
}

// What rests costs nothing to know: neither a still scene nor one in which others move names what rests.
TEST(Evaluation, WhatRestsIsNotNamed) {
  const LoadedFilm s(
      "create b{1..100} box\ncreate far sphere position=(0 0 -9)\nb7.position\n  10f (0 0 0) linear\n  20f (1 0 0)\n"
      "at 1f show b9\nat 30f hide b9\n");
  const auto at = [&](const char* t) { return *parse_time(t, s.loaded.document); };
  Evaluation e(s.program);
  const auto changed = [&](const char* t) {
    e.to(at(t));
    std::vector<std::string> names;
    for (const std::uint32_t i : e.changed()) names.push_back(s.loaded.document.name(e.drawables()[i]));
    return names;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(changed("1f").size(), 101u);
  EXPECT_EQ(changed("9f"), Names{});
  EXPECT_EQ(changed("15f"), Names{"b7"});
  EXPECT_EQ(changed("20f"), Names{"b7"});
  EXPECT_EQ(changed("29f"), Names{});
  EXPECT_EQ(changed("30f"), Names{"b9"});
  EXPECT_EQ(changed("40f"), Names{});
  EXPECT_EQ(changed("12f"), (Names{"b7", "b9"}));
  EXPECT_EQ(changed("3f"), Names{"b7"});
}

}  // namespace
}  // namespace betwixt

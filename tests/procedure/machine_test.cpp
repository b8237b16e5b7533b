// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The limits of a call, and that calls know nothing of one another.
#include <atomic>
#include <thread>

#include "procedure/routines.h"

namespace betwixt {
namespace {

// shows: G54
TEST(Lua, WhatNeverEndsIsStopped) {
  const std::string steps = "stopped: it took more than 1000000 steps", memory = "stopped: it took too much memory";
  EXPECT_EQ(error("while true do end"), steps);
  EXPECT_EQ(error("local function f() return f() end return f()"), steps);
  EXPECT_EQ(error("local s = 'x' while true do s = s .. s end"), memory);
  EXPECT_EQ(error("local s = '' while true do s = s .. 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxx' end"), memory);
  EXPECT_EQ(error("local t = {} while true do t[#t + 1] = ('x'):rep(1000) .. #t end"), memory);
  const std::string deep = error("local function f() return 1 + f() end return f()");
  EXPECT_TRUE(deep == memory || deep.starts_with("stack overflow")) << deep;
  EXPECT_EQ(error("while true do table.sort({3, 1, 2}) end"), steps);
  EXPECT_EQ(error("local t = {} for i = 1, 1000 do t[i] = 'x' end while true do table.concat(t) end"), steps);
  EXPECT_EQ(error("table.sort({3, 1, 2}, function(a, b) while true do end end)"), steps);
  EXPECT_EQ(error("table.move({}, 1, 1e9, 2)"), steps);
  EXPECT_EQ(error("local t = {} for i = 1, 1e9 do table.insert(t, 1, i) end"), steps);
  EXPECT_EQ(error("while true do local s = ('x'):rep(100000) end"), memory);
  EXPECT_EQ(error("('').rep('', 1e15)"), steps);
  EXPECT_EQ(error("('').rep('', 1e15, '')"), steps);
  EXPECT_EQ(error("local a, b = ('x'):rep(900000) .. 'a', ('x'):rep(900000) .. 'b' while a < b do end"), steps);
  EXPECT_EQ(error("local a, b = ('x'):rep(900000) .. 'a', ('x'):rep(900000) .. 'b' while a ~= b do end"), steps);
  EXPECT_EQ(number("#(('ab'):rep(3))"), 6);
  EXPECT_EQ(number("1 + 1"), 2) << "and life goes on";
  FakeQuestions q;
  q.procedures["slow"] = made(Role::value, "local s = 0 for i = 1, 100000 do s = s + i end return s");
  EXPECT_EQ(error("local s = 0 for i = 1, 100 do s = s + slow() end return s", q), steps) << "reads count";
  EXPECT_EQ(made(Role::twerper, "while true do end")->blend(0).error().message, steps);
  FakeInput in;
  EXPECT_EQ(made(Role::filter, "while true do input() end")->filter(in, 0, {}).error().message, steps);
  FakeHost host;
  EXPECT_EQ(made(Role::command, "while true do run('x') end")->command(host, {}).error().message, steps);
}

FakeQuestions chain(int length) {
  FakeQuestions q;
  q.procedures["p0"] = made(Role::value, "1");
  for (int i = 1; i <= length; ++i)
    q.procedures["p" + std::to_string(i)] = made(Role::value, "1 + value('p" + std::to_string(i - 1) + "')");
  return q;
}

// shows: G54 G55
TEST(Lua, TwoHundredDeep) {
  EXPECT_EQ(number("value('p200')", chain(200)), 201);
  EXPECT_EQ(error("value('p350')", chain(350)), "procedures read each other more than 300 deep");
  FakeQuestions q;
  q.procedures["again"] = made(Role::value, "again()");
  EXPECT_TRUE(error("again()", q).ends_with(error("value('p350')", chain(350))));
}

// shows: G54
TEST(Lua, PureInAnyOrderFromAnyThread) {
  const auto code = made(Role::value, "noise(t * 3, value('x')) * vec(sin(t), t ^ 0.3, random(t))");
  const auto other = made(Role::value, "local t2 = {} for i = 1, 50 do t2[i] = {i} end return #t2 + t");
  const auto one = [&](int i) {
    FakeQuestions q = at(i * 0.1);
    std::uint64_t cost = 0;
    const auto v = code->value(q, {}, cost);
    return std::pair(std::get<Vec3>(*v), cost);
  };
  std::vector<std::pair<Vec3, std::uint64_t>> straight;
  for (int i = 0; i < 500; ++i) straight.push_back(one(i));
  std::vector<std::thread> threads;
  std::atomic<int> wrong = 0;
  for (int k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      for (int j = 0; j < 500; ++j) {
        const int i = (j * 37 + k * 91) % 500;
        FakeQuestions q = at(i);
        std::uint64_t cost = 0;
        if (std::get<double>(*other->value(q, {}, cost)) != 50 + i) ++wrong;
        if (one(i) != straight[static_cast<std::size_t>(i)]) ++wrong;
      }
    });
  for (auto& t : threads) t.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Lua, ManyRoutinesInTurn) {
  std::vector<std::shared_ptr<const Routine>> all;
  for (int i = 0; i < 600; ++i) all.push_back(made(Role::value, std::to_string(i) + " + t"));
  for (int round = 0; round < 2; ++round)
    for (int i = 0; i < 600; ++i) {
      FakeQuestions q = at(0.5);
      std::uint64_t cost = 0;
      ASSERT_EQ(std::get<double>(*all[static_cast<std::size_t>(i)]->value(q, {}, cost)), i + 0.5);
    }
}

}  // namespace
}  // namespace betwixt

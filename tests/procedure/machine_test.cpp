// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the limits of a call, and that calls do not affect each other.
#include <atomic>
#include <thread>

#include "base/cancellation.h"
#include "procedure/routines.h"

namespace betwixt {
namespace {

// Code cannot hold on to work that is called off, however deep it asks other code; the next call is as ever.
TEST(Lua, WorkThatIsCalledOffEnds) {
  const std::string loop = "local s = 0 for i = 1, 10000 do s = s + i end return s";
  const std::atomic<bool> gone{true}, over{false};
  const std::atomic<int> others{0};
  FakeQuestions q;
  q.procedures["slow"] = made(Role::value, loop);
  FakeHost host;
  FakeInput in;
  {
    const Cancellation wanted(gone, over, others, {});
    std::uint64_t cost = 0;
    for (const std::string& code : {loop, std::string("value('slow')"), std::string("slow()")})
      EXPECT_THROW((void)made(Role::value, code)->value(q, {}, cost), Cancelled) << code;
    EXPECT_THROW((void)made(Role::command, loop)->command(host, {}), Cancelled);
    EXPECT_THROW((void)made(Role::filter, loop)->filter(in, 0, {}), Cancelled);
    EXPECT_THROW((void)made(Role::twerper, loop)->blend(0.5), Cancelled);
  }
  EXPECT_EQ(number("value('slow')", q), 50005000);
  EXPECT_TRUE(made(Role::command, loop)->command(host, {}));
}

// shows: G54
TEST(Lua, WhatNeverEndsIsStopped) {
  const std::string steps = "stopped: it took more than 1000000 steps", memory = "stopped: it took too much memory";
  EXPECT_EQ(error("while true do end"), steps);
  EXPECT_EQ(error("local function f() return f() end return f()"), steps);
  EXPECT_EQ(error("local s = 'x' while true do s = s .. s end"), memory);
  EXPECT_EQ(error("local s = '' while true do s = s .. 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxx' end"), memory);
  EXPECT_EQ(error("local t = {} while true do t[#t + 1] = ('x'):rep(1000) .. #t end"), memory);
  const std::string deep = error("local function f() return 1 + f() end return f()");
  EXPECT_TRUE(deep == steps || deep == memory || deep.starts_with("stack overflow")) << deep;
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

// Lua's own functions and single instructions that do very much: what they do counts, so none lasts.
// shows: G54
TEST(Lua, WhatIsDoneInsideOneInstructionCounts) {
  const std::string steps = "stopped: it took more than 1000000 steps", memory = "stopped: it took too much memory";
  const std::string many = "local t = {} for i = 1, 10000 do t[i] = i end ";
  const std::string long_texts = "local t = {} local base = ('x'):rep(900000) for i = 1, 10 do t[i] = base .. 'x' end ";
  for (const std::string& source :
       {long_texts + "while true do table.sort(t) end",
        many + "local function f(...) for i = 1, 1e6 do math.max(...) end end f(table.unpack(t))",
        many + "local function f(...) for i = 1, 1e6 do min(...) end end f(table.unpack(t))",
        many + "local function f(...) for i = 1, 1e6 do local a = select('#', ...) end end f(table.unpack(t))",
        many + "local function f(...) for i = 1, 1e6 do local a = {...} end end f(table.unpack(t))",
        many + "local function f(...) return f(1, 2, 3, 4, 5, 6, 7, 8, 9, ...) end f(table.unpack(t))",
        std::string("local s = ('x'):rep(900000) while true do s:byte(1, 200000) end"),
        std::string("local t = {} for i = 1, 20 do t[('x'):rep(700000) .. i] = i end while true do pairs(t) end"),
        many + "for i = 1, 10000 do t[i] = nil end while true do pairs(t) end",
        std::string("local t = {} for i = 1, 200000 do t[i] = vec(i, 0, 0) end while true do many(t) end"),
        std::string("local f = ('%99.99f'):rep(20000) local t = {} for i = 1, 20000 do t[i] = 1e308 end "
                    "while true do f:format(table.unpack(t)) end")}) {
    FakeQuestions q;
    q.procedures["many"] = made(Role::value, "1");
    const std::string why = error(source, q);
    EXPECT_TRUE(why == steps || why == memory || why.find("too many results to unpack") != std::string::npos ||
                why.find("string slice too long") != std::string::npos || why.starts_with("stack overflow"))
        << source << ": " << why;
  }
  const std::string least = "local a = {} for i = 1, 200 do a[i] = (i * 37) % 199 end return ";
  EXPECT_EQ(number(least + "math.max(table.unpack(a)) - min(table.unpack(a))"), 198);
  EXPECT_EQ(number("max(2, 5, 3) + math.min(2, -1)"), 4);
  EXPECT_EQ(error("max()"), "bad argument #1 to 'max' (number expected, got no value)");
  EXPECT_EQ(error("max(1, 'x')"), "bad argument #2 to 'max' (number expected, got string)");
}

// A collection goes through all that a call holds: many calls do not bring many of them.
// shows: G54
TEST(Lua, CallsOfWhoHoldsMuchStayCheap) {
  FakeQuestions q;
  q.procedures["one"] = made(Role::value, "1");
  const auto cost_of = [&](const std::string& calls) {
    std::uint64_t cost = 0;
    const auto code = made(Role::value,
                           "local held = {} for i = 1, 2000 do held[i] = ('x'):rep(1000) .. i end "
                           "local s = 0 for i = 1, " +
                               calls + " do s = s + one() end return s");
    EXPECT_TRUE(code->value(q, {}, cost));
    return cost;
  };
  EXPECT_LT(cost_of("2000") - cost_of("1000"), 1000 * 300U);
}

// A call and those that it waits for share one ceiling.
// shows: G54
TEST(Lua, WhatNestedCallsHoldIsOneSum) {
  FakeQuestions q;
  q.procedures["p0"] = made(Role::value, "#('x')");
  for (int i = 1; i <= 30; ++i)
    q.procedures["p" + std::to_string(i)] = made(Role::value, "local held = ('x'):rep(900000) local n = value('p" +
                                                                  std::to_string(i - 1) + "') return n + #held");
  EXPECT_EQ(number("value('p10')", q), 1 + 10 * 900000.0);
  const std::string why = error("value('p30')", q);
  EXPECT_TRUE(why.ends_with("stopped: it took too much memory")) << why;
  EXPECT_EQ(number("value('p10')", q), 1 + 10 * 900000.0) << "nothing is left of it";
}

// shows: G54
TEST(Lua, LongCodeIsNotCompiled) {
  std::string code = "t";
  while (code.size() + 6 <= 65'536) code += " and t";
  EXPECT_TRUE(make_lua(Role::value, code));
  const auto refused = make_lua(Role::value, code + " and t");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::range);
}

// What code says is its own: it may look like Lua's words, be very long, or be meant for a terminal.
// shows: G54
TEST(Lua, ErrorsOfCodeItself) {
  for (const std::string said : {"procedure:", "procedure:x", "procedure:1", "procedure:1:", "procedure:: a",
                                 "procedure:a: b", "(global '", "(global 'x", "x (global '' y"})
    EXPECT_EQ(error("error(\"" + said + "\", 0)").substr(0, said.size()), said);
  EXPECT_EQ(error("error('procedure:1: a', 0)"), "a");
  EXPECT_EQ(error("error('a\\27]0;b\\7\\u{9B}c\\u{202E}d\\ne\\xff', 0)"), "a\\x1b]0;b\\x07\\u{9b}c\\u{202e}d\\ne\\xff");
  EXPECT_EQ(error("error(('é'):rep(3000), 0)").size(), 500 * 2 + 3u);
  EXPECT_LT(error("error(\"(global '\" .. ('sin'):rep(300000) .. \"'\", 0)").size(), 1000u);
}

// What a call was given by Lua to work in does not make the next one dearer.
// shows: G54
TEST(Lua, AStackThatGrewShrinks) {
  const auto deep =
      made(Role::value, "local function f(n) if n == 0 then return 0 end return 1 + f(n - 1) end return f(5000)");
  const auto plain = made(Role::value, "local s = 0 for i = 1, 20000 do s = s + i end return s");
  const auto cost_of = [](const Routine& r) {
    FakeQuestions q;
    std::uint64_t cost = 0;
    EXPECT_TRUE(r.value(q, {}, cost));
    return cost;
  };
  const std::uint64_t before = cost_of(*plain);
  cost_of(*deep);
  EXPECT_EQ(cost_of(*plain), before);
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
  EXPECT_EQ(error("value('p350')", chain(350)), "procedures call each other more than 300 levels deep");
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

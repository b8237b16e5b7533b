// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/lua.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

#include "procedure/fake.h"
#include "procedure/noise.h"

namespace betwixt {
namespace {

std::shared_ptr<const Routine> made(Role role, const std::string& source) {
  auto r = make_lua(role, source);
  EXPECT_TRUE(r) << source << ": " << r.error().message;
  return r ? *r : nullptr;
}
Result<Value> value(const std::string& source, FakeQuestions q = {}, const std::vector<Value>& arguments = {}) {
  std::uint64_t cost = 0;
  return made(Role::value, source)->value(q, arguments, cost);
}
template <class T>
T get(const std::string& source, FakeQuestions q = {}, const std::vector<Value>& arguments = {}) {
  const auto v = value(source, q, arguments);
  EXPECT_TRUE(v) << source << ": " << v.error().message;
  const T* t = v ? std::get_if<T>(&*v) : nullptr;
  EXPECT_TRUE(t) << source;
  return t ? *t : T{};
}
double number(const std::string& source, FakeQuestions q = {}) { return get<double>(source, q); }
std::string error(const std::string& source, FakeQuestions q = {}) {
  const auto v = value(source, q);
  EXPECT_FALSE(v) << source;
  return v ? "" : v.error().message;
}
FakeQuestions at(double t) {
  FakeQuestions q;
  q.time = t;
  return q;
}

// shows: G54 G55
TEST(Lua, ExpressionsAndChunksReadTheFilmAtAnyTime) {
  EXPECT_EQ(number("2 * t + 1", at(3)), 7);
  EXPECT_EQ(number("0.5*sin(tau*t) + value('leg.rotation.z', t - 0.25)", at(1)),
            0.5 * std::sin(2 * std::numbers::pi) + 0.75 * 0.75);
  EXPECT_EQ(number("value('x')", at(3)), 9);
  EXPECT_EQ(number("local s = 0\nfor i = 1, 10 do s = s + i end\nreturn s"), 55);
  EXPECT_EQ(number("function(t) return t * 3 end", at(2)), 6);
  EXPECT_EQ(*get<Text>("self .. '!'"), "ball!");
  EXPECT_EQ(get<bool>("t > 1", at(2)), true);
  EXPECT_EQ(get<double>("(...) + select('#', ...)", {}, {Value(5.0), Value(true)}), 7);
}

// shows: G54 G29
TEST(Lua, ValuesOfEveryKind) {
  EXPECT_EQ(get<Vec3>("vec(1, 2, 3) + 2 * vec(1, 0, -1) / 4"), (Vec3{1.5, 2, 2.5}));
  EXPECT_EQ(get<Vec3>("-vec(1, 2, 3) * vec(2, 2, 2) - vec(1, 1, 1)"), (Vec3{-3, -5, -7}));
  EXPECT_EQ(get<bool>("vec(1, 2, 3) == vec(1, 2, 3) and vec(1, 2, 3) ~= vec(1, 2, 4)"), true);
  EXPECT_EQ(get<bool>("vec(1, 2, 3) == euler(1, 2, 3)"), false);
  EXPECT_EQ(number("length(vec(2, 3, 6))"), 7);
  EXPECT_EQ(number("dot(cross(vec(1,0,0), vec(0,1,0)), vec(4,5,6))"), 6);
  EXPECT_EQ(get<Color>("mix(rgb(0, 0, 0), rgb(1, 0.5, 0), 0.5)"), (Color{0.5, 0.25, 0}));
  EXPECT_EQ(get<Angles>("euler(1, 2, 3)"), (Angles{{1, 2, 3}}));
  EXPECT_EQ(get<Quat>("quat(0, 1, 0, 0)"), (Quat{0, 1, 0, 0}));
  const Vec3 turned = get<Vec3>("axis(0, 0, 1, pi / 2) * vec(1, 0, 0)");
  EXPECT_NEAR(turned.x, 0, 1e-15);
  EXPECT_NEAR(turned.y, 1, 1e-15);
  EXPECT_EQ(get<Points>("{vec(1,0,0), vec(0,1,0)}")->size(), 2u);
  EXPECT_EQ(get<Names>("{'a', 'b'}")->at(1), "b");
  FakeQuestions q;
  q.readings["hand.world"] = Matrix(translation({4, 5, 6}));
  EXPECT_EQ(number("local m = value('hand.world') return m[4] + 10 * m.y + 100 * m[1]", q), 4 + 50 + 100);
  q.readings["c"] = Color{0.1, 0.2, 0.3};
  EXPECT_EQ(get<Color>("value('c')", q), (Color{0.1, 0.2, 0.3}));
}

// shows: G17
TEST(Lua, MathAndNoise) {
  EXPECT_EQ(number("clamp(5, 0, 3) + smoothstep(0, 2, 1) + floor(2.7)"), 5.5);
  EXPECT_EQ(number("math.sin(1) - sin(1)"), 0);
  EXPECT_EQ(number("noise(3) + noise(1, 2) + noise(1, 2, 3)"), 0);  // zero on the lattice
  double low = 1, high = -1;
  for (int i = 0; i < 20000; ++i)
    for (int d = 1; d <= 3; ++d) {
      const double n = noise({i * 0.137, i * 0.071, i * 0.019}, d);
      low = std::min(low, n), high = std::max(high, n);
      const double step = noise({i * 0.137 + 1e-6, i * 0.071, i * 0.019}, d) - n;
      ASSERT_LT(std::abs(step), 1e-5);
    }
  EXPECT_GE(low, -1);
  EXPECT_LE(high, 1);
  EXPECT_LT(low, -0.6);
  EXPECT_GT(high, 0.6);
  double sum = 0;
  for (int i = 0; i < 10000; ++i) sum += hashed({double(i), 0, 0});
  EXPECT_NEAR(sum / 10000, 0.5, 0.02);
  EXPECT_EQ(number("random(7) - random(7)"), 0);
}

// shows: G6 G15 G17 G103
TEST(Lua, TwerpersFiltersCommands) {
  EXPECT_EQ(*made(Role::twerper, "u * u")->blend(0.5), 0.25);
  EXPECT_EQ(*made(Role::twerper, "function(u) return 1 - u end")->blend(0.25), 0.75);
  FakeInput in;
  EXPECT_EQ(std::get<double>(*made(Role::filter, "input(t - by) * gain_of + input()")
                                  ->filter(in, 2, {{"by", Value(1.0)}, {"gain-of", Value(3.0)}})),
            50);
  FakeHost host;
  EXPECT_TRUE(made(Role::command, "for _, o in ipairs(objects('*')) do run('hide ' .. o .. args[1] .. (...)) end")
                  ->command(host, {"x"}));
  EXPECT_EQ(host.lines, (std::vector<std::string>{"hide a*xx", "hide bxx"}));
  EXPECT_EQ(made(Role::command, "run('bad one')")->command(host, {}).error().message, "there is no command 'bad'");
  EXPECT_TRUE(made(Role::command, "run('at ' .. value('x', 2))")->command(host, {}));
  EXPECT_EQ(host.lines.back(), "at 4.0");
  EXPECT_EQ(made(Role::twerper, "vec(1,2,3)")->blend(0).error().message,
            "a twerper gives a number, this gave vec(1, 2, 3)");
  EXPECT_EQ(made(Role::twerper, "value('x')")->blend(0).error().message,
            "value: only procedures and commands can ask for values");
  EXPECT_EQ(made(Role::twerper, "u")->command(host, {}).error().message, "this procedure is no command");
}

// shows: G15 G54
TEST(Lua, NamedProceduresAreFunctions) {
  FakeQuestions q = at(2);
  q.procedures["twice"] = made(Role::value, "function(x) return 2 * x end");
  q.procedures["now"] = made(Role::value, "t");
  EXPECT_EQ(number("twice(now()) + twice(5)", q), 14);
  EXPECT_EQ(get<Vec3>("twice(vec(1, 2, 3))", q), (Vec3{2, 4, 6}));
  EXPECT_EQ(error("thrice(1)", q), "attempt to call a nil value (global 'thrice')");
}

// shows: G54
TEST(Lua, EveryErrorInWords) {
  EXPECT_EQ(make_lua(Role::value, "1 +").error().message, "unexpected symbol near <eof>");
  EXPECT_EQ(make_lua(Role::value, "  ").error().message, "there is no code");
  EXPECT_EQ(make_lua(Role::value, "local x = ").error().message, "unexpected symbol near <eof>");
  const std::pair<const char*, const char*> table[] = {
      {"local p\nreturn p.x", "line 2: attempt to index a nil value (local 'p')"},
      {"nil", "it gave no value"},
      {"0/0", "it gave a number that is not finite"},
      {"vec(1, 1/0, 0)", "it gave a vector with a number that is not finite"},
      {"print", "it gave no value"},
      {"{1, 2}", "a list is a value only where all in it are vectors, or all are texts"},
      {"local t = {} t[1] = t return t", "a list is a value only where all in it are vectors, or all are texts"},
      {"value('nowhere')", "there is no 'nowhere'"},
      {"value('x', 1/0)", "value: the time is no number"},
      {"vec(1,2,3) + rgb(1,1,1)", "there is no a vector + a color"},
      {"error({})", "it ended with an error that is no text"},
      {"run('x')", "run: only commands can"},
      {"input()", "input: only filters have one"},
      {"string.rep('x', 2000000)", "rep: a text of more than 1000000 characters"}};
  for (const auto& [code, words] : table) EXPECT_EQ(error(code), words) << code;
}

// shows: G14
TEST(Lua, NothingSurvivesACall) {
  EXPECT_EQ(error("x = 1"), "'x' would be a global, which nothing keeps: use local x");
  EXPECT_EQ(error("t = 1"), "'t' would be a global, which nothing keeps: use local t");
  EXPECT_EQ(error("math.sin = 1"), "a library cannot be written");
  EXPECT_EQ(error("local s = ('').rep string.rep = s"), "a library cannot be written");
  EXPECT_EQ(error("table.insert(math, 1)"), "a library cannot be written");
  const auto own = made(Role::value, "if x then return 1 end\n_ENV = {x = 1}\nreturn 0");
  FakeQuestions q;
  std::uint64_t cost = 0;
  EXPECT_EQ(std::get<double>(*own->value(q, {}, cost)), 0);
  EXPECT_EQ(std::get<double>(*own->value(q, {}, cost)), 0);
  for (const char* name :
       {"io",          "os",           "debug",        "package",    "load",     "dofile", "require", "collectgarbage",
        "coroutine",   "setmetatable", "getmetatable", "rawset",     "pcall",    "xpcall", "next",    "math.random",
        "string.find", "string.dump",  "print",        "loadstring", "loadfile", "_G",     "u",       "args"})
    EXPECT_TRUE(get<bool>(std::string(name) + " == nil")) << name;
}

// shows: G14
TEST(Lua, NoAddressesAndASortedOrder) {
  EXPECT_EQ(*get<Text>("tostring({}) .. tostring(sin) .. tostring(vec(1,2,3)) .. tostring(nil) .. tostring(1)"),
            "tablefunctionvec(1, 2, 3)nil1");
  EXPECT_EQ(*get<Text>("string.format('%s %5.2f %s %%', {}, 1, sin)"), "table  1.00 function %");
  EXPECT_EQ(error("string.format('%10p', {})"), "format: there is no %p");
  EXPECT_EQ(
      *get<Text>("local s = '' for k, v in pairs({b=1, [3]=2, a=3, [-1.5]=4, 10}) do s = s .. k .. '=' .. v .. ' ' "
                 "end return s"),
      "-1.5=4 1=10 3=2 a=3 b=1 ");
  EXPECT_EQ(error("for k in pairs({[true]=1}) do end"),
            "pairs: a key that is neither a number nor a text has no place in an order");
  EXPECT_EQ(error("pairs(3)"), "pairs: a table is needed");
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
  EXPECT_TRUE(deep == memory || deep.starts_with("stack overflow")) << deep;
  EXPECT_EQ(error("while true do table.sort({3, 1, 2}) end"), steps);
  EXPECT_EQ(error("local t = {} for i = 1, 1000 do t[i] = 'x' end while true do table.concat(t) end"), steps);
  EXPECT_EQ(error("table.sort({3, 1, 2}, function(a, b) while true do end end)"), steps);
  EXPECT_EQ(error("table.move({}, 1, 1e9, 2)"), steps);
  EXPECT_EQ(error("local t = {} for i = 1, 1e9 do table.insert(t, 1, i) end"), steps);
  EXPECT_EQ(error("while true do local s = ('x'):rep(100000) end"), memory);
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
  EXPECT_TRUE(error("again()", q).ends_with("procedures read each other more than 300 deep"));
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

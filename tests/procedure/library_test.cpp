// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the globals of Lua code: its changes must not last.
#include "procedure/routines.h"

namespace betwixt {
namespace {

// shows: G15 G54
TEST(Lua, NamedProceduresAreFunctions) {
  FakeQuestions q = at(2);
  q.procedures["twice"] = made(Role::value, "function(x) return 2 * x end");
  q.procedures["now"] = made(Role::value, "t");
  EXPECT_EQ(number("twice(now()) + twice(5)", q), 14);
  EXPECT_EQ(get<Vec3>("twice(vec(1, 2, 3))", q), (Vec3{2, 4, 6}));
  EXPECT_EQ(error("thrice(1)", q), "attempt to call a nil value (global 'thrice')");
}

// shows: G14
TEST(Lua, NothingSurvivesACall) {
  EXPECT_EQ(error("x = 1"), "'x' would be a global, but globals are not kept: use local x");
  EXPECT_EQ(error("t = 1"), "'t' would be a global, but globals are not kept: use local t");
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
  EXPECT_EQ(error("for k in pairs({[true]=1}) do end"), "pairs: the keys must be numbers or texts");
  EXPECT_EQ(error("pairs(3)"), "pairs: a table is needed");
}

// shows: G15
TEST(Lua, KnowsTheFrameAndTheRate) {
  EXPECT_EQ(number("rate"), 25);
  EXPECT_EQ(number("frame", at(0.4)), 11);  // the first is frame 1
  EXPECT_EQ(number("frame", at(0.5)), 13.5);
  EXPECT_EQ(number("frame", at(-0.04)), 0);
  EXPECT_EQ(*get<Text>("frame .. ' of ' .. rate", at(4.96)), "125 of 25");
  FakeInput in;
  EXPECT_EQ(std::get<double>(*made(Role::filter, "frame + rate")->filter(in, 2, {})), 76);
  EXPECT_EQ(std::get<double>(*made(Role::filter, "rate")->filter(in, 2, {{"rate", Value(7.0)}})), 7);  // its own
  FakeHost host;
  EXPECT_EQ(made(Role::command, "run('at ' .. frame)")->command(host, {}).error().message,
            "attempt to concatenate a nil value (global 'frame')");
}

// Against the six corners of the wheel, and halfway between two.
TEST(Lua, HueSaturationValue) {
  const auto is = [](const char* code, Color wanted) {
    const Color c = get<Color>(code);
    for (const auto& [a, b] : {std::pair(c.r, wanted.r), {c.g, wanted.g}, {c.b, wanted.b}})
      EXPECT_NEAR(a, b, 1e-14) << code;
  };
  is("hsv(0, 1, 1)", {1, 0, 0});
  is("hsv(1/6, 1, 1)", {1, 1, 0});
  is("hsv(1/3, 1, 1)", {0, 1, 0});
  is("hsv(0.5, 1, 1)", {0, 1, 1});
  is("hsv(-1/3, 1, 1)", {0, 0, 1});
  is("hsv(7 + 5/6, 1, 1)", {1, 0, 1});
  is("hsv(1/12, 1, 1)", {1, 0.5, 0});
  is("hsv(0.5, 0.5, 0.8)", {0.4, 0.8, 0.8});
  is("hsv(0.3, 0, 0.25)", {0.25, 0.25, 0.25});
  EXPECT_EQ(error("hsv('red', 1, 1)"), "bad argument #1 to 'hsv' (number expected, got string)");
}

TEST(Lua, WholeNumbersStayWhole) {
  FakeQuestions q = at(2);
  q.readings["n"] = Value(12.0), q.readings["half"] = Value(0.5), q.readings["far"] = Value(1e12);
  q.readings["place"] = Value(Vec3{3, -4, 0.25}), q.readings["zero"] = Value(-0.0);
  for (const auto& [code, words] : std::initializer_list<std::pair<const char*, const char*>>{
           {"value('n') .. ''", "12"},
           {"value('half') .. ''", "0.5"},
           {"value('far') .. ''", "1000000000000.0"},
           {"value('place').x .. ' ' .. value('place').y .. ' ' .. value('place').z", "3 -4 0.25"},
           {"round(2.6) .. ' ' .. round(-2.5) .. ' ' .. sign(-0.3)", "3 -2 -1"},
           {"clamp(value('n'), 0, 10) .. ' ' .. clamp(0.5, 0, 10)", "10 0.5"},
           {"floor(2.5) .. ' ' .. max(3, value('n'))", "2 12"}})
    EXPECT_EQ(*get<Text>(code, q), words) << code;
  // They are numbers like all others.
  EXPECT_EQ(number("value('n') / 5", q), 2.4);
  EXPECT_EQ(number("value('far') * value('far')", q), 1e24);
  EXPECT_EQ(number("value('n') * value('half')", q), 6);
  EXPECT_EQ(number("1 / value('zero') < 0 and 1 or 0", q), 1);
}

TEST(Lua, ListsOfPoints) {
  EXPECT_EQ(get<Points>("{vec(1, 2), vec(3, 4, 5)}"), Points(std::vector<Vec3>{{1, 2, 0}, {3, 4, 5}}));
  EXPECT_EQ(get<Points>("{}"), Points());
  EXPECT_EQ(error("{vec(1, 2), 'x'}"), "a list must contain only vectors or only texts");
  EXPECT_EQ(error("{vec(1, 2), vec(0/0, 1)}"), "it returned a vector with a number that is not finite");
  EXPECT_EQ(error("vec(1)"), "bad argument #2 to 'vec' (number expected, got no value)");
}

}  // namespace
}  // namespace betwixt

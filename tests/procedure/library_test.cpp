// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The globals that code sees: nothing it does stays.
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

}  // namespace
}  // namespace betwixt

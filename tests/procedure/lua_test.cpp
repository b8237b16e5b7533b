// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/lua.h"

#include <cmath>
#include <numbers>

#include "base/kept_results.h"
#include "procedure/routines.h"

namespace betwixt {
namespace {

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
  EXPECT_EQ(host.lines.back(), "at 4");
  EXPECT_EQ(made(Role::twerper, "vec(1,2,3)")->blend(0).error().message,
            "a twerper must return a number, not vec(1, 2, 3)");
  EXPECT_EQ(made(Role::twerper, "value('x')")->blend(0).error().message,
            "value: only procedures and commands can read values");
  EXPECT_EQ(made(Role::twerper, "u")->command(host, {}).error().message, "this procedure is not a command");
}

// shows: G54
TEST(Lua, EveryErrorInWords) {
  EXPECT_EQ(make_lua(Role::value, "1 +").error().message, "unexpected symbol near <eof>");
  EXPECT_EQ(make_lua(Role::value, "  ").error().message, "the code is empty");
  EXPECT_EQ(make_lua(Role::value, "local x = ").error().message, "unexpected symbol near <eof>");
  const std::pair<const char*, const char*> table[] = {
      {"local p\nreturn p.x", "line 2: attempt to index a nil value (local 'p')"},
      {"coss(t)", "attempt to call a nil value (global 'coss'); did you mean 'cos'?"},
      {"valu('x')", "attempt to call a nil value (global 'valu'); did you mean 'value'?"},
      {"nil", "it returned no value"},
      {"0/0", "it returned a number that is not finite"},
      {"vec(1, 1/0, 0)", "it returned a vector with a number that is not finite"},
      {"print", "it returned no value"},
      {"{1, 2}", "a list must contain only vectors or only texts"},
      {"local t = {} t[1] = t return t", "a list must contain only vectors or only texts"},
      {"value('nowhere')", "value('nowhere'): there is no 'nowhere'"},
      {"value('x', 1/0)", "value: the time must be a number"},
      {"vec(1,2,3) + rgb(1,1,1)", "a vector and a color cannot be added"},
      {"vec(1,2,3) - true", "true or false cannot be subtracted from a vector"},
      {"vec(1,2,3) / rgb(1,1,1)", "a vector cannot be divided by a color"},
      {"quat(1,0,0,0) * 'a'", "a quaternion and a text cannot be multiplied"},
      {"vec(1,2,3) + nil", "a vector and nothing cannot be added"},
      {"{} + vec(1,2,3)", "a list and a vector cannot be added"},
      {"error({})", "it failed with an error that is not a text"},
      {"run('x')", "run: only commands can use it"},
      {"input()", "input: only filters can use it"},
      {"string.rep('x', 2000000)", "rep: a text of more than 1000000 characters"}};
  for (const auto& [code, words] : table) EXPECT_EQ(error(code), words) << code;
}

// A command that is carried out again uses the code that its first try compiled.
TEST(Lua, IsCompiledOnceWhileResultsAreKept) {
  KeptResults::Store store;
  const auto made = [&](Role role, const char* source) {
    const KeptResults kept(store);
    const auto code = make_lua(role, source);
    return code ? code->get() : nullptr;
  };
  EXPECT_EQ(made(Role::value, "t + 1"), made(Role::value, "t + 1"));
  EXPECT_NE(made(Role::value, "t + 1"), made(Role::value, "t + 2"));
  EXPECT_NE(made(Role::value, "t"), made(Role::twerper, "t"));
  EXPECT_EQ(made(Role::value, "t +"), nullptr);
  EXPECT_EQ(store.size(), 5u);
  EXPECT_NE(*make_lua(Role::value, "t + 1"), *make_lua(Role::value, "t + 1"));
}

}  // namespace
}  // namespace betwixt

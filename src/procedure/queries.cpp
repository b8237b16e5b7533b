// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/queries.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostic.h"
#include "procedure/machine.h"
#include "procedure/nested.h"
#include "procedure/query_error.h"

namespace betwixt::lua {
namespace {

// Returns the cost of a query: more than one step, because its arguments and results are copied.
double copied(lua_State* l) {
  double steps = 0;
  for (int i = 1; i <= lua_gettop(l); ++i) {
    const int type = lua_type(l, i);
    if (type == LUA_TTABLE || type == LUA_TSTRING)
      steps += static_cast<double>(lua_rawlen(l, i)) / (type == LUA_TTABLE ? 1 : 16);
  }
  return steps;
}
template <int (*body)(lua_State*, Machine&)>
int priced(lua_State* l) {
  charge(l, 20 + copied(l));
  Machine::of(l).settle();
  const int results = guarded<body>(l);
  return charge(l, copied(l)), results;
}

int fail_by(lua_State* l, const Error& e) { return fail_with(l, e.message + (e.hint.empty() ? "" : "; " + e.hint)); }

// Fails with the error of a query. An error about a name begins with the author's call.
int fail_query(lua_State* l, std::string_view call, std::string_view name, Error e) {
  return e.message = query_error(call, name, e), fail_by(l, e);
}

int push_answer(lua_State* l, const std::string& target, const Result<Value>& r) {
  if (!r) return fail_by(l, r.error());
  if (!push(l, *r)) return fail_with(l, "'" + target + "' has a value that Lua cannot represent");
  return 1;
}

int value_of(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING) return fail_with(l, "value: the first argument must be a target in quotes");
  const std::string target = lua_tostring(l, 1);
  const bool now = lua_isnoneornil(l, 2);
  const double at = now ? m.call->seconds : lua_tonumber(l, 2);
  if (!std::isfinite(at) || (!now && !lua_isnumber(l, 2))) return fail_with(l, "value: the time must be a number");
  if (!m.call->questions && !m.call->host) return fail_with(l, "value: only procedures and commands can read values");
  if (!m.call->questions && now) return fail_with(l, "value: the time is missing");
  const auto found =
      m.call->questions ? m.call->questions->value(target, at, m.call->steps) : m.call->host->value(target, at);
  return found ? push_answer(l, target, found) : fail_query(l, "value", target, found.error());
}

// place(LINE, SHARE [, time])
int place_of(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING)
    return fail_with(l, "place: the first argument must be the name of a line, in quotes");
  if (!lua_isnumber(l, 2)) return fail_with(l, "place: the second argument must be a share of the length, from 0 to 1");
  if (!lua_isnoneornil(l, 3) && !lua_isnumber(l, 3)) return fail_with(l, "place: the time must be a number");
  if (!m.call->questions && !m.call->host)
    return fail_with(l, "place: only code that computes a value and commands can use it");
  const bool now = lua_isnoneornil(l, 3);
  if (!m.call->questions && now) return fail_with(l, "place: the time is missing");
  const double at = now ? m.call->seconds : lua_tonumber(l, 3);
  const auto found = m.call->questions
                         ? m.call->questions->place(lua_tostring(l, 1), lua_tonumber(l, 2), at, m.call->steps)
                         : m.call->host->place(lua_tostring(l, 1), lua_tonumber(l, 2), at);
  return found ? push_answer(l, "place", Value(*found)) : push_answer(l, "place", found.error());
}

// touching(A [, time]) returns a list of names; touching(A, B [, time]) returns whether they touch.
int touching_of(lua_State* l, Machine& m) {
  if (lua_type(l, 1) != LUA_TSTRING)
    return fail_with(l, "touching: the first argument must be the name of an object, in quotes");
  const bool two = lua_type(l, 2) == LUA_TSTRING;
  const int last = two ? 3 : 2;
  const bool now = lua_isnoneornil(l, last);
  if (!now && lua_type(l, last) != LUA_TNUMBER) return fail_with(l, "touching: the time must be a number");
  if (!m.call->questions) return fail_with(l, "touching: only code that computes a value can use it");
  const double at = now ? m.call->seconds : lua_tonumber(l, last);
  const auto ask = [&](int i) {
    return m.call->questions->value(lua_tostring(l, i) + std::string(".touching"), at, m.call->steps);
  };
  const auto found = ask(1);
  if (!found) return fail_query(l, "touching", lua_tostring(l, 1), found.error());
  if (!two) return push_answer(l, "touching", found);
  if (const auto other = ask(2); !other) return fail_query(l, "touching", lua_tostring(l, 2), other.error());
  const auto& names = *std::get<Names>(*found);
  lua_pushboolean(l, std::find(names.begin(), names.end(), lua_tostring(l, 2)) != names.end());
  return 1;
}

int input_at(lua_State* l, Machine& m) {
  if (!m.call->input) return fail_with(l, "input: only filters can use it");
  const double at = lua_isnoneornil(l, 1) ? m.call->seconds : lua_tonumber(l, 1);
  if (!std::isfinite(at) || (!lua_isnoneornil(l, 1) && !lua_isnumber(l, 1)))
    return fail_with(l, "input: the time must be a number");
  return push_answer(l, "input", m.call->input->at(at));
}

int run_line(lua_State* l, Machine& m) {
  if (!m.call->host) return fail_with(l, "run: only commands can use it");
  if (lua_type(l, 1) != LUA_TSTRING) return fail_with(l, "run: the argument must be a line of the language, in quotes");
  std::size_t size = 0;
  const char* line = lua_tolstring(l, 1, &size);
  const Status done = m.call->host->run({line, size});
  return done ? 0 : fail_with(l, done.error().message);
}

// Reads a row of a sheet, {TIME, VALUE, "REST"} or {{FROM, UNTIL}, VALUE, "REST"}, at the top of the stack. Returns why
// it cannot be read, or "".
std::string read_row(lua_State* l, HostRow& row) {
  if (!lua_istable(l, -1)) return "is not a table";
  const int table = lua_gettop(l);
  const auto time = [&](int at, double& out) {
    if (lua_type(l, at) != LUA_TNUMBER) return false;
    out = lua_tonumber(l, at);
    return std::abs(out) <= longest_seconds;
  };
  lua_geti(l, table, 1);
  bool timed = false;
  if (lua_istable(l, -1)) {
    lua_geti(l, -1, 1), lua_geti(l, -2, 2);
    timed = time(-2, row.from) && time(-1, row.until.emplace());
    if (timed && *row.until < row.from) return "ends before it begins";
  } else {
    timed = time(-1, row.from);
  }
  if (!timed) return "does not begin with a time in seconds, or with two in a table";
  if (lua_geti(l, table, 2) == LUA_TNIL) return "has no value";
  auto v = to_value(l, lua_gettop(l));
  if (!v) return "has a value that cannot be used: " + v.error().message;
  row.value = *std::move(v);
  const int rest = lua_geti(l, table, 3);
  if (rest != LUA_TNIL && rest != LUA_TSTRING) return "has something after its value that is not a text";
  if (rest == LUA_TSTRING) row.rest = lua_tostring(l, -1);
  return {};
}

// sheet(TARGET, {{TIME, VALUE, "REST"}, …})
int sheet_of(lua_State* l, Machine& m) {
  if (!m.call->host) return fail_with(l, "sheet: only commands can use it");
  if (lua_type(l, 1) != LUA_TSTRING) return fail_with(l, "sheet: the first argument must be a target in quotes");
  if (!lua_istable(l, 2)) return fail_with(l, "sheet: the second argument must be a list of rows");
  std::vector<HostRow> rows(lua_rawlen(l, 2));
  charge(l, 20 * static_cast<double>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    lua_geti(l, 2, static_cast<lua_Integer>(i + 1));
    if (const std::string why = read_row(l, rows[i]); !why.empty())
      return fail_with(l, "sheet: row " + std::to_string(i + 1) + " " + why);
    lua_settop(l, 2);
  }
  const Status done = m.call->host->sheet(lua_tostring(l, 1), rows);
  return done ? 0 : fail_by(l, done.error());
}

// when(SECONDS) returns the time as a script writes it.
int when_of(lua_State* l, Machine& m) {
  if (!m.call->host) return fail_with(l, "when: only commands can use it");
  if (lua_type(l, 1) != LUA_TNUMBER || !(std::abs(lua_tonumber(l, 1)) <= longest_seconds))
    return fail_with(l, "when: the argument must be a time in seconds");
  const std::string said = m.call->host->when(lua_tonumber(l, 1));
  return lua_pushlstring(l, said.data(), said.size()), 1;
}

int objects_of(lua_State* l, Machine& m) {
  if (!m.call->host) return fail_with(l, "objects: only commands can use it");
  if (lua_type(l, 1) != LUA_TSTRING) return fail_with(l, "objects: the argument must be a pattern in quotes");
  push(l, Value(Names(m.call->host->objects(lua_tostring(l, 1)))));
  return 1;
}
int objects(lua_State* l) {
  const int results = guarded<objects_of>(l);
  charge(l, 20 + static_cast<double>(lua_rawlen(l, -1)));
  return results;
}

// NAME([time]) returns the state of a stepped procedure.
int state_of(lua_State* l, Machine& m, const std::string& name) {
  const bool now = lua_isnoneornil(l, 1);
  const double at = now ? m.call->seconds : lua_tonumber(l, 1);
  if (!std::isfinite(at) || (!now && lua_type(l, 1) != LUA_TNUMBER) || lua_gettop(l) > 1)
    return fail_with(l, name + ": a stepped procedure takes one argument, a time in seconds, or none");
  const auto state = m.call->questions->state(name, at, m.call->steps);
  if (!state) return fail_with(l, name + ": " + state.error().message);
  m.call->steps += static_cast<std::uint64_t>(push(l, *state));
  return 1;
}

int call_routine(lua_State* l, Machine& m) {
  const std::string name = lua_tostring(l, lua_upvalueindex(1));
  const Routine* routine = m.call->questions ? m.call->questions->procedure(name) : nullptr;
  if (!routine) return fail_with(l, "there is no procedure " + name);
  if (routine->stepped()) return state_of(l, m, name);
  std::vector<Value> arguments;
  for (int i = 1; i <= lua_gettop(l); ++i) {
    auto v = to_value(l, i);
    if (!v) return fail_with(l, name + ": argument " + std::to_string(i) + " is not a value: " + v.error().message);
    arguments.push_back(std::move(*v));
  }
  const auto result = routine->value(*m.call->questions, arguments, m.call->steps);
  if (!result) {  // endless mutual calls are named once each
    const std::string why = with_line(result.error().place.line, result.error().message);
    const bool round = why.ends_with(Nested::error().message) && why.find(name + ": ") != std::string::npos;
    return fail_with(l, round ? why : name + ": " + why);
  }
  return push_answer(l, name, result);
}

int global_of(lua_State* l, Machine& m) {
  if (lua_type(l, 2) != LUA_TSTRING || !m.call) return 0;
  const std::string_view name = lua_tostring(l, 2);
  if ((name == "rate" || name == "frame") && (m.call->questions || m.call->input)) {
    const Rate rate = m.call->questions ? m.call->questions->rate() : m.call->input->rate();
    return push_number(l, name == "rate" ? rate.per_second() : rate.frame_number(from_seconds(m.call->seconds))), 1;
  }
  if (!m.call->questions) return 0;
  if (name == "t" && m.call->questions->timeless()) {
    m.call->questions->seconds();  // notes that the code reads the time
    return fail_with(l, "there is no time");
  }
  if (!m.call->questions->procedure(lua_tostring(l, 2))) return 0;
  lua_pushvalue(l, 2);
  lua_pushcclosure(l, priced<call_routine>, 1);
  return 1;
}

}  // namespace

const luaL_Reg query_functions[] = {
    {"value", priced<value_of>}, {"touching", priced<touching_of>}, {"place", priced<place_of>},
    {"input", priced<input_at>}, {"run", priced<run_line>},         {"objects", objects},
    {"sheet", priced<sheet_of>}, {"when", priced<when_of>},         {nullptr, nullptr}};

int find_global(lua_State* l) { return guarded<global_of>(l); }

}  // namespace betwixt::lua

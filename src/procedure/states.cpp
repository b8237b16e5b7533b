// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// States of stepped procedures to Lua and back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "procedure/machine.h"

namespace betwixt::lua {
namespace {

constexpr std::size_t most_entries = 20'000;  // of a state, in all its tables
constexpr std::size_t letters_an_entry = 64;  // a longer text counts as several entries
constexpr int deepest_table = 20;

Error no_state(std::string what) { return fail(ErrorCode::type, std::move(what)); }

// Reads the key at an index without changing it.
Result<State::Key> key_at(lua_State* l, int index) {
  if (lua_isinteger(l, index)) return State::Key(static_cast<std::int64_t>(lua_tointeger(l, index)));
  if (lua_type(l, index) == LUA_TSTRING) {
    std::size_t size = 0;
    const char* text = lua_tolstring(l, index, &size);
    return State::Key(std::string(text, size));
  }
  return no_state("the keys of a state must be whole numbers or texts");
}

Result<State> state_at(lua_State* l, int index, std::size_t& room, int depth) {
  if (room == 0) return fail(ErrorCode::range, fmt::format("a state can have at most {} entries", most_entries));
  --room;
  double n[16];
  if (lua_isinteger(l, index)) return State{static_cast<std::int64_t>(lua_tointeger(l, index))};
  if (lua_type(l, index) == LUA_TNIL) return no_state("it returned no state");
  if (lua_type(l, index) != LUA_TTABLE || read(l, index, n) != Kind::none) {
    auto v = to_value(l, index);
    if (!v) return v.error();
    const auto* text = std::get_if<Text>(&*v);
    room -= std::min(room, text ? (*text)->size() / letters_an_entry : 0);
    return State{*std::move(v)};
  }
  if (depth == deepest_table)
    return fail(ErrorCode::range, fmt::format("a state can have tables at most {} levels deep", deepest_table));
  State::Table table;
  lua_checkstack(l, 10);
  lua_pushnil(l);
  while (lua_next(l, index)) {
    auto key = key_at(l, -2);
    auto state = key ? state_at(l, lua_gettop(l), room, depth + 1) : Result<State>(key.error());
    lua_pop(l, 1);
    if (!state) return state;
    table.push_back({*std::move(key), *std::move(state)});
  }
  std::sort(table.begin(), table.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
  return State{std::move(table)};
}

void push_one(lua_State* l, const State& s, double& entries) {
  ++entries;
  if (const auto* whole = std::get_if<std::int64_t>(&s.is)) return lua_pushinteger(l, *whole);
  if (const auto* v = std::get_if<Value>(&s.is)) {
    if (const auto* d = std::get_if<double>(v)) return lua_pushnumber(l, *d);  // stays a number that can blend
    if (!push(l, *v)) lua_pushnil(l);
    return;
  }
  const auto* table = std::get_if<State::Table>(&s.is);
  if (!table) return lua_pushnil(l);
  lua_checkstack(l, 10);
  lua_createtable(l, static_cast<int>(table->size()), 0);
  for (const State::Entry& e : *table) {
    if (const auto* number = std::get_if<std::int64_t>(&e.key))
      lua_pushinteger(l, *number);
    else
      lua_pushlstring(l, std::get<std::string>(e.key).data(), std::get<std::string>(e.key).size());
    push_one(l, e.state, entries);
    lua_rawset(l, -3);
  }
}

}  // namespace

double push(lua_State* l, const State& s) {
  double entries = 0;
  push_one(l, s, entries);
  return entries;
}

Result<State> to_state(lua_State* l, int index) {
  std::size_t room = most_entries;
  auto state = state_at(l, lua_absindex(l, index), room, 0);
  if (state && Machine::of(l).call) Machine::of(l).call->steps += most_entries - room;
  return state;
}

}  // namespace betwixt::lua

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The table `block` of code: the size of a block of code, and the numbers of its lines.
#include <algorithm>
#include <cmath>

#include "base/utf8.h"
#include "procedure/axes_library.h"
#include "procedure/coordinates.h"
#include "scene/code_languages.h"

namespace betwixt::lua {
namespace {

// Returns the name of the block, or what is wrong.
std::string block_name(lua_State* l, Machine& m, std::string& out) {
  if (lua_type(l, 1) != LUA_TSTRING) return "the first argument must be the name of a block of code, in quotes";
  if (!m.call->questions) return "only code that computes a value can use it";
  out = lua_tostring(l, 1);
  return "";
}

// Returns the extent of a block now. Between two texts it grows in the first half of the time and shrinks in the
// second, so that it holds the words of both.
Vec3 extent_now(Machine& m, const std::string& name) {
  const CodeExtent a = code_extent(text_now(m, name + ".text"));
  const auto turn = m.call->questions->turn(name);
  const CodeExtent b = turn.share > 0 ? code_extent(turn.text) : a;
  const auto between = [&](double from, double to) {
    const double share = from < to ? std::min(1.0, 2 * turn.share) : std::max(0.0, 2 * turn.share - 1);
    return (1 - share) * from + share * to;
  };
  return {between(a.columns, b.columns), between(a.lines, b.lines), 0};
}

// block.extent(NAME): its columns and lines; between two texts, what is between theirs.
int extent_of_block(lua_State* l, Machine& m) {
  std::string name;
  if (auto why = block_name(l, m, name); !why.empty()) return fail_with(l, "block.extent: " + why);
  return push_place(l, extent_now(m, name)), 1;
}

// block.numbers(NAME): the numbers of its lines, one below the other.
int numbers_of_block(lua_State* l, Machine& m) {
  std::string name;
  if (auto why = block_name(l, m, name); !why.empty()) return fail_with(l, "block.numbers: " + why);
  std::string all;
  const auto lines = static_cast<int>(std::floor(extent_now(m, name).y + 0.01));
  for (int i = 1; i <= lines; ++i) all += (i > 1 ? "\n" : "") + std::to_string(i);
  return lua_pushlstring(l, all.data(), all.size()), 1;
}

}  // namespace

const luaL_Reg code_functions[] = {
    {"extent", of_piece<extent_of_block>}, {"numbers", of_piece<numbers_of_block>}, {nullptr, nullptr}};

}  // namespace betwixt::lua

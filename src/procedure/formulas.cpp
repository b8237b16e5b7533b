// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Formulas of plots as functions of Lua.
#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "procedure/coordinates.h"
#include "procedure/lua.h"

namespace betwixt {
namespace {

Result<lua::CompiledFormula> compiled_formula(const std::string& formula) {
  return lua::compiled_chunk("return function(x, y) local u, e = x, 2.718281828459045 return " + formula + "\nend");
}

// Words Lua's message for people who write formulas.
std::string plain_problem(const Error& error, const std::string& formula) {
  for (const std::string_view power : {"**", "²", "³"})
    if (formula.find(power) != std::string::npos)
      return fmt::format("'{}' is no sign of a formula; write x^2 for a power", power);
  std::string why = error.message;
  if (why.starts_with("line ")) why.erase(0, std::min(why.size(), why.find(": ") + 2));  // of the code around it
  constexpr std::string_view only_line = " at line 1";
  if (const auto at = why.find(only_line); at != std::string::npos) why.erase(at, only_line.size());
  if (why.starts_with("malformed number near")) return why + "; write 2*x for the product";
  for (const std::string_view inner : {" near 'end'", " near <eof>"})
    if (why.ends_with(inner)) why.replace(why.size() - inner.size(), inner.size(), " at its end");
  return why;
}

}  // namespace

std::string formula_problem(const std::string& formula) {
  const auto name = formula.find_last_not_of('\'');
  if (name == std::string::npos) return "it is empty";
  if (const std::string_view word = std::string_view(formula).substr(0, name + 1); is_name(word)) return "";
  const auto made = compiled_formula(lua::as_difference(formula));
  return made ? "" : plain_problem(made.error(), formula);
}

namespace lua {

std::string push_formula(lua_State* l, Machine& m, const std::string& formula) {
  const auto made = compiled_formula(formula);
  if (!made) return plain_problem(made.error(), formula);
  const std::size_t longest = m.longest;
  const std::size_t in_code = m.push_code(made->serial, made->code);
  m.longest = std::max(longest, in_code);
  m.lenient = false;
  const int status = lua_pcall(l, 0, 1, 0);
  m.lenient = true;
  return status == LUA_OK ? "" : lua_tostring(l, -1);
}

}  // namespace lua
}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/lua.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <utility>

#include "base/diagnostic.h"
#include "base/kept_results.h"
#include "base/memory_budget.h"
#include "base/names.h"
#include "base/utf8.h"
#include "procedure/coordinates.h"
#include "procedure/machine.h"
#include "procedure/nested.h"

namespace betwixt {
namespace {

using lua::Call;
using lua::Machine;

// Messages of code reach terminals and logs, so they are shortened, and control characters are removed.
std::string shown(std::string_view message) {
  constexpr std::size_t most = 500;
  const std::string_view begin = first_characters(message, most);
  return visible(begin) + (begin.size() < message.size() ? "…" : "");
}

// Shortens Lua's "procedure:3: what" to what, and sets the line.
std::string plain(std::string_view message, int& line) {
  constexpr std::string_view chunk = "procedure:";
  const std::size_t digits = std::min(message.find_first_not_of("0123456789", chunk.size()), message.size());
  // error() of code may imitate this beginning.
  if (!message.starts_with(chunk) || digits == chunk.size() || !message.substr(digits).starts_with(": "))
    return shown(message);
  for (const char c : message.substr(chunk.size(), std::min<std::size_t>(digits - chunk.size(), 7)))
    line = 10 * line + (c - '0');
  std::string rest = shown(message.substr(digits + 2));
  if (rest.ends_with("(number has no integer representation)"))
    rest += ": make it whole with floor(x), or write it with '%.0f'";
  return rest;
}

bool has_lines(const std::string& source) { return source.find('\n') != std::string::npos; }

// The machines of this thread, one for each level of nesting. Each level has the whole of Lua's stack, so that a
// procedure's limits do not depend on its caller.
// A deque, because a nested call adds a machine and the others must stay in place.
thread_local std::deque<std::unique_ptr<Machine>> machines;

std::unique_ptr<Machine>& machine() {
  const auto level = static_cast<std::size_t>(Nested::level());
  if (machines.size() < level) machines.resize(level);
  auto& m = machines[level - 1];
  if (!m) m = std::make_unique<Machine>();
  return m;
}

class Lua final : public Routine {
 public:
  std::string compiled;
  std::uint64_t serial = 0;
  Role role = Role::value;

  // `prepare` sets globals, pushes arguments and returns their number. `again` does the same for a returned function.
  // `take` converts the top of the stack to the result.
  template <class R>
  Result<R> run(Call& call, auto&& prepare, auto&& again, auto&& take) const {
    const Nested nested;
    if (Nested::too_deep()) return Nested::error();
    auto& machine_here = machine();
    Machine& m = *machine_here;
    lua_State* l = m.state;
    m.begin(call, m.push_code(serial, compiled));
    int status = call_function(m, prepare(m));
    if (status == LUA_OK && lua_type(l, -1) == LUA_TFUNCTION) status = call_function(m, again(m));
    m.lenient = true;
    Result<R> result = status == LUA_OK ? Result<R>(take(l)) : Result<R>(said(l, status));
    call.steps += lua::steps_between_hooks;  // the last hundred, which is incomplete
    const bool spoilt = status == LUA_ERRMEM || call.stopped;
    m.end();
    if (spoilt) machine_here = nullptr;  // it may have grown
    if (call.called_off) throw Cancelled{};
    return result;
  }

  Result<Value> value(Questions& q, const std::vector<Value>& arguments, std::uint64_t& cost) const override {
    if (role != Role::value) return Routine::value(q, arguments, cost);
    Call call;
    call.questions = &q;
    if (q.timeless())
      call.most = lua::most_timeless_steps;
    else
      call.seconds = q.seconds();
    const auto push_arguments = [&](Machine& m) {
      lua_checkstack(m.state, static_cast<int>(arguments.size()) + 10);
      for (const auto& a : arguments) push_value(m.state, a);
      return static_cast<int>(arguments.size());
    };
    auto result = run<Value>(
        call,
        [&](Machine& m) {
          set_query(m, q);
          return push_arguments(m);
        },
        [&](Machine& m) { return arguments.empty() ? (lua_pushnumber(m.state, q.seconds()), 1) : push_arguments(m); },
        [](lua_State* l) { return lua::to_value(l, -1); });
    cost += call.steps;
    return result;
  }

  bool stepped() const override { return role == Role::steps; }
  bool may_be_constant() const override { return role == Role::value; }

  Result<State> step(Questions& q, const State& before, std::int64_t number, double seconds_each,
                     std::uint64_t& cost) const override {
    if (role != Role::steps) return Routine::step(q, before, number, seconds_each, cost);
    Call call;
    call.questions = &q;
    call.seconds = q.seconds();
    const auto push_before = [&](Machine& m) {
      call.steps += static_cast<std::uint64_t>(lua::push(m.state, before));
      return 1;
    };
    auto result = run<State>(
        call,
        [&](Machine& m) {
          lua_pushnumber(m.state, call.seconds);
          m.set("t");
          lua_pushnumber(m.state, seconds_each);
          m.set("dt");
          lua_pushinteger(m.state, number);
          m.set("step");
          push_before(m);
          m.set("state");
          return 0;
        },
        push_before, [](lua_State* l) { return lua::to_state(l, -1); });
    cost += call.steps;
    return result;
  }

  Result<double> blend(double u) const override {
    if (role != Role::twerper) return Routine::blend(u);
    Call call;
    return run<double>(
        call,
        [&](Machine& m) {
          lua_pushnumber(m.state, u);
          m.set("u");
          return 0;
        },
        [&](Machine& m) { return lua_pushnumber(m.state, u), 1; },
        [](lua_State* l) -> Result<double> {
          auto v = lua::to_value(l, -1);
          if (!v) return v.error();
          if (const double* d = std::get_if<double>(&*v)) return *d;
          return fail(ErrorCode::type, "a twerper must return a number, not " + lua::written(l, -1));
        });
  }

  Result<Value> between(Questions& q, const TweenSegment& gap, std::uint64_t& cost) const override {
    if (role != Role::tween) return Routine::between(q, gap, cost);
    Call call;
    call.questions = &q;
    call.seconds = q.seconds();
    auto result = run<Value>(
        call,
        [&](Machine& m) {
          set_query(m, q);
          for (const auto& [name, number] : {std::pair("u", gap.u), std::pair("duration", gap.seconds)}) {
            lua_pushnumber(m.state, number);
            m.set(name);
          }
          for (const auto& [name, v] : {std::pair("from", gap.from), std::pair("to", gap.to),
                                        std::pair("before", gap.before), std::pair("after", gap.after)}) {
            if (!v) continue;
            push_value(m.state, *v);
            m.set(name);
          }
          return 0;
        },
        [&](Machine& m) { return lua_pushnumber(m.state, gap.u), 1; },
        [](lua_State* l) { return lua::to_value(l, -1); });
    cost += call.steps;
    return result;
  }

  Result<Value> filter(Input& input, double seconds, const Parameters& parameters) const override {
    if (role != Role::filter) return Routine::filter(input, seconds, parameters);
    Call call;
    call.input = &input;
    call.seconds = seconds;
    auto result = run<Value>(
        call,
        [&](Machine& m) {
          for (const auto& [name, v] : parameters) {
            std::string global = name;
            for (char& c : global)
              if (c == '-') c = '_';
            push_value(m.state, v);
            m.set(global.c_str());
          }
          lua_pushnumber(m.state, seconds);
          m.set("t");
          return 0;
        },
        [&](Machine& m) { return lua_pushnumber(m.state, seconds), 1; },
        [](lua_State* l) { return lua::to_value(l, -1); });
    input.work(call.steps);
    return result;
  }

  Status command(Host& host, const std::vector<std::string>& words) const override {
    if (role != Role::command) return Routine::command(host, words);
    // A command that another one runs continues its count of steps.
    thread_local Call* running = nullptr;
    Call call;
    call.host = &host;
    struct Running {
      Call* const outer = running;
      Call& inner;
      explicit Running(Call& c) : inner(c) {
        if (outer) inner.steps = outer->steps;
        running = &inner;
      }
      Running(const Running&) = delete;
      Running& operator=(const Running&) = delete;
      ~Running() {
        running = outer;
        if (outer) outer->steps = inner.steps;
      }
    } const now(call);
    const auto push_words = [&](Machine& m) {
      lua_checkstack(m.state, static_cast<int>(words.size()) + 10);
      for (const auto& w : words) lua_pushlstring(m.state, w.data(), w.size());
      return static_cast<int>(words.size());
    };
    return run<Nothing>(
        call,
        [&](Machine& m) {
          lua::push(m.state, Value(Names(words)));
          m.set("args");
          return push_words(m);
        },
        push_words, [](lua_State*) { return Nothing{}; });
  }

 private:
  static void set_query(Machine& m, const Questions& q) {
    if (!q.timeless()) {  // otherwise a read of it reaches find_global
      lua_pushnumber(m.state, q.seconds());
      m.set("t");
    }
    lua_pushlstring(m.state, q.self().data(), q.self().size());
    m.set("self");
  }

  // A value without an equivalent in Lua becomes nil.
  static void push_value(lua_State* l, const Value& v) {
    if (!lua::push(l, v)) lua_pushnil(l);
  }

  static int call_function(Machine& m, int arguments) {
    m.lenient = false;
    const int status = lua_pcall(m.state, arguments, 1, 0);
    m.lenient = true;
    return status;
  }

  // Returns a similar name for "(global 'nosuch')".
  static std::string near_global(lua_State* l, std::string_view why) {
    constexpr std::string_view before = "(global '";
    constexpr std::size_t longest_name = 100;
    const auto at = why.find(before);
    if (at == std::string_view::npos) return {};
    const int top = lua_gettop(l);
    std::string_view name = why.substr(at + before.size(), longest_name);
    name = name.substr(0, name.find('\''));
    std::vector<std::string> known;
    lua_pushglobaltable(l);  // each table precedes the next one
    for (bool more = true; more;) {
      for (lua_pushnil(l); lua_next(l, -2) != 0; lua_pop(l, 1))
        if (lua_type(l, -2) == LUA_TSTRING) known.emplace_back(lua_tostring(l, -2));
      more = luaL_getmetafield(l, -1, "__index") == LUA_TTABLE;
      if (more) lua_replace(l, -2);
    }
    lua_settop(l, top);
    std::sort(known.begin(), known.end());
    const std::string near = did_you_mean(name, {known.begin(), known.end()}).text;
    return near.empty() ? near : "; " + near;
  }

  Error said(lua_State* l, int status) const {
    if (status == LUA_ERRMEM) return fail(ErrorCode::range, lua::too_much_memory);
    if (lua_type(l, -1) != LUA_TSTRING) return fail(ErrorCode::type, "it failed with an error that is not a text");
    std::size_t size = 0;
    const char* text = lua_tolstring(l, -1, &size);
    const std::string_view why(text, size);
    int line = 0;
    Error e = fail(ErrorCode::type, plain(why, line) + near_global(l, why));
    if (has_lines(source) && !why.ends_with(Nested::error().message)) e.place.line = line;
    return e;
  }
};

int keep(lua_State*, const void* piece, std::size_t size, void* to) {
  static_cast<std::string*>(to)->append(static_cast<const char*>(piece), size);
  return 0;
}

// Compiles the source, or returns Lua's error.
Result<std::string> compile(lua_State* l, const std::string& source) {
  if (luaL_loadbufferx(l, source.data(), source.size(), "=procedure", "t") != LUA_OK) {
    int line = 0;
    const std::string why = plain(lua_tostring(l, -1), line);
    return fail(ErrorCode::syntax, with_line(has_lines(source) ? line : 0, why));
  }
  std::string out;
  lua_dump(l, keep, &out, 0);
  return out;
}

// Returns whether the source begins with a keyword of a statement. Its error is then that of a chunk, not of an
// expression.
bool is_chunk(std::string_view source) {
  const auto begin = source.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return false;
  source.remove_prefix(begin);
  for (const std::string_view word : {"local", "if", "for", "while", "repeat", "return", "do", "goto"})
    if (source.starts_with(word) && (source.size() == word.size() || source[word.size()] == ' ')) return true;
  return source.find("return") != std::string_view::npos;
}

Result<std::shared_ptr<const Lua>> compiled_lua(Role role, const std::string& source) {
  lua_State* l = luaL_newstate();
  if (!l) return fail(ErrorCode::machine, "there is not enough memory for Lua");
  auto compiled = compile(l, "return " + source);
  if (!compiled) {
    auto chunk = compile(l, source);
    if (chunk || is_chunk(source)) compiled = std::move(chunk);
  }
  lua_close(l);
  if (!compiled) return compiled.error();
  static std::atomic<std::uint64_t> serials{0};
  auto lua = std::make_shared<Lua>();
  lua->language = "lua";
  lua->source = source;
  lua->compiled = std::move(*compiled);
  lua->serial = ++serials;
  lua->role = role;
  return std::shared_ptr<const Lua>(std::move(lua));
}

}  // namespace

namespace lua {
Result<CompiledFormula> compiled_chunk(const std::string& source) {
  const auto made = KeptResults::get("formula in Lua", source, [&] { return compiled_lua(Role::value, source); });
  if (!made) return made.error();
  return CompiledFormula{(*made)->serial, (*made)->compiled};
}
}  // namespace lua

Result<std::shared_ptr<const Routine>> make_lua(Role role, std::string source) {
  if (source.find_first_not_of(" \t\r\n") == std::string::npos) return fail(ErrorCode::syntax, "the code is empty");
  if (source.size() > lua::longest_code)
    return fail(ErrorCode::range,
                fmt::format("the code has {} bytes; the limit is {}", source.size(), lua::longest_code));
  const auto made = KeptResults::get(fmt::format("{} in Lua", role_names[static_cast<std::size_t>(role)]), source,
                                     [&] { return compiled_lua(role, source); });
  if (!made) return made.error();
  MemoryBudget::charge(source.size() + (*made)->compiled.size());
  return std::shared_ptr<const Routine>(*made);
}

bool known_to_lua(std::string_view name) {
  static constexpr std::string_view words[] = {"and",   "break",    "do",     "else",   "elseif", "end",   "false",
                                               "for",   "function", "goto",   "if",     "in",     "local", "nil",
                                               "not",   "or",       "repeat", "return", "then",   "true",  "until",
                                               "while", "t",        "self",   "_ENV",   "rate",   "frame"};
  if (std::find(std::begin(words), std::end(words), name) != std::end(words)) return true;
  const Nested nested;
  Machine& m = *machine();
  lua_State* l = m.state;
  lua_pushglobaltable(l);
  lua_pushlstring(l, name.data(), name.size());
  const bool known = lua_gettable(l, -2) != LUA_TNIL;  // does not query procedures, because no call is running
  m.lenient = true;
  lua_settop(l, 0);
  return known;
}

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A Lua state that cannot be left changed, the limits of a call, and values to and from it.
//
// Lua raises errors by longjmp, which no C++ destructor survives. So a C function here is one of two kinds: plain, with
// nothing but numbers and pointers, which may raise; or wrapped by guarded<>, which holds what it likes, raises nothing
// (memory is not refused meanwhile) and returns `failed` with the message pushed. NotWanted ends the call, and is
// thrown when Lua has been left.
#pragma once

#include <cstdint>
#include <lua.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/still_wanted.h"
#include "track/procedure.h"

namespace betwixt::lua {

inline constexpr std::uint64_t most_steps = 1'000'000;
inline constexpr int steps_between_hooks = 100;
// An instruction may go through a whole text, to compare it, and may copy as many arguments as the stack holds: each
// counts once more for every so many letters of the longest text, and for every so many slots of the stack.
inline constexpr std::size_t letters_a_step = 512, slots_a_step = 512;
// Bytes that a call, and all calls that it waits for, may hold; and that one call may allocate in all.
inline constexpr std::size_t most_live = 16 << 20, most_allocated = 64 << 20;
// Lua's compiler takes quadratic time for some texts: `t and t and …` of a megabyte takes a minute.
inline constexpr std::size_t longest_code = 65'536;
inline constexpr std::size_t most_garbage = 256 << 10;  // that a machine keeps while it is not running
inline constexpr const char* too_many_steps = "stopped: it took more than 1000000 steps";
inline constexpr const char* not_wanted = "stopped: this is not wanted any more";
inline constexpr const char* too_much_memory = "stopped: it took too much memory";

// What the running call may use.
struct Call {
  Questions* questions = nullptr;
  Input* input = nullptr;
  Host* host = nullptr;
  double seconds = 0;
  std::uint64_t steps = 0;
  bool stopped = false;
  bool called_off = false;  // nobody wants the answer any more
};

// The tables that stand for a value; each has a metatable of its kind.
enum class Kind : std::uint8_t { none, vector, color, angles, quat, matrix };
inline constexpr int kinds = 6;

class Machine {
 public:
  Machine();
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;
  static Machine& of(lua_State* l) { return **static_cast<Machine**>(lua_getextraspace(l)); }

  lua_State* state = nullptr;
  Call* call = nullptr;
  bool lenient = true;  // memory is not refused
  std::size_t live = 0, floor = 0, allocated = 0;
  std::size_t outside = 0;    // bytes that the calls hold which wait for this one
  int now = LUA_NOREF;        // the globals of this call
  int metatable[kinds] = {};  // by Kind
  std::size_t longest = 0;    // text that this call has made or has in its code
  // Lua's own stack, which the allocator knows by its first size, and the block that was allocated last.
  struct Block {
    void* at = nullptr;
    std::size_t bytes = 0;
  } stack, newest;

  // Pushes the code as a function. Returns the length of the longest text in it.
  std::size_t push_code(std::uint64_t serial, std::string_view compiled);
  void begin(Call&, std::size_t longest_in_code);
  void end();
  double steps_each() const;  // what an instruction may cost now
  // Before another call: collects garbage, so that what this call holds is counted against the other one, and little
  // else. Where not much has come since the last time nothing is done: a collection goes through all that is held.
  void settle();
  std::size_t held() const;      // bytes beyond `most_garbage` …
  std::size_t made() const;      // … at most those that this call allocated
  void set(const char* global);  // pops its value

 private:
  static constexpr std::size_t most_chunks = 256;
  struct Chunk {
    int reference;
    std::size_t longest;
  };
  std::unordered_map<std::uint64_t, Chunk> chunks_;  // compiled here already, by serial
  std::size_t settled_ = 0;                          // bytes behind the last collection of this call
  Machine* below_ = nullptr;                         // whose call waits for this one
};

// Raises the error on the stack's top as one that ends the call, whatever the code would like.
int stop(lua_State*, const char* why);
void charge(lua_State*, double steps);

inline constexpr int failed = -1;
template <int (*function)(lua_State*, Machine&)>
int guarded(lua_State* l) {
  Machine& m = Machine::of(l);
  m.lenient = true;
  int results = failed;
  try {
    results = function(l, m);
  } catch (const NotWanted&) {
    m.call->called_off = true;
  }
  m.lenient = false;
  if (m.call && m.call->called_off) return stop(l, not_wanted);
  if (results >= 0) return results;
  luaL_where(l, 1);
  lua_insert(l, -2);
  lua_concat(l, 2);
  return lua_error(l);
}

// Values (values.cpp). None raises, but for want of memory.
Kind read(lua_State*, int index, double* numbers);  // the numbers of a value of a kind: up to 16
void push_number(lua_State*, double);               // what is whole stays so in texts: 3, not 3.0
void push(lua_State*, Kind, const double* numbers);
bool push(lua_State*, const Value&);  // false: there is no such thing in Lua; nothing is pushed
Result<Value> to_value(lua_State*, int index);
std::string written(lua_State*, int index);  // any value, without addresses
void make_kinds(lua_State*, Machine&);

void open_library(lua_State*, Machine&);  // library.cpp: sets the table of globals

}  // namespace betwixt::lua

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A Lua state that always returns to its initial state, the limits of a call, and the conversion of values.
//
// Lua raises errors by longjmp, which skips C++ destructors. So a C function here is one of two kinds. A plain one uses
// only numbers and pointers, and may raise. One wrapped by guarded<> may use any object and never raises: memory is not
// refused during it, and for an error it pushes the message and returns `failed`. Cancelled ends the call, and is
// thrown only after Lua has returned.
#pragma once

#include <cstdint>
#include <lua.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "base/cancellation.h"
#include "track/procedure.h"

namespace betwixt::lua {

inline constexpr std::uint64_t most_steps = 1'000'000;
inline constexpr std::uint64_t most_timeless_steps = 50'000;  // of code that may be constant: half a millisecond
inline constexpr int steps_between_hooks = 100;
// One instruction may compare whole texts, and may copy as many arguments as the stack has. So each instruction costs
// an extra step for each `letters_a_step` letters of the longest text, and for each `slots_a_step` slots of the stack.
inline constexpr std::size_t letters_a_step = 512, slots_a_step = 512;
// The most bytes that a call and the calls waiting for it may hold, and that one call may allocate in total.
inline constexpr std::size_t most_live = 16 << 20, most_allocated = 64 << 20;
// Lua's compiler takes quadratic time for some texts: a megabyte of `t and t and …` takes a minute.
inline constexpr std::size_t longest_code = 65'536;
inline constexpr std::size_t most_garbage = 256 << 10;  // that a machine keeps while it is idle
inline constexpr const char* too_many_steps = "stopped: it took more than 1000000 steps";
inline constexpr const char* not_wanted = "cancelled: a newer change replaces this one";
inline constexpr const char* too_much_memory = "stopped: it took too much memory";

// The resources of the running call.
struct Call {
  Questions* questions = nullptr;
  Input* input = nullptr;
  Host* host = nullptr;
  double seconds = 0;
  std::uint64_t steps = 0, most = most_steps;
  bool stopped = false;
  bool called_off = false;  // the caller has cancelled the call
};

// The tables that represent values. Each kind has a metatable of its own.
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
  std::size_t outside = 0;    // bytes held by the calls that wait for this one
  int now = LUA_NOREF;        // the globals of this call
  int metatable[kinds] = {};  // by Kind
  std::size_t longest = 0;    // the longest text that this call has made or has in its code
  // Lua's own stack, which the allocator recognizes by its initial size, and the latest allocated block.
  struct Block {
    void* at = nullptr;
    std::size_t bytes = 0;
  } stack, newest;

  // Pushes the code as a function. Returns the length of the longest text in it.
  std::size_t push_code(std::uint64_t serial, std::string_view compiled);
  void begin(Call&, std::size_t longest_in_code);
  void end();
  double steps_each() const;  // the present cost of an instruction
  // Collects garbage before a nested call, so that only memory in use counts against that call. Does nothing if little
  // was allocated since the last time, because a collection visits everything.
  void settle();
  std::size_t held() const;      // bytes beyond `most_garbage`; at most made()
  std::size_t made() const;      // bytes that this call allocated
  void set(const char* global);  // pops the value

 private:
  static constexpr std::size_t most_chunks = 256;
  struct Chunk {
    int reference;
    std::size_t longest;
  };
  std::unordered_map<std::uint64_t, Chunk> chunks_;  // compiled code by serial
  std::size_t settled_ = 0;                          // bytes after the last collection of this call
  Machine* below_ = nullptr;                         // the machine whose call waits for this one
};

// Raises the error on top of the stack as one that code cannot catch.
int stop(lua_State*, const char* why);
void charge(lua_State*, double steps);

inline constexpr int failed = -1;
inline int fail_with(lua_State* l, std::string_view why) { return lua_pushlstring(l, why.data(), why.size()), failed; }
template <int (*function)(lua_State*, Machine&)>
int guarded(lua_State* l) {
  Machine& m = Machine::of(l);
  m.lenient = true;
  int results = failed;
  try {
    results = function(l, m);
  } catch (const Cancelled&) {
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

// Values (values.cpp). These functions raise only when memory runs out.
Kind read(lua_State*, int index, double* numbers);  // reads up to 16 numbers of a value
void push_number(lua_State*, double);               // whole numbers stay whole in texts: 3, not 3.0
void push(lua_State*, Kind, const double* numbers);
void push(lua_State*, const Mat4&);
Mat4 matrix_of(const double* numbers);  // of 16, row after row
bool push(lua_State*, const Value&);    // returns false, and pushes nothing, if Lua has no equivalent
Result<Value> to_value(lua_State*, int index);
double push(lua_State*, const State&);  // returns the number of its entries
Result<State> to_state(lua_State*, int index);
std::string written(lua_State*, int index);  // any value, without addresses
void make_kinds(lua_State*, Machine&);

void open_library(lua_State*, Machine&);  // library.cpp: sets the table of globals

}  // namespace betwixt::lua

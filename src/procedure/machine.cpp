// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/machine.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace betwixt::lua {
namespace {

// The size of a new state's stack in Lua 5.4: twice the minimum stack, and five extra slots.
constexpr std::size_t first_stack = (2 * LUA_MINSTACK + 5) * 16;

thread_local Machine* running = nullptr;  // the innermost call

void* allocate(void* data, void* block, std::size_t old_size, std::size_t size) {
  Machine& m = *static_cast<Machine*>(data);
  const bool is_new = !block;
  if (is_new) {  // old_size is then the type of the block
    if (old_size == LUA_TSTRING) m.longest = std::max(m.longest, size);
    old_size = 0;
  }
  if (size == 0) {
    if (block == m.stack.at) m.stack = m.newest;  // Lua copies a growing stack, and then frees the old one
    std::free(block);
    m.live -= old_size;
    return nullptr;
  }
  if (size > old_size) {
    if (!m.lenient &&
        (m.live + m.outside + size - old_size > m.floor + most_live || m.allocated + size > most_allocated))
      return nullptr;
    m.allocated += size;
  }
  void* at = std::realloc(block, size);
  if (at) m.live += size - old_size;
  if (at && is_new) m.newest = {at, size};
  if (at && is_new && !m.stack.at && size == first_stack) m.stack = m.newest;
  return at;
}

void hook(lua_State* l, lua_Debug*) { charge(l, steps_between_hooks * Machine::of(l).steps_each()); }

}  // namespace

Machine::Machine() {
  state = lua_newstate(allocate, this);
  if (!state) std::abort();  // no memory for 5 kB
  *static_cast<Machine**>(lua_getextraspace(state)) = this;
  make_kinds(state, *this);
  open_library(state, *this);
}

Machine::~Machine() {
  lenient = true;
  lua_close(state);
}

std::size_t Machine::push_code(std::uint64_t serial, std::string_view compiled) {
  if (const auto known = chunks_.find(serial); known != chunks_.end()) {
    lua_rawgeti(state, LUA_REGISTRYINDEX, known->second.reference);
    longest = known->second.longest;
  } else {
    if (chunks_.size() >= most_chunks) {
      for (const auto& [_, chunk] : chunks_) luaL_unref(state, LUA_REGISTRYINDEX, chunk.reference);
      chunks_.clear();
    }
    longest = 0;
    luaL_loadbufferx(state, compiled.data(), compiled.size(), "=procedure", "b");
    lua_pushvalue(state, -1);
    chunks_.emplace(serial, Chunk{luaL_ref(state, LUA_REGISTRYINDEX), longest});
    lua_gc(state, LUA_GCCOLLECT);
    floor = live;
  }
  // Code may assign _ENV, which the function keeps. Restores the original.
  lua_pushglobaltable(state);
  if (!lua_setupvalue(state, -2, 1)) lua_pop(state, 1);
  return longest;
}

double Machine::steps_each() const {
  return 1 + static_cast<double>(longest / letters_a_step + stack.bytes / 16 / slots_a_step);
}

std::size_t Machine::held() const { return live - std::min(live, floor + most_garbage); }

std::size_t Machine::made() const { return std::min(held(), allocated); }

void Machine::settle() {
  if (held() == 0 || live < settled_ + settled_ / 2 + most_garbage) return;
  charge(state, static_cast<double>(made() / 128));
  lua_gc(state, LUA_GCCOLLECT);
  settled_ = live;
}

void Machine::begin(Call& c, std::size_t longest_in_code) {
  call = &c;
  allocated = settled_ = 0;
  longest = longest_in_code;
  outside = running ? running->outside + running->held() : 0;
  below_ = std::exchange(running, this);
  lua_sethook(state, hook, LUA_MASKCOUNT, steps_between_hooks);
}

void Machine::end() {
  lenient = true;
  call = nullptr;
  running = below_;
  lua_settop(state, 0);
  lua_rawgeti(state, LUA_REGISTRYINDEX, now);
  lua_pushnil(state);
  while (lua_next(state, 1)) {
    lua_pop(state, 1);
    lua_pushvalue(state, -1);
    lua_pushnil(state);
    lua_rawset(state, 1);
  }
  lua_settop(state, 0);
  longest = 0;
  // The thread's machine may now be idle for long. A full collection also shrinks the stack.
  if (held() > 0 || steps_each() > 1) lua_gc(state, LUA_GCCOLLECT);
}

void Machine::set(const char* global) {
  lua_rawgeti(state, LUA_REGISTRYINDEX, now);
  lua_insert(state, -2);
  lua_setfield(state, -2, global);
  lua_pop(state, 1);
}

int stop(lua_State* l, const char* why) {
  Machine::of(l).call->stopped = true;
  lua_pushstring(l, why);
  return lua_error(l);
}

void charge(lua_State* l, double steps) {
  Call& c = *Machine::of(l).call;
  if (!Cancellation::wanted()) c.called_off = true, stop(l, not_wanted);
  c.steps += steps < 2.0 * most_steps ? static_cast<std::uint64_t>(steps) : 2 * most_steps;
  if (c.steps > c.most) stop(l, too_many_steps);
}

}  // namespace betwixt::lua

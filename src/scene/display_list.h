// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Display lists: commands that draw, stored under a name as a subroutine is, and what becomes of them. The main list
// with all that it calls is *expanded* into plain objects of the document: groups for instances and environments,
// polygons, lines, points and letters. They are like all others, but only their lists say what they are.
//
// Column vectors: a command puts its matrix to the right of the one on top of the stack, so that what is nearer to a
// primitive is applied first. (The source, with row vectors, writes TOS <- m TOS.)
//
// Source: Animation Imaging Model 2.1, 2.2.1, 2.2.6, 3.3.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/cow.h"
#include "betwixt/document.h"

namespace betwixt {

struct Object;

enum class Drawing : std::uint8_t {
  point,         // Points
  vector,        // Points: a line through them
  polygon,       // Points
  text,          // Text
  color,         // Color
  texture,       // Text: the file
  font,          // Text
  push,          // the matrix on top of the stack, once more
  pop,           // as it was at the push
  multiply,      // Matrix
  call,          // Text: an instance of that list
  begin,         // Text: the environment that moves all until its end
  end,           // of the environment begun last; the stack is as it was at its begin
  view,          // Points: from, to
  perspective,   // double: the horizontal angle
  orthographic,  // double: the height that is seen
};
inline constexpr std::array<std::string_view, 16> drawing_names{
    "point", "vector",   "polygon", "text",  "color", "texture", "font",        "push",
    "pop",   "multiply", "call",    "begin", "end",   "view",    "perspective", "orthographic"};

struct DisplayCommand {
  Drawing what = Drawing::push;
  Value value;
  // Of a begin that a live host said: the tick, which decides what generation of the environment it means. None: the
  // first one.
  std::optional<std::int64_t> since;
  friend bool operator==(const DisplayCommand&, const DisplayCommand&) = default;
};

// Commands in shared chunks: a host adds row after row while older documents live on.
class DisplayCommands {
 public:
  std::size_t size() const { return size_; }
  const DisplayCommand& operator[](std::size_t i) const { return (*chunks_[i / chunk])[i % chunk]; }
  void put(std::size_t i, DisplayCommand);  // at the end, or in place of what stands there
  friend bool operator==(const DisplayCommands&, const DisplayCommands&) = default;

 private:
  static constexpr std::size_t chunk = 64;
  std::vector<Cow<std::vector<DisplayCommand>>> chunks_;
  std::size_t size_ = 0;
};

struct DisplayList {
  DisplayCommands commands;
  std::map<std::string, std::size_t, std::less<>> tags;  // the command that each labels; may be the next to come
  bool there = true;                                     // else it has been deleted
  friend bool operator==(const DisplayList&, const DisplayList&) = default;
};
using DisplayLists = std::map<std::string, Cow<DisplayList>, std::less<>>;
// What lists are from a time on; each until a later time says more of it.
using LaterLists = std::map<Time, DisplayLists>;

// A list as it is at a time; none where it is not there.
const DisplayList* list_at(const Scene&, std::string_view name, Time);
// What it is from this very time on; begins as what it was before.
DisplayList& edit_list(Scene&, const std::string& name, Time from);
// The times from which on a list is there as somebody has made or edited it; none: there never is such a list.
std::vector<Time> versions(const Scene&, std::string_view name);
std::vector<std::string_view> list_names(const Scene&);
void delete_list(Scene&, const std::string& name, Time from);  // from the beginning: for all times
void change(DisplayLists&, const DisplayLists& later);

// The calls that lead from one list to another at a time, both included; empty: none do.
std::vector<std::string> calls(const DisplayLists&, const std::string& from, const std::string& to);
// … in what is made of a list from one of these times on. Lists change at other times too: all are looked at.
std::vector<std::string> calls(const Scene&, const std::string& from, const std::string& to,
                               const std::vector<Time>& versions_of_to);
bool ever_calls(const Scene&, const std::string& from, const std::string& to);

// A command of the list that closes what is not open, or opens what is never closed.
std::optional<std::size_t> unbalanced(const DisplayList&);

inline constexpr std::size_t most_derived = 100'000;  // objects of an expansion
inline constexpr std::size_t most_scanned = 300'000;  // and of all its versions, each counted by itself
inline constexpr int deepest_derived = 200;           // instances and environments in one another

// The begins of an environment that gets another name.
void rename_environment(Scene&, const std::string& old, const std::string& name);
// A list that gets another name, and all calls of it.
void rename_list(Scene&, const std::string& old, const std::string& name);

// Makes the objects of the main list what its commands say, at all times: what is equal before and after an edit is one
// object, all else is shown while it holds and hidden at other times. Objects that are still there keep their numbers,
// and nothing is touched that has not changed. Where it would be too many of them, nothing is done.
Status expand(Scene&);
// … where only names have changed: its objects are the same as before, and keep what hangs on them.
void expand_renamed(Scene&);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Display lists: drawing commands under a name, like a subroutine, and the objects that they become. The main list with
// all lists that it calls is *expanded* to plain objects of the document: groups for instances and environments,
// polygons, lines, points and letters. They are like any other objects, but only their lists can change them.
//
// Column vectors: a command multiplies its matrix from the right to the one on top of the stack, so the one nearest to
// a primitive is applied first. (The source has row vectors and writes TOS <- m TOS.)
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
  push,          // saves the matrix on top of the stack
  pop,           // restores it
  multiply,      // Matrix
  call,          // Text: an instance of that list
  begin,         // Text: the environment of all commands until its end
  end,           // ends the last environment; the stack is as at its begin
  view,          // Points: from, to
  perspective,   // double: the horizontal angle
  orthographic,  // double: the height of the view
};
inline constexpr std::array<std::string_view, 16> drawing_names{
    "point", "vector",   "polygon", "text",  "color", "texture", "font",        "push",
    "pop",   "multiply", "call",    "begin", "end",   "view",    "perspective", "orthographic"};

struct DisplayCommand {
  Drawing what = Drawing::push;
  Value value;
  // Of a begin by a live host: its tick, which determines the generation of the environment. nullopt: the first one.
  std::optional<std::int64_t> since;
  friend bool operator==(const DisplayCommand&, const DisplayCommand&) = default;
};

// Commands in shared chunks: a host appends row after row while older documents remain.
class DisplayCommands {
 public:
  std::size_t size() const { return size_; }
  const DisplayCommand& operator[](std::size_t i) const { return (*chunks_[i / chunk])[i % chunk]; }
  void put(std::size_t i, DisplayCommand);  // at the end, or in place of an existing one
  friend bool operator==(const DisplayCommands&, const DisplayCommands&) = default;

 private:
  static constexpr std::size_t chunk = 64;
  std::vector<Cow<std::vector<DisplayCommand>>> chunks_;
  std::size_t size_ = 0;
};

struct DisplayList {
  DisplayCommands commands;
  std::map<std::string, std::size_t, std::less<>> tags;  // the command that each names; may be the next one
  bool there = true;                                     // false if it has been deleted
  friend bool operator==(const DisplayList&, const DisplayList&) = default;
};
using DisplayLists = std::map<std::string, Cow<DisplayList>, std::less<>>;
// The versions of the lists that edits at a time make, each valid until the next.
using LaterLists = std::map<Time, DisplayLists>;

// Returns a list at a time, or null if it does not exist then.
const DisplayList* list_at(const Scene&, std::string_view name, Time);
// Returns the version of a list from this time on; it starts as a copy of the one before.
DisplayList& edit_list(Scene&, const std::string& name, Time from);
// Returns the times at which a version of a list begins, or an empty list if it never exists.
std::vector<Time> versions(const Scene&, std::string_view name);
std::vector<std::string_view> list_names(const Scene&);
void delete_list(Scene&, const std::string& name, Time from);  // `from` the beginning: for all times
void change(DisplayLists&, const DisplayLists& later);

// Returns the chain of calls from one list to another at a time, both included, or an empty list if there is none.
std::vector<std::string> calls(const DisplayLists&, const std::string& from, const std::string& to);
// The same for the versions from one of these times on. Lists change at other times too, so all are checked.
std::vector<std::string> calls(const Scene&, const std::string& from, const std::string& to,
                               const std::vector<Time>& versions_of_to);
bool ever_calls(const Scene&, const std::string& from, const std::string& to);

// Returns the first command that closes what is not open or opens what is never closed, or nullopt.
std::optional<std::size_t> unbalanced(const DisplayList&);

inline constexpr std::size_t most_derived = 100'000;  // objects of an expansion
inline constexpr std::size_t most_scanned = 300'000;  // objects of all its versions, each counted by itself
inline constexpr int deepest_derived = 200;           // depth of nested instances and environments

// Renames an environment in all begins.
void rename_environment(Scene&, const std::string& old, const std::string& name);
// Renames a list and all calls of it.
void rename_list(Scene&, const std::string& old, const std::string& name);

// Updates the objects of the main list to its commands, at all times. An object that is equal before and after an edit
// is one object; any other is visible while it is valid and hidden at other times. Objects that stay keep their
// numbers, and unchanged ones are not touched. If they would be too many, nothing is changed.
Status expand(Scene&);
// The same if only names have changed: the objects are the same as before, and keep their children.
void expand_renamed(Scene&);

}  // namespace betwixt

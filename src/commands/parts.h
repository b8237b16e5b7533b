// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts: kinds that a script makes of lines, and those that come with the program.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "commands/command.h"
#include "scene/part.h"

namespace betwixt {

// A part that comes with the program.
struct PartRow {
  std::string_view name, sentence, head, lines;  // `head`: its parameters, as after `part NAME`
  bool on_background = false;                    // its texts stand on the background of the film
};
std::span<const PartRow> part_rows();
std::vector<std::string_view> part_names(const Scene&);  // those of the script, and those of the program

// Returns a part of the script or of the program; nullopt if there is none.
std::optional<Part> part_called(const Scene&, std::string_view name);
// Returns the part of this name; adds one of the program to the scene when it is used first. nullptr: there is none.
const Part* find_part(Command&, std::string_view name);
// Adds a line to the part whose block is open.
bool take_part_line(Command&, const char* start);
// Runs the part of `create NAME PART` behind the part's name, for all names. Changes nothing if it fails.
bool create_parts(Command&, const std::vector<std::string>& names, const std::vector<ObjectId>& parents,
                  std::string_view name);

// Returns lines of a part for the object `self`: the names that the lines make are below it. In quoted texts `self/`
// and 'self' stand for it.
std::string lines_for(const Part&, const std::string& self);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The author's own kinds: `define kind`, `create NAME KIND` of such a kind, and `unlink`.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/command.h"
#include "scene/own_kinds.h"

namespace betwixt {

// Updates the instances of all kinds whose models have changed since the last call. Costs little if none has.
// `about` is the place for what it reports.
void follow_models(Scene&, Script&, std::string_view about);
// Returns the kind, or null. Makes a plug-in's kind when it is first asked for; fails if its lines have errors.
const OwnKind* find_own_kind(Command&, std::string_view name);
// Gives parts of instances the model's values again, so that they follow it: one function, or all of them except the
// root's own place. Returns how many objects belong to an instance.
std::size_t revert(Scene&, const std::vector<std::pair<ObjectId, std::optional<FunctionId>>>&);
// Makes the rest of `define kind NAME like OBJECT [hidden] [of (OBJECTS)]`, after the word `kind`.
bool define_kind(Command&);
// Returns whether `define kind NAME like` begins here, behind `define`.
bool defines_kind(Cursor);
// Fails if an instance of the kind with this name would be part of the kind's own model.
bool no_circle(Command&, const OwnKind&, const std::string& name, std::string_view about);
// Fails if an instance of any kind is part of its own kind's model.
bool no_circles(Command&, std::string_view about);
// Adds an instance whose parts have consecutive numbers from `first` on. `said`: functions set on its root.
void add_instance(Scene&, const std::string& kind, ObjectId first, const std::vector<FunctionId>& said);

}  // namespace betwixt

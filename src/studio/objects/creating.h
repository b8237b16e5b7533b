// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Menus of the kinds, which create objects that show something at once.
#pragma once

#include <span>

#include "studio/objects/object_lines.h"
#include "studio/shell/workspace.h"

class QMenu;

namespace betwixt::studio {

// A kind that users create by hand.
struct CreatedKind {
  Kind kind;
  const char* group;          // the submenu
  std::string_view also;      // words by which people look for it
  bool like_example = false;  // the kind shows nothing, or too little, without the values of its example
};
std::span<const CreatedKind> created_kinds();

// Returns the lines that create an object of a kind. What needs axes gets those that are selected, the last ones of the
// film, or new ones; what needs a formula follows the selected plot.
ObjectEdit creating_lines(const Workspace&, const CreatedKind&);
// Creates and selects an object of a kind. Asks for a file if the kind needs one.
void create_of_kind(Workspace&, const CreatedKind&, QWidget* over);

// Gives a menu the groups of kinds, also those of the film when it shows. `over`: the widget that asks for files.
void fill_kinds(QMenu&, Workspace&, QWidget* over);

}  // namespace betwixt::studio

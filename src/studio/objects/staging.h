// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Actions that bring the selected objects on at the playhead, take them off, point at them and connect them. Each
// writes the line that an author would write: `at 24f fade-in ball`.
#pragma once

#include <span>

#include "studio/objects/object_lines.h"
#include "studio/shell/workspace.h"

class QMenu;

namespace betwixt::studio {

enum class StagingSort : std::uint8_t {
  enter,    // `at 24f fade-in ball`
  leave,    // `at 24f fade-out ball`
  mark,     // `at 24f underline ball`
  unmark,   // `at 24f underline ball off`, for the marks that it has
  text,     // `at 24f label ball "…"`
  connect,  // `connect a to b curved`, for two objects
  morph,    // `at 24f morph a into b`
  angle     // `angle a b c`, for three objects
};

struct StagingRow {
  StagingSort sort;
  const char* name;       // in menus
  std::string_view verb;  // "fade-in"
  const char* sentence;
  std::string_view also;  // words by which people look for it
  std::string_view detail =
      {};  // the route of a connection; what a mark is called below its object, if not by its verb
};
std::span<const StagingRow> staging_rows();
// Returns how many objects an action needs; 0: any number, but at least one.
std::size_t objects_needed(const StagingRow&);

// Returns the lines of an action for objects, in the order in which they were selected. `text`: of a label. No lines:
// the action needs other objects.
Lines staging_lines(const StagingRow&, const Program&, const std::vector<ObjectId>&, Time, const std::string& text);
// Carries an action out for the selection, as one step. Asks for the text of a label.
void stage(Workspace&, const StagingRow&);
// Gives a menu the actions in submenus.
void fill_staging(QMenu&, Workspace&);

}  // namespace betwixt::studio

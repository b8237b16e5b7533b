// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Chooses and orders the tracks that a sheet shows.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

struct SheetRow {
  ObjectId object;
  bool whole = false;  // all events of the object together; otherwise one track
  bool open = false;   // the rows of its tracks follow
  Target target;
};

struct SheetChoice {
  std::vector<ObjectId> objects;       // empty means all
  std::string search;                  // a pattern ("ball*.position"), or part of a name; "" finds all
  std::map<std::uint32_t, bool> open;  // objects that the user opened or closed
};

std::vector<SheetRow> sheet_rows(const Document&, const SheetChoice&);
// Returns the tracks alone, for columns.
std::vector<Target> sheet_tracks(const Document&, const SheetChoice&);
// Returns the tracks that a row shows.
std::vector<Target> tracks_of_row(const Document&, const SheetRow&);

}  // namespace betwixt::studio

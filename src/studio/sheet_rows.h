// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which tracks a sheet shows, and in which order.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "studio/desk.h"

namespace betwixt::studio {

struct SheetRow {
  ObjectId object;
  bool whole = false;  // all events of the object together; else one track
  bool open = false;   // its tracks follow
  Target target;
};

struct SheetChoice {
  std::vector<ObjectId> objects;       // none: all
  std::string search;                  // a pattern ("ball*.position"), or part of a name; empty: everything
  std::map<std::uint32_t, bool> open;  // what the hand has opened and closed
};

std::vector<SheetRow> sheet_rows(const Document&, const SheetChoice&);
// The tracks alone, for columns.
std::vector<Target> sheet_tracks(const Document&, const SheetChoice&);
// The tracks behind a row.
std::vector<Target> tracks_of_row(const Document&, const SheetRow&);

}  // namespace betwixt::studio

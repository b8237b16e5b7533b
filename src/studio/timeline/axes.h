// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Separates a track of vectors into a track for each component, so that each can have events at its own times.
#pragma once

#include "studio/timeline/event_lines.h"

namespace betwixt::studio {

// Returns whether a target's track can be separated: it has events, and numbers with names.
bool can_separate(const Document&, const Target&);
// Return the lines that separate it. The first way writes a sheet for each component in place of the one sheet that has
// all events; no lines if there is no such sheet. The second way writes one event of a component, at the end.
Lines separate_in_sheets(const Document&, const std::string& text, const Target&);
Lines separate_by_event(const Document&, const Target&);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Notes as a track: operations on times accept the word `notes` in place of a target.
#pragma once

#include <functional>

#include "commands/segments.h"

namespace betwixt {

// Reads the word `notes`. Targets have a dot, so they cannot be confused with it.
bool accept_notes(Command&, std::string_view& word);
// Returns the nearest time, clamped to the range of times.
Time time_of(double flicks);
// Moves each note of the segment to the times that `to` returns: none, one or several. A moved note replaces no other;
// two may have the same time.
bool retime_notes(Command&, std::string_view word, Segment, const std::function<void(Time, std::vector<Time>&)>& to);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// New events (keys) at the playhead as script lines: of the value that is there, between the two events beside it
// (breakdowns), or of the value before (holds).
#pragma once

#include <utility>
#include <vector>

#include "studio/timeline/event_lines.h"

namespace betwixt::studio {

// Returns the tracks for new events: those with events. With `or_position`, an object without any gets its position.
std::vector<Target> animated_tracks(const Document&, const std::vector<ObjectId>&, bool or_position);
// Returns the tracks with events, and the positions, rotations and scales that have none.
std::vector<Target> tracks_with_transforms(const Document&, const std::vector<ObjectId>&);
// Returns the objects, and all that hangs at this time on the uppermost parents of each: whole characters.
std::vector<ObjectId> whole_characters(const Document&, const std::vector<ObjectId>&, Time);
// Returns the tracks whose value differs from that of their last event before this time.
std::vector<Target> changed_tracks(const Program&, const std::vector<Target>&, Time);

// Inserts an event with the track's value on each target.
Lines insert_lines(const Document&, const Program& before, const std::vector<Target>&, Time);
// Inserts an event on each track that has one on both sides: its value is at a share of the way between them.
Lines breakdown_lines(const Program&, const std::vector<Target>&, Time, double share);
// Makes each track hold the value of its last event up to this time, and inserts an event with that value.
Lines hold_lines(const Program&, const std::vector<Target>&, Time);

// Spreads times between two others by a curve. `share`: what part of the way to the end a part of the time becomes.
// Times on whole frames come to whole frames, unless another one is there already.
std::function<Time(Time)> retiming(const Document&, const std::vector<EventAt>&,
                                   const std::function<double(double)>& share);
// Returns the functions of the events' objects that code computes, or that filters on a part of the film change:
// retimed events leave them behind.
std::vector<std::string> left_behind(const Document&, const std::vector<EventAt>&, Time);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Operations on segments of tracks. The first four change times, the others change values. (twixt notes, 4.5)
// A segment from..to is closed: it has the events with from <= time <= to. Every operation first copies what it
// reads, so source and target may overlap. If an operation fails, the track is unchanged.
#pragma once

#include <vector>

#include "betwixt/result.h"
#include "track/track.h"

namespace betwixt {

struct Segment {
  Time from, to;
};

struct Changed {
  std::size_t events = 0;    // that the operation changed or made
  std::size_t replaced = 0;  // other events that were replaced
};

// Copies a segment. Copy k (k = 1 … times) starts at `start` + (k - 1)(to - from), has k shifts added, and replaces the
// events in its range. If there is an event at its start, it keeps that one's ease-in. `into` may be `from_track`.
Result<Changed> copy_segment(const Track& from_track, Segment, Track& into, Time start,
                             const std::optional<Value>& shift, int times);
Result<Changed> move_segment(Track&, Segment, Time by);
// Stretches about `from`. Eases stretch too, hermite tangents shrink. factor > 0.
Result<Changed> stretch_segment(Track&, Segment, double factor);
// Reverses the order; the track runs back the same way in between.
Result<Changed> reverse_segment(Track&, Segment);
// Replaces the influence of events outside a segment on its first and last in-betweens by tangents, so that they keep
// their shape whatever is beside them. `component`: the track is that of a component of the type. Returns the parts
// that cannot keep their shape.
std::vector<Segment> own_tangents(Track&, Segment, Type, bool component);
// Makes the track before t independent of the events from t on, which will be removed: curves keep their
// shape by tangents. Returns the tangent with which an event at t is reached. `component`: as above.
EventDetail end_alone(Track&, Time t, Type, bool component);
// Gives every event with `keep` its value: the track stays the same even if its events change later.
void fill_in_kept(Track&, Type, bool component);

// Removes the events before t that the values from t on do not depend on. Returns how many. Only twerpers of the
// track are considered; the caller must consider filters and velocities, which look back further.
std::size_t erase_before(Track&, Time t, Changes);

// Multiplies by a number for all components, or one for each. Tangents too.
Result<Changed> scale_segment(Track&, Segment, const Value& by);
Result<Changed> translate_segment(Track&, Segment, const Value& by);
// Rotates vectors about a centre; multiplies orientations from the right.
Result<Changed> rotate_segment(Track&, Segment, Quat by, Vec3 centre);

// Returns a + k·b for values that consist of numbers, or nullopt for others.
std::optional<Value> add_scaled(const Value& a, const Value& b, double k);

}  // namespace betwixt

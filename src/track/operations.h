// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Operations on segments of tracks: the first four change times, the others values. (twixt notes, 4.5; R-T10)
// A segment from..to is closed: it holds the events with from <= time <= to. Every operation works on a copy of what it
// reads first, so overlapping ranges mean what they say. A track is left as it was when an operation fails.
#pragma once

#include <vector>

#include "betwixt/result.h"
#include "track/track.h"

namespace betwixt {

struct Segment {
  Time from, to;
};

struct Changed {
  std::size_t events = 0;    // that the operation acted on (or made)
  std::size_t replaced = 0;  // other events that had to give way
};

// The k-th copy (k = 1 … times) starts at `start` + (k - 1)(to - from), has k shifts added, and replaces what stood in
// its range; on an occupied start it keeps the ease-in that it finds. `into` may be `from_track` itself.
Result<Changed> copy_segment(const Track& from_track, Segment, Track& into, Time start,
                             const std::optional<Value>& shift, int times);
Result<Changed> move_segment(Track&, Segment, Time by);
// About `from`; eases grow along, hermite tangents shrink. factor > 0.
Result<Changed> stretch_segment(Track&, Segment, double factor);
// Last comes first; in-betweens run the same way back.
Result<Changed> reverse_segment(Track&, Segment);
// What a track's first and last in-betweens of the segment owe to events outside it become tangents of their own: so
// they stay as they are whoever stands beside them. `component`: of the type, the track is that of one. What cannot be
// kept so, and will bend: the segments of it.
std::vector<Segment> own_tangents(Track&, Segment, Type, bool component);
// What comes before t owes nothing any more to what stands at t and behind it, which is about to go: curves keep their
// shape as tangents. How an event at t is come to. `component`: as above.
EventDetail end_alone(Track&, Time t, Type, bool component);
// Rows that keep the value have it: the same track, whatever becomes of its events.
void fill_in_kept(Track&, Type, bool component);

// Takes out the events before t that values at t and later owe nothing to; how many. What looks further back than the
// twerpers of the track itself, as filters and velocities do, is the caller's to know.
std::size_t erase_before(Track&, Time t, Changes);

// `by`: a number for every component, or one for each. Tangents are scaled too.
Result<Changed> scale_segment(Track&, Segment, const Value& by);
Result<Changed> translate_segment(Track&, Segment, const Value& by);
// Vectors about a centre; orientations are multiplied from the right.
Result<Changed> rotate_segment(Track&, Segment, Quat by, Vec3 centre);

// a + k·b for values made of numbers; nothing where that means nothing.
std::optional<Value> add_scaled(const Value& a, const Value& b, double k);

}  // namespace betwixt

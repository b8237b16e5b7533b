// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which events of a track became which.
#pragma once

#include <vector>

#include "betwixt/compare.h"
#include "compare/facts.h"

namespace betwixt {

// Returns the events that differ, by their old times. An event that is gone and one with the same row that came are one
// event that moved; several that moved together are found first.
std::vector<EventChange> events_apart(const TrackEvents& old, const TrackEvents& now);

}  // namespace betwixt

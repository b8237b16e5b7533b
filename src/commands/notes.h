// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Notes, steps and descriptions as tracks: operations on times accept one of these words in place of a target.
#pragma once

#include <functional>
#include <optional>

#include "commands/segments.h"

namespace betwixt {

constexpr std::size_t most_cues = 100'000;  // steps, or descriptions
enum class Cues : std::uint8_t { notes, steps, descriptions };
// Reads one of these words. Targets have a dot, so they cannot be confused with it.
std::optional<Cues> accept_cues(Command&, std::string_view& word);
// Returns the nearest time, clamped to the range of times.
Time time_of(double flicks);
// Moves each cue of the segment to the times that `to` returns: none, one or several. A moved note replaces no other;
// two may have the same time. A moved step or description replaces the one that is there.
bool retime_cues(Command&, Cues, std::string_view word, Segment,
                 const std::function<void(Time, std::vector<Time>&)>& to);

}  // namespace betwixt

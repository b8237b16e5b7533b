// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Notes as a track: operations on times take the word `notes` where else a target stands.
#pragma once

#include <functional>

#include "commands/segments.h"

namespace betwixt {

// Takes the word `notes`; targets have a dot.
bool accept_notes(Command&, std::string_view& word);
// The nearest time; one beyond all times for what is beyond.
Time time_of(double flicks);
// Every note of the segment goes to where `to` says, which may be nowhere or several times. Notes replace nothing: two
// may stand at one time.
bool retime_notes(Command&, std::string_view word, Segment, const std::function<void(Time, std::vector<Time>&)>& to);

}  // namespace betwixt

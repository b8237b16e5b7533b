// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Inserts time into a film, or removes some (ripple edits): later events and notes move, and so does the end. Camera
// cuts stay, because no command moves them.
#pragma once

#include "studio/timeline/event_lines.h"

namespace betwixt::studio {

// Everything from `at` on comes later.
Lines insert_time_lines(const Document&, Time at, Time by);
// Removes the events and notes from `from` to before `to`. Everything from `to` on comes earlier.
Lines remove_time_lines(const Document&, Time from, Time to);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Descriptions of a document in words, for the shell and for the clients of a server.
#pragma once

#include <optional>
#include <string>

#include "betwixt/program.h"

namespace betwixt {

// Lists the objects that match a pattern ("" matches all), with their kinds and numbers of events. Errors: name.
Result<std::string> list_objects(const Document&, const std::string& pattern);
// Describes an object, its values and attachments, or the events of a target. Errors: name, range (too long).
Result<std::string> describe(const Document&, const std::string& word);
Result<std::string> describe(const Program&, const std::string& word);
std::string list_notes(const Document&);
// Returns the notes to show when playback reaches `now`: all after the time `after` that was shown before; without
// `after`, the notes exactly at `now`. Each is in quotes, one after the other. Returns "" if the film has `notes off`.
std::string notes_shown(const Document&, std::optional<Time> after, Time now);
// Returns all that is known about a word; lists all words if it is "". Errors: name.
Result<std::string> look_up(const Document&, const std::string& word);

}  // namespace betwixt

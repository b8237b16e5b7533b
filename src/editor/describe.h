// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What there is to see in a document, in words: for the shell, and for hosts of a server.
#pragma once

#include <optional>
#include <string>

#include "betwixt/program.h"

namespace betwixt {

// Objects, their kinds and how many events they have; "": all. Errors: name.
Result<std::string> list_objects(const Document&, const std::string& pattern);
// What an object is, has and hangs on; of a target, its events. Errors: name, range (it would be very much).
Result<std::string> describe(const Document&, const std::string& word);
Result<std::string> describe(const Program&, const std::string& word);
std::string list_notes(const Document&);
// The notes that playing says at a time: all that stand behind the time that was shown before, or, none, those that
// stand exactly there. In quotes, one behind the other; nothing where the film says `notes off`.
std::string notes_shown(const Document&, std::optional<Time> after, Time now);
// All that is known about a word; "": all words. Errors: name.
Result<std::string> look_up(const Document&, const std::string& word);

std::string counted(std::size_t n, const char* what);  // "1 event", "3 events"

}  // namespace betwixt

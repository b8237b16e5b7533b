// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows of display lists.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "commands/command.h"

namespace betwixt {

struct ListRow {
  std::string_view word, usage, sentence, example;
};
// In the order of Drawing; the rows that are not drawing commands come last.
std::span<const ListRow> list_rows();

// Fails if a command at the end of the list does not match the commands before it. A command inserted in between may be
// completed later.
bool in_order(Command&, const DisplayCommand&, std::string_view about);
// Returns the message for a command whose other half is missing.
std::string without_half(const DisplayCommand&);

}  // namespace betwixt

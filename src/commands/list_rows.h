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
// In the order of Drawing, and behind them what is no command of a list.
std::span<const ListRow> list_rows();

// What comes at the end must fit what is there; what is put between may be completed later.
bool in_order(Command&, const DisplayCommand&, std::string_view about);
// What is wrong with a command that has no other half.
std::string without_half(const DisplayCommand&);

}  // namespace betwixt

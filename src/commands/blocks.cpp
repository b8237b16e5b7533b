// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Blocks: commands that are indented below a line, and belong to it.
#include "commands/command.h"
#include "syntax/tokens.h"

namespace betwixt {

bool ReaderState::goes_on(std::string_view line) const { return left && indentation(line) > margin(); }

bool ReaderState::belongs(std::string_view line) const {
  return goes_on(line) || (!blocks.empty() && indentation(line) > blocks.front().outer);
}

OpenBlock& Script::open_block(const char* command) {
  const char* start = command;
  while (start > source.text.data() && start[-1] != '\n') --start;
  const SectionClock around = clock_now();
  OpenBlock& block = blocks.emplace_back();
  block.outer = indentation(between(start, command)), block.clock = around;
  return block;
}

void Script::skip_block(const char* command) {
  if (blocks.empty() || blocks.back().indent) open_block(command).skipped = true;
}

bool Script::leave_blocks(std::size_t indent) {
  bool between_both = false;
  while (!blocks.empty()) {
    OpenBlock& inner = blocks.back();
    if (!inner.indent && indent > inner.outer) inner.indent = indent;
    if (inner.indent && indent >= *inner.indent) return false;
    between_both = inner.indent && indent > inner.outer;
    blocks.pop_back(), sheet.open = false;
  }
  return between_both;
}

}  // namespace betwixt

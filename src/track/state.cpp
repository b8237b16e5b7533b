// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/state.h"

namespace betwixt {

std::size_t bytes_of(const State& s) {
  std::size_t bytes = sizeof(State);
  if (const auto* v = std::get_if<Value>(&s.is))
    if (const auto* text = std::get_if<Text>(v)) bytes += (*text)->size();
  if (const auto* table = std::get_if<State::Table>(&s.is))
    for (const State::Entry& e : *table) {
      bytes += sizeof(State::Key) + bytes_of(e.state);
      if (const auto* name = std::get_if<std::string>(&e.key)) bytes += name->size();
    }
  return bytes;
}

}  // namespace betwixt

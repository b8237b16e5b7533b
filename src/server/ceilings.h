// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The limits on what hosts may add to a document. A command that exceeds a limit is refused and changes nothing.
#pragma once

#include "scene/document.h"

namespace betwixt {

struct Ceilings {
  std::size_t environments = 2'000'000;  // without killed ones
  std::size_t objects = 3'000'000;  // with environments, and with removed objects, because the history still names them
  std::size_t events = 20'000'000;
  std::size_t history = 256 << 20;  // bytes of the accepted commands
  std::size_t values = 1 << 30;     // bytes of texts, points, lists of names, code and the contents of files
};

// Counts the events of `after`, given those of `before`. Reads only the objects that differ.
std::size_t count_events(const Objects& before, std::size_t events, const Objects& after);

// Checks the limits. A document that exceeded one before may stay as large as it was. Errors: range.
Status within(const Ceilings&, const Objects& before, std::size_t events_before, const Objects& after,
              std::size_t events_after);

}  // namespace betwixt

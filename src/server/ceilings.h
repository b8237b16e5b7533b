// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How much hosts may make of a document. What would be more is refused and changes nothing. (R-E8)
#pragma once

#include "scene/document.h"

namespace betwixt {

struct Ceilings {
  std::size_t environments = 2'000'000;  // those that are not killed
  std::size_t objects = 3'000'000;       // environments and removed ones included: history speaks of them
  std::size_t events = 20'000'000;
  std::size_t history = 256 << 20;  // bytes of the commands that were accepted
  std::size_t values = 1 << 30;     // bytes of texts, points, lists of names and code
};

// How many events there are, where `before` has so many; only what differs is looked at.
std::size_t count_events(const Scene& before, std::size_t events, const Scene& after);

// Bytes of texts, points, lists of names and code; shared values count once. Reads all objects.
std::size_t bytes_of_values(const Scene&);
Error too_many_bytes(const Ceilings&);

// Not what was there already, however much it was. Errors: range.
Status within(const Ceilings&, const Scene& before, std::size_t events_before, const Scene& after,
              std::size_t events_after);

}  // namespace betwixt

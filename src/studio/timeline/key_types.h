// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The types of handles at events (keys): how the curve passes an event. Each is a twerper of the language; handles that
// can be dragged are those of `fcurve`.
#pragma once

#include <span>

#include "studio/timeline/event_lines.h"

class QMenu;

namespace betwixt::studio {

enum class KeyType : std::uint8_t { automatic, smooth, vector, aligned, free, hold };
struct KeyTypeRow {
  KeyType type;
  const char *name, *sentence;
};
std::span<const KeyTypeRow> key_types();

// Returns the lines that give events such handles. Free handles keep the shape of the curve. Aligned ones make one line
// on both sides of their event. Segments that no handles can describe, such as those of `bounce-out`, stay.
Lines key_type_lines(const Document&, const std::vector<EventAt>&, KeyType);

void fill_key_types(QMenu&, Workspace&);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Guides of the user: lines of the world at one coordinate, to which what you move goes. They change no film, and are
// kept in the user's settings, by film.
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "betwixt/pick.h"

namespace betwixt::studio {

struct Guide {
  int axis;   // of x, y and z
  double at;  // metres
  friend bool operator==(const Guide&, const Guide&) = default;
};
using Guides = std::vector<Guide>;

QString in_words(const Guide&);                 // "x 2.5"
std::optional<Guide> guide_of(const QString&);  // the same back; nullopt: no guide
// Adds a guide, or removes it if it is there.
Guides with_or_without(Guides, const Guide&);

// The axes to the right and upwards in a view without perspective along an axis of the world; nullopt in other views.
std::optional<std::pair<int, int>> axes_of(const Projection&);

// The guides of a film's file; a film without a file keeps none.
Guides kept_guides(const std::string& file);
void keep_guides(const std::string& file, const Guides&);

}  // namespace betwixt::studio

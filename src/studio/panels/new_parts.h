// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts that can be added to a value: filters, layers, velocities, code, motions, environments. Each is lines of the
// language, with numbers that fit the values at hand.
#pragma once

#include <string>
#include <vector>

#include "studio/timeline/event_lines.h"

class QMenu;

namespace betwixt::studio {

struct NewPart {
  std::string menu;            // "Filter"; "" for the menu itself
  std::string name, sentence;  // "smooth"
  Lines lines;                 // for all targets, one step
};
// The targets are the same function of the selected objects, the leading one last.
std::vector<NewPart> new_parts(const Document&, const Program&, const std::vector<Target>&, Time);

// Fills a menu with them. Each carries out its lines, and shows them as its tooltip.
void fill_new_parts(QMenu&, Workspace&, const std::vector<NewPart>&);

}  // namespace betwixt::studio

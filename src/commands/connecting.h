// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lines between two objects, which follow them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "commands/measuring.h"
#include "scene/link_way.h"

namespace betwixt {

// The border of an object in its own space. A height of 0: a circle of this radius.
struct LinkEnd {
  std::string name;
  Vec3 middle;
  double width = 0, height = 0;  // half of its size
};
struct Link {
  std::string name;
  LinkEnd from, to;
  std::string route = "straight";  // or curved, angled; loop: from an object to itself
  std::string label;               // "": none
  LinkLabel beside;                // where the label is
  std::string color, label_color;  // as the language writes them
  bool arrow = true;
  double gap = 0.08, width = 0.04;
  double tip() const { return arrow ? 5 * width : 0; }
};
// Returns the border of an object as it was measured; nullopt if it draws nothing.
std::optional<LinkEnd> end_of_link(const Scene&, const Measured&);
// Returns half of the width that the text of a label takes, about.
double half_of_label(const std::string& text);
// Returns the lines of the language that make it: the line, its tip and its label.
std::string lines_of_link(const Link&);

}  // namespace betwixt

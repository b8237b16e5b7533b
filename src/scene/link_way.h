// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The ways of lines between two things, and the places of labels beside them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "betwixt/value.h"

namespace betwixt {

// The border of a thing: a rectangle, or a circle if its height is 0.
struct LinkBorder {
  Vec3 middle;
  double width = 0, height = 0;  // half of them
  // Returns how far the border is from the middle, in this direction.
  double reach(Vec3 way) const;
};

// Returns the way from a to b outside their borders, `gap` apart from them, and `tip` shorter at its end. `route`:
// straight, curved or angled; loop: from a to itself, at its upper right corner, where other lines seldom are.
// `metre`: a metre of the space in which the line is.
std::vector<Vec3> link_way(const LinkBorder& a, const LinkBorder& b, std::string_view route, double gap, double tip,
                           double metre = 1);

// Where a label is: at this share of the length of a line, on one of its sides. `above` and `below` go away from the
// line as directly as possible, `left` and `right` go along x, so that long labels stay between layers of nodes.
enum class LinkSide : std::uint8_t { above, below, right, left };
inline constexpr std::array<std::string_view, 4> link_sides{"above", "below", "right", "left"};
struct LinkLabel {
  double at = 0.5;
  LinkSide side = LinkSide::above;
};
// Returns the middle of a label that is 2 * half wide and 2 * half_label_height high.
Vec3 place_of_label(const std::vector<Vec3>& line, double half, LinkLabel);
inline constexpr double half_label_height = 0.12;

// What labels should keep clear of.
struct LabelSurroundings {
  std::vector<LinkBorder> nodes;
  std::vector<std::vector<Vec3>> lines;  // the label's own one too
  std::vector<LinkBorder> labels;        // those that have their places
};
// Returns where the label of a line covers no node; if there are several places, one that covers no other label, then
// few lines, then the nearest to the middle.
LinkLabel free_label(const LabelSurroundings&, const std::vector<Vec3>& line, double half);

}  // namespace betwixt

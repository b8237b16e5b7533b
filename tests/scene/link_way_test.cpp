// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the places of labels beside lines.
#include "scene/link_way.h"

#include <gtest/gtest.h>

#include <cmath>

namespace betwixt {
namespace {

const std::vector<Vec3> flat{{0, 0, 0}, {10, 0, 0}}, down{{0, 5, 0}, {0, -5, 0}}, slanted{{-3, -3, 0}, {3, 3, 0}};

TEST(LinkLabels, AreBesideTheirLines) {
  // 0.08 and half of the label away: 0.12 of its height, or half of its width.
  EXPECT_NEAR(length(place_of_label(flat, 1, {}) - Vec3{5, 0.2, 0}), 0, 1e-12);
  EXPECT_NEAR(length(place_of_label(flat, 1, {0.2, LinkSide::below}) - Vec3{2, -0.2, 0}), 0, 1e-12);
  EXPECT_NEAR(length(place_of_label(down, 1, {0.2, LinkSide::right}) - Vec3{1.08, 3, 0}), 0, 1e-12);
  EXPECT_NEAR(length(place_of_label(down, 1, {0.2, LinkSide::left}) - Vec3{-1.08, 3, 0}), 0, 1e-12);
  EXPECT_NEAR(length(place_of_label({{0, 0, 0}, {1, 0, 0}, {1, 3, 0}}, 1, {0.5, LinkSide::right}) - Vec3{2.08, 1, 0}),
              0, 1e-12);
  // Beside a line at 45 degrees a label on the right has the line at its upper left corner, with a gap of 0.08 from
  // the line to it.
  const Vec3 at = place_of_label(slanted, 1, {0.5, LinkSide::right});
  EXPECT_NEAR(at.y, 0, 1e-12);
  EXPECT_NEAR((at.x - 1 - 0.12) * std::sqrt(0.5), 0.08, 1e-12);
  EXPECT_EQ(place_of_label({}, 1, {}), (Vec3{}));
}

TEST(LinkLabels, KeepClearOfNodesThenLabelsThenLines) {
  LabelSurroundings all;
  all.lines = {flat};
  EXPECT_EQ(free_label(all, flat, 1).side, LinkSide::above);
  all.nodes = {{{5, 1, 0}, 2, 0.8}};  // above the middle
  const LinkLabel first = free_label(all, flat, 1);
  EXPECT_EQ(first.side, LinkSide::below);
  EXPECT_EQ(first.at, 0.5);
  all.labels = {{{5, -0.2, 0}, 1, 0.12}};  // the next place is taken, so it moves along the line
  const Vec3 next = place_of_label(flat, 1, free_label(all, flat, 1));
  EXPECT_TRUE(std::abs(next.x - 5) >= 2) << next.x;
  all.labels.clear();
  all.lines.push_back({{5, -3, 0}, {5, 3, 0}});  // a line through the middle
  const Vec3 beside = place_of_label(flat, 1, free_label(all, flat, 1));
  EXPECT_GE(std::abs(beside.x - 5), 1 - 1e-9);
  // Without room it still has a place.
  all.lines.pop_back();
  all.nodes = {{{5, 0, 0}, 50, 50}};
  EXPECT_EQ(free_label(all, flat, 1).at, 0.5);
}

}  // namespace
}  // namespace betwixt

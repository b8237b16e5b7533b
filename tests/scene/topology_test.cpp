// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/topology.h"

#include <gtest/gtest.h>

#include <map>

#include "scene/meshes.h"
#include "scene/primitives.h"

namespace betwixt {
namespace {

TEST(Topology, NormalsBreakAtCreases) {
  Mesh box = box_mesh();
  box.normals.clear();
  Mesh sharp = box, round = box;
  make_normals(sharp, 60 * pi / 180);
  expect_sound(sharp, "sharp box");
  EXPECT_EQ(sharp.positions.size(), 24U);
  make_normals(round, 100 * pi / 180);
  for (std::size_t i = 0; i < round.positions.size(); ++i)
    EXPECT_GT(dot(normalize(widen(round.positions[i])), widen(round.normals[i])), 0.8);  // towards the corner
}

TEST(Topology, InsideOutIsNotClosed) {
  Mesh box = box_mesh();
  for (std::size_t i = 0; i < box.triangles.size(); i += 3) std::swap(box.triangles[i], box.triangles[i + 1]);
  EXPECT_FALSE(is_closed(box));
  EXPECT_LT(signed_volume(box), 0);
  Mesh open = box_mesh();
  open.triangles.resize(open.triangles.size() - 3);
  EXPECT_FALSE(is_closed(open));
}

}  // namespace
}  // namespace betwixt

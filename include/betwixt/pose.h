// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Poses: where objects are at a time, and which parents they have at that time, for exporters that need a hierarchy.
//
// Room: program
#pragma once

#include <optional>
#include <vector>

#include "betwixt/program.h"

namespace betwixt {

struct Pose {
  ObjectId parent;  // the parent at that time, by attachment or by display list; empty if none
  AttachmentKind attachment = AttachmentKind::detach;  // how it is attached
  Mat4 world;                                          // object space to world space, all motion included
  // Object space to the parent's space: world = world of the parent * local. This holds even if the object does not
  // inherit the parent's rotation or scale. Without a parent it equals `world`. nullopt if the parent's matrix is
  // singular.
  std::optional<Mat4> local = Mat4{};
};

// Returns the identity for an object that does not exist, and for layers and environments, which have no place.
Pose pose(const Program&, ObjectId, Time);
// Returns the poses of all objects, by ObjectId::index. Evaluates only once what several of them share.
std::vector<Pose> poses(const Program&, Time);

// Returns the camera through which the film is seen at a time. Returns an empty id if the film has no camera; its
// frames then show everything.
ObjectId camera(const Program&, Time);

}  // namespace betwixt

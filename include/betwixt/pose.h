// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Poses: the places of objects at a time, and their parents then, for exporters that need a hierarchy.
//
// Room: program
#pragma once

#include <optional>
#include <vector>

#include "betwixt/program.h"

namespace betwixt {

struct Pose {
  ObjectId parent;  // its parent then, by attachment or by display list; empty if none
  AttachmentKind attachment = AttachmentKind::detach;  // how it is attached
  Mat4 world;                                          // object space to world space, all motion included
  // Object space to the parent's space: world = world of the parent * local, whichever parts of the parent's rotation
  // and scale are inherited. Without a parent it equals `world`. nullopt if the parent's matrix is singular.
  std::optional<Mat4> local = Mat4{};
};

// Returns the identity for an object that does not exist, and for layers and environments, which have no place.
Pose pose(const Program&, ObjectId, Time);
// Returns the poses of all objects, by ObjectId::index. Evaluates what they share once.
std::vector<Pose> poses(const Program&, Time);

// Returns the camera that the film is seen through at a time. The id is empty if the film has no camera; then its
// frames show everything.
ObjectId camera(const Program&, Time);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where objects are at a time, and what they hang on then: what an exporter makes a hierarchy of.
//
// Room: program
#pragma once

#include <optional>
#include <vector>

#include "betwixt/program.h"

namespace betwixt {

struct Pose {
  ObjectId parent;  // what it hangs on then, by name or by display list; none: nothing holds it
  AttachmentKind attachment = AttachmentKind::detach;  // and how
  Mat4 world;                                          // object space to the world, with all that moves it
  // Object space to the parent's: world = world of the parent * local, whatever comes through of the parent's turn and
  // scale. The world's own where there is no parent; none where the parent is flattened.
  std::optional<Mat4> local = Mat4{};
};

// Of an object that is not there, and of layers and environments, which are nowhere: the identity.
Pose pose(const Program&, ObjectId, Time);
// Of all objects, by ObjectId::index; what they share is evaluated once.
std::vector<Pose> poses(const Program&, Time);

// The camera looked through at a time; none: the film has none, and its frames show all there is to see.
ObjectId camera(const Program&, Time);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The placement of an object, by its own tracks, its parent and its environments.
#pragma once

#include "program/compiled.h"

namespace betwixt {

// The transform of a node inside its environments, and the rotation that children inherit if they do not inherit scale.
struct Placed {
  Mat4 world;
  Quat turn;
};
// The same, with the product of those environments.
struct Sited : Placed {
  Mat4 around;
  Mat4 in_world() const { return around * world; }
};

// Maps an object's position p to the world: above (kept p + attach). Also holds the inherited rotation.
struct Carrier {
  Mat4 above, kept;
  Vec3 attach;
  Quat turn;
  std::optional<Vec3> seen(Vec3 in_world) const;  // converts to a position; nullopt if a matrix is singular
};

// Returns the transform of one node, and evaluates only what it depends on. Without `turned`, only the position is
// exact.
Sited placement(const Program::Compiled&, std::uint32_t node, Time, Asking&, bool turned = true);
Vec3 place_of(const Program::Compiled&, std::uint32_t node, Time, Asking&);  // in world space
double place_of(const Program::Compiled&, std::uint32_t node, Time, Asking&, int component);
Carrier carrier_of(const Program::Compiled&, const Node&, Time, Asking&);
// Returns what the node hangs on, code included. If code makes it hang on itself, it is free.
CompiledSpan held(const Program::Compiled&, std::uint32_t node, Time, Asking&);
// Computes the transforms that a letgo or keep-world keeps: once, from the world at its time.
void thaw(const Program::Compiled&, std::int32_t frozen, Asking&);
// Returns the product of environments. `own`: the caller's set, already at that tick.
Mat4 product(const Program::Compiled&, std::int32_t siting, Time, Asking&, const EnvironmentSet* own = nullptr);
// Returns what transforms the object in its own space: its transform, then the environments that drive it. `drive`:
// their product, if known.
std::optional<Mat4> driven(const Program::Compiled&, const Node&, Time, Asking&, const Mat4* drive = nullptr);
std::optional<Mat4> moved(const Program::Compiled&, const Node&, Time, Asking&);
// Returns the world rotation that points the node's front in that direction.
Quat turned_to(const Program::Compiled&, const Node&, Vec3 direction, Time, Asking&);

// The values of an object's own transform.
struct OwnTransform {
  Quat turn;
  Vec3 scale, pivot, position, attach;
  std::optional<Mat4> own;     // applied first, in its own space
  std::optional<Mat4> motion;  // applied last, in the space of its position
};

OwnTransform said_by(const Node&, const double* numbers);
// The same for one node alone. Without `turned`, evaluates only what its position needs.
OwnTransform own_transform_at(const Program::Compiled&, const Node&, Time, Asking&, bool turned = true);
// Returns the own transform: scales and rotates about the pivot, then translates.
Placed own_place(const OwnTransform&);
// Applies the attachment. `parent`: the parent's transform at this time, for hang, attach and couple.
Placed hang(const Placed& own, Vec3 attach, const CompiledSpan*, const Frozen*, const Placed* parent);

// Returns the rotation part of a matrix that rotates and scales.
Quat turn_of(const Mat4&);
inline Mat4 linear_part(Mat4 m) {
  m(0, 3) = m(1, 3) = m(2, 3) = 0;
  return m;
}

}  // namespace betwixt

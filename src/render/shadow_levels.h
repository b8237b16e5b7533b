// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The balls around the objects that a shadow map must show.
#pragma once

#include <span>

#include "render/things.h"

namespace betwixt {

inline constexpr double widest = 2.5;  // tangent of half the largest angle of one map of a lamp

struct Ball {
  Vec3 center;
  double radius = 0;
};

Ball around(const Ball&, const Ball&);
// Return the ball around an object, and around several; centres are relative to the anchor.
Ball ball_of(const Thing&, Vec3 anchor);
Ball around_all(const Things&, std::span<const std::uint32_t> casters, Vec3 anchor);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What jumps while the shutter is open: for that, the shutter closes before the jump.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "render/columns.h"

namespace betwixt {

// Return whether two values differ by more than any speed explains within a flick.
bool far_apart(Vec3, Vec3);
bool jumps(const Camera&, const Camera&);
bool alike(const std::vector<Light>&, const std::vector<Light>&);

// The times at which the shutter closes for objects that jump: just before. By place, in order of time.
struct Closing {
  std::vector<std::pair<Time, std::vector<std::uint32_t>>> places;
  std::optional<Time> camera, lights;
};

// `breaks`: the times at which something may jump. Changes the time of the evaluation.
Closing closing(Evaluation&, const std::vector<Time>& breaks);

// The state of objects that jump, for one of the pictures: all of its pictures are before the jump.
struct Held {
  std::vector<std::pair<std::uint32_t, Content>> places;
  std::optional<Camera> camera;
  std::optional<std::vector<Light>> lights;
};

// `part`: of the time that the shutter is open, up to 1. Changes the time of the evaluation.
Held held_at(Evaluation&, Time opened, double part, const Closing&);

}  // namespace betwixt

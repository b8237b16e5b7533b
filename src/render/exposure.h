// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a film shows while the shutter is open, as states between which everything moves evenly.
//
// For objects that jump, the shutter closes before the jump, as in blur.h.
#pragma once

#include "betwixt/render.h"
#include "render/columns.h"

namespace betwixt {

// The states of a drawable, evenly spread from the opening of the shutter to its closing: one if it stays as it is.
struct Course {
  std::vector<Content> states;
  bool mixes = true;  // otherwise, each state is held for half of the time to the next one, and from the last one
};

struct Exposure {
  std::vector<Course> things;  // those that are not visible have the empty content
  std::vector<Camera> cameras;
  std::vector<std::vector<Light>> lights;
  std::optional<Vec3> background;
  Surroundings surroundings;
};

// Returns what a picture of one moment shows.
Exposure moment_of(const Columns&);

// Returns the exposure that begins at a time, with as many states as motion needs to be off by at most a quarter of a
// pixel in pictures of that size. What changes in other ways (its triangles, or whether it is visible) has at most as
// many states as there are subframes. Returns nullopt if nothing moves or is out of focus. Changes the time of the
// evaluation.
std::optional<Exposure> exposure_of(Evaluation&, Time, const Blur&, int width, int height);

// Returns the lights between two states, `share` of the way to the second one.
std::vector<Light> lights_between(const std::vector<Light>&, const std::vector<Light>&, double share);

}  // namespace betwixt

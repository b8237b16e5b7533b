// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The light that a camera sees, while the shutter is open.
#pragma once

#include "render/path_tracer.h"
#include "render/ray_camera.h"

namespace betwixt::traced {

class ExposedTracer {
 public:
  // `views`: of each camera of the exposure.
  ExposedTracer(const World&, const Exposure&, std::span<const View> views);
  bool blurs() const { return camera_.blurs(); }
  CameraSample sample(const RayChoice& choice, PixelSampler& sampler) const {
    const Ray r = camera_.ray(choice);
    const auto part = static_cast<std::size_t>(r.time * static_cast<double>(parts_.size()));
    return parts_[part].tracer->sample(r, choice.down, sampler);
  }

 private:
  // A part of the exposure, so short that light hardly changes.
  struct Part {
    View view;
    Scenery scenery;
    std::unique_ptr<const PathTracer> tracer;
  };
  RayCamera camera_;
  std::vector<Part> parts_;
};

}  // namespace betwixt::traced

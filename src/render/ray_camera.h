// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the camera's rays begin and where they go: each from its own point of the lens, at its own time while the
// shutter is open.
#pragma once

#include <span>

#include "render/traced_world.h"

namespace betwixt::traced {

// Which ray of the camera. All numbers are from 0 to 1.
struct RayChoice {
  double across = 0, down = 0;  // the place of the picture, from its left and top
  double time = 0;              // from the opening of the shutter to its closing
  double lens_x = 0, lens_y = 0;
};

class RayCamera {
 public:
  // The views and cameras at the beginning of each step of the exposure and at the end of the last one, or only one.
  // `moves`: whether anything else does.
  RayCamera(std::span<const View>, std::span<const Camera>, bool moves);
  // Whether rays differ in anything but the place of the picture.
  bool blurs() const { return blurs_; }
  // Returns the ray in eye space of the first view.
  Ray ray(const RayChoice&) const;

 private:
  struct Pose {
    View view;
    Vec3 eye;                    // from that of the first view
    double lens = 0, focus = 1;  // the radius of the lens; the distance that is sharp
  };
  struct Line {
    Vec3 from, along;  // up to the plane one metre away
  };
  Line line(const Pose&, const RayChoice&, Vec3 on_lens) const;

  std::vector<Pose> poses_;
  bool orthographic_ = false, blurs_ = false, lens_ = false;
};

}  // namespace betwixt::traced

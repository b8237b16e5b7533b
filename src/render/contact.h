// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contact shading (ambient occlusion): where objects meet, and in corners, less ambient light arrives. Computed from
// the depths of the picture, at half the resolution along each side.
#pragma once

#include "render/canvas.h"
#include "render/view.h"

namespace betwixt {

class ContactShading {
 public:
  static Result<ContactShading> create(const Canvas&);
  // Darkens opaque pixels by their share of ambient light, which is in their alpha; then alpha is 1. `bounces`: less
  // where little is closed, since what closes it sends light of its own, as in pictures under skies.
  void draw(const Canvas&, const View&, bool bounces) const;

 private:
  void set(const gl::Program&, const Canvas&, const View&) const;
  gl::Target seen_, closed_,
      smooth_;  // the drawing; the occlusion of each place, as measured and without the pattern
  gl::Program measure_, even_, darken_;
};

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contact shading: where things meet, and in corners, less of the light from everywhere arrives. It is worked out from
// the depths of what is drawn, on half as many pixels along each side.
#pragma once

#include "render/canvas.h"
#include "render/view.h"

namespace betwixt {

class ContactShading {
 public:
  static Result<ContactShading> create(const Canvas&);
  // Darkens what is solid, as far as its alpha says that it receives such light; alpha is 1 from then on.
  void draw(const Canvas&, const View&) const;

 private:
  void set(const gl::Program&, const Canvas&, const View&) const;
  gl::Target seen_, closed_,
      smooth_;  // what was drawn; how closed in each place is, as measured and without the pattern
  gl::Program measure_, even_, darken_;
};

}  // namespace betwixt

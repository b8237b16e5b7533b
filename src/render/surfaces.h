// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lit surfaces: the program that shades a point, and how things go through it.
#pragma once

#include "render/batches.h"
#include "render/lighting.h"
#include "render/shadow.h"

namespace betwixt {

class Surfaces {
 public:
  static Result<Surfaces> create();
  // Settings of a frame, for both calls below. `shadow`: of the first light, or null.
  void set(const View&, const Lighting&, const Shadow* shadow);
  void write_encoded(bool) const;  // see Canvas; linear light otherwise
  void draw_opaque(const Things&, std::span<const std::uint32_t>);
  void draw_transparent(const Things&, std::span<const std::uint32_t>);

 private:
  struct Look {  // one variant of the program
    gl::Program program;
    GLint part_color = 0, encodes = 0;
  };
  void draw_parts(const Batch&);
  void set_program(const Look&, const View&, const Lighting&, const Shadow*) const;
  Look plain_, textured_, balls_;
  Instances solid_, glass_;
};

}  // namespace betwixt

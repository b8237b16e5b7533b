// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lit surfaces: the program that shades a point, and how things go through it.
#pragma once

#include "render/batches.h"
#include "render/canvas.h"
#include "render/lighting.h"
#include "render/shadow.h"

namespace betwixt {

class Surfaces {
 public:
  static Result<Surfaces> create();
  struct Circumstances {  // of a frame
    const View& view;
    const Lighting& lighting;
    const Shadow* shadow;  // of the first light, or null
    const Surroundings& around;
  };
  void set(const Circumstances&);  // for the calls below
  void write_encoded(bool) const;  // see Canvas; linear light otherwise
  void draw_opaque(const Things&, std::span<const std::uint32_t>);
  void draw_transparent(const Things&, std::span<const std::uint32_t>);
  // The endless floor, and in what is still empty the sky, or else the gradient.
  void draw_setting(const Circumstances&, const Gradient&, bool encoded);

 private:
  struct Look {  // one variant of the program
    gl::Program program;
    GLint part_color = 0, encodes = 0;
  };
  void draw_parts(const Batch&);
  static Result<Look> new_look(bool fills, const char* defines);
  static void set_program(const Look&, const Circumstances&);
  Look plain_, textured_, balls_;
  Look ground_;  // made when it is wanted
  Instances solid_, glass_;
};

}  // namespace betwixt

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
  static Result<Surfaces> create(bool open);  // open: light does not roll off
  struct Circumstances {                      // of a frame
    const View& view;
    const Lighting& lighting;
    std::span<const Shadows::Map> shadows;  // of the first lights
    GLuint shadow_layers;                   // where these are
    const Surroundings& around;
    bool metal;    // some thing is of metal
    bool contact;  // alpha says how much contact shading what is solid receives
    bool clear;    // nothing is behind everything, and the canvas can say so
  };
  void set(const Circumstances&);  // for the calls below
  void write_encoded(bool);        // see Canvas; linear light otherwise
  void draw_opaque(const Things&, std::span<const std::uint32_t>);
  void draw_transparent(const Things&, std::span<const std::uint32_t>);
  // The endless floor, and in what is still empty the sky, or else the gradient.
  void draw_setting(const Circumstances&, const Gradient&, bool encoded);

 private:
  struct Look {  // one variant of the program
    gl::Program program;
    GLint part_color = 0, encodes = 0, receives = 0;
  };
  // Those with which a picture is drawn.
  struct Looks {
    Look plain, textured, balls;
    Look ground;  // made when it is wanted
  };
  Looks& looks() { return *variants_[variant_]; }
  // Makes them where that is needed; whether they are there.
  bool use(std::size_t variant);
  void draw_parts(const Batch&);
  void draw_depth(const Batch&);
  Result<Look> new_look(bool fills, std::size_t variant, const char* defines) const;
  Result<Looks> new_looks(std::size_t variant) const;
  void receive_contact(bool);
  static void set_program(const Look&, const Circumstances&);
  static void set_shadows(const Look&, const Circumstances&);
  static void set_mirrored(const Look&, const Circumstances&);
  // What a variant can, beside the simple ones; all made when wanted. `levels`: one light, hard, has several maps.
  static constexpr std::size_t rich = 1, contact = 2, levels = 4;
  std::array<std::optional<Looks>, 8> variants_;
  std::size_t variant_ = 0;  // which of them is set
  gl::Sampler depths_;
  Instances solid_, glass_;
  bool flat_ = false;  // nothing is lit
  bool open_ = false;
};

}  // namespace betwixt

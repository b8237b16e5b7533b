// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Lit surfaces: the shader program, and how objects are drawn with it.
#pragma once

#include <functional>

#include "render/batches.h"
#include "render/canvas.h"
#include "render/lighting.h"
#include "render/shadow.h"

namespace betwixt {

class Surfaces {
 public:
  static Result<Surfaces> create(bool unclamped);  // unclamped: light does not roll off
  struct FrameSettings {                           // of a frame
    const View& view;
    const Lighting& lighting;
    std::span<const Shadows::Map> shadows;  // of the first lights
    GLuint shadow_layers;                   // their texture
    const Surroundings& around;
    bool metal;    // whether any object is of metal
    bool contact;  // whether alpha is the share of ambient light for contact shading
    bool clear;    // whether the background is transparent, and the canvas has alpha
  };
  void set(const FrameSettings&);  // for the calls below
  void write_encoded(bool);        // see Canvas; otherwise linear light
  void draw_opaque(const Things&, std::span<const std::uint32_t>);
  void draw_transparent(const Things&, std::span<const std::uint32_t>);
  // Draws the infinite floor, and on empty pixels the sky or the gradient.
  void draw_setting(const FrameSettings&, const Backdrop&, bool encoded);

 private:
  struct Look {  // one variant of the program
    gl::Program program;
    GLint part_color = 0, encodes = 0, receives = 0;
  };
  // The programs of one picture, each made on first use: most films need one or two of them.
  struct Looks {
    Look plain, textured, balls, ground, graded, graded_textured;
    bool refused = false;  // by the graphics driver
  };
  Looks& looks() { return variants_[variant_]; }
  // Returns null if the driver refuses even the simplest program.
  const Look* need(Look Looks::*);
  void prepare(const Look&) const;
  void use(std::size_t variant);
  void draw_parts(const Things&, const Batches&, const Batch&);
  Result<Look> new_look(bool fills, std::size_t variant, const char* defines) const;
  template <class F>
  void each_made(F&&);
  void receive_contact(bool);
  static void set_program(const Look&, const FrameSettings&);
  static void set_mirrored(const Look&, const FrameSettings&);
  // The features of variants beyond the simple one; made on first use. `levels`: one light, hard, has several maps.
  static constexpr std::size_t rich = 1, contact = 2, levels = 4;
  std::array<Looks, 8> variants_;
  std::size_t variant_ = 0;               // the current one
  const FrameSettings* frame_ = nullptr;  // during a frame
  bool encodes_ = false, receives_ = false;
  gl::Sampler depths_;
  Instances solid_, glass_;
  bool flat_ = false;  // whether everything is unlit
  bool unclamped_ = false;
};

// ---- What physical surfaces (physical.h) share with these.

// Lookups for a soft shadow, distributed over a disc like the seeds of a sunflower. The software driver unrolls loops
// over arrays of 32 and fewer, which takes four times as long.
inline constexpr int shadow_seeds = 40;
std::array<float, 3 * shadow_seeds> sunflower();  // x, y, and how far it is from the middle
// Returns whether several lights, or soft ones, cast shadows.
bool has_rich_shadows(const Surfaces::FrameSettings&);
// Sets the uniforms of the shadow maps of a program.
void set_shadow_maps(const gl::Program&, const Surfaces::FrameSettings&);
// Sets the uniforms of a program that draws the floor and what is behind everything; fill_behind() draws it.
void put_setting(const gl::Program&, const Surfaces::FrameSettings&);
void fill_behind();
// Draws transparent objects, the farthest first, over what is there. `lit`: of a line that crosses itself, only the
// nearest part is drawn.
void draw_over(const Things&, const Batches&, Instances&, bool lit, const std::function<void(const Batch&)>& draw);

}  // namespace betwixt

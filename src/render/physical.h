// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Surfaces with finishes, under skies and lamps with areas: the shader programs, and how objects are drawn with them.
// A picture that has any of these is drawn by this; all others by Surfaces (surfaces.h), which costs less.
#pragma once

#include <unordered_map>

#include "render/sky_around.h"
#include "render/surfaces.h"

namespace betwixt {

// Returns whether a picture needs physical surfaces. `things`: those that may be seen.
bool needs_physical(const Things&, const Scenery&, const SkyAround&);
bool has_finishes(const Things&);  // whether a visible object has one

class PhysicalSurfaces {
 public:
  explicit PhysicalSurfaces(bool unclamped) : unclamped_(unclamped) {}
  // For the calls below. Without a sky, the ambient light is that of the lighting.
  void set(const Surfaces::FrameSettings&, SkyAround);
  // The picture that a lamp projects, by its index, or null. A picture has one such lamp. Call it before set().
  void set_slide(std::shared_ptr<const StoredTexture> slide, std::size_t light) {
    slide_ = std::move(slide), slide_light_ = light;
  }
  void write_encoded(bool);
  void draw_opaque(const Things&, std::span<const std::uint32_t>);
  void draw_transparent(const Things&, std::span<const std::uint32_t>);
  // Draws objects that let light through, over what the canvas shows so far.
  void draw_through(const Canvas&, const Things&, std::span<const std::uint32_t>);
  // Draws the infinite floor, and on empty pixels the sky or the gradient.
  void draw_setting(const Surfaces::FrameSettings&, const Backdrop&, bool encoded);

 private:
  enum Feature : unsigned {
    ball = 1,
    pictures = 2,
    projected = 4,
    pattern = 8,
    coated = 16,
    through = 32,
    ground = 64,
    areas = 128,
    shadowed = 256,
    contact = 512,
    rich = 1024,      // several shadows, or soft ones
    levels = 2048,    // several maps of one light
    projects = 4096,  // a lamp projects a picture
    gradient = 8192,
    inner = 16384  // the far walls of a clear object, from inside
  };
  struct Look {
    gl::Program program;
    std::unordered_map<std::string, GLint> places;
    std::uint64_t frame = 0;  // the frame whose settings it has
    bool refused = false;
  };
  static unsigned shadow_features(const Surfaces::FrameSettings&);
  Look* need(unsigned features);
  GLint place(Look&, const char* name);
  void set_frame(Look&);
  void set_finish(Look&, const Batch&, const Thing&, unsigned features);
  unsigned features_of(const Batch&, const StoredPart&, const Thing&) const;
  void draw_parts(const Things&, const Batches&, const Batch&, unsigned more = 0);
  void draw_batches(const Things&, const Batches&, Instances&);
  void need_sky_light();
  GLuint plain_texture(bool normals);
  void need_copy(const Canvas&);
  void draw_inner_walls(const Things&, const Batches&);

  const bool unclamped_;
  std::unordered_map<unsigned, Look> looks_;
  const Surfaces::FrameSettings* frame_ = nullptr;
  SkyAround sky_;
  std::shared_ptr<const StoredTexture> slide_;
  std::size_t slide_light_ = 0;
  std::shared_ptr<const SkyLight> sent_;
  std::array<Vec3, 9> irradiance_{};
  gl::Texture around_, seen_, white_, flat_;
  std::shared_ptr<const SkyLight> seen_of_;
  gl::Sampler depths_;
  gl::Texture behind_, behind_depth_;
  gl::Framebuffer behind_frame_;
  int behind_width_ = 0, behind_height_ = 0, behind_levels_ = 1;
  Instances solid_, glass_, clear_, inner_;
  unsigned common_ = 0;  // features of the frame
  std::uint64_t frame_number_ = 0;
  bool encodes_ = false, receives_ = false;
};

}  // namespace betwixt

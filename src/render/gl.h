// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenGL ES 3.0 without a display: a context of its own, and owners of its objects.
#pragma once

#include <GLES3/gl3.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "betwixt/render.h"
#include "betwixt/result.h"

namespace betwixt::gl {

// One OpenGL ES 3.0 context on surfaceless EGL (in pages: that of WebGL 2).
class Context {
 public:
  static Result<Context> create(Device = Device::software);  // errors: machine
  Context(Context&& o) noexcept : display_(o.display_), context_(std::exchange(o.context_, nullptr)) {}
  Context& operator=(Context&&) = delete;
  ~Context();
  bool shows() const;  // whether framebuffer 0 is visible

 private:
  friend class Current;
  Context(void* display, void* context) : display_(display), context_(context) {}
  void *display_, *context_;
};

// Makes a context current during its lifetime, then restores that of the host program.
class Current {
 public:
  explicit Current(const Context&);
  ~Current();
  Current(const Current&) = delete;
  Current& operator=(const Current&) = delete;

 private:
  void *own_, *display_, *context_, *draw_, *read_;
  unsigned api_;
};

// Owns an object of the graphics interface; frees it while its context is current.
template <void (*free)(GLuint)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint id) : id_(id) {}
  Handle(Handle&& o) noexcept : id_(std::exchange(o.id_, 0)) {}
  Handle& operator=(Handle&& o) noexcept {
    std::swap(id_, o.id_);
    return *this;
  }
  ~Handle() {
    if (id_ != 0) free(id_);
  }
  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};
void free_buffer(GLuint);
void free_texture(GLuint);
void free_renderbuffer(GLuint);
void free_framebuffer(GLuint);
void free_vertex_array(GLuint);
void free_program(GLuint);
void free_sampler(GLuint);
using Buffer = Handle<free_buffer>;
using Texture = Handle<free_texture>;
using Renderbuffer = Handle<free_renderbuffer>;
using Framebuffer = Handle<free_framebuffer>;
using VertexArray = Handle<free_vertex_array>;
using Program = Handle<free_program>;
using Sampler = Handle<free_sampler>;

Buffer new_buffer();
VertexArray new_vertex_array();
// Returns a 2-D texture with one level, without content, clamped at its edges.
Texture new_texture(GLenum format, int width, int height, GLint filter);

// A picture as a target of drawing; either texture may be absent (format 0).
struct Target {
  int width = 0, height = 0;
  Texture color, depth;
  Framebuffer framebuffer;
  void bind() const;  // sets the viewport too
};
Result<Target> new_target(GLenum color_format, GLenum depth_format, int width, int height);  // errors: machine
// The same with several samples a pixel. Read `samples` in a shader; if its id is 0, copy the picture to a Target.
struct Multisampled {
  Texture samples;
  Renderbuffer color, depth;
  Framebuffer framebuffer;
};
Result<Multisampled> new_multisampled(GLenum color_format, GLenum depth_format, int samples, int width, int height);
// Returns a texture with several samples a pixel. Its id is 0 if shaders cannot read such textures: they can from
// OpenGL ES 3.1 on, and not in pages.
Texture new_multisampled_texture(GLenum format, int samples, int width, int height);
// Returns where the samples of the bound framebuffer are, as x and y from the middle of the pixel. Not in pages.
std::vector<float> sample_places(int samples);
// Square depth maps as the layers of an array, for filtered comparison; and a framebuffer that draws into one. Errors:
// machine.
Result<std::pair<Texture, Framebuffer>> new_depth_layers(int side, int count);
// A sampler that reads depths of such maps without comparison.
Sampler new_depth_sampler();

// Compiles and links; `defines` are put at the head of both stages. Errors: machine (with the compiler's message).
Result<Program> new_program(std::string_view vertex, std::string_view fragment, std::string_view defines = {},
                            std::string_view version = "300 es");
// The vertex stage of passes over the whole picture: three corners, no input; outputs `vec2 at` in 0 to 1.
extern const std::string_view fill_vertex;
void fill();  // draws it

void use_texture(int unit, GLuint texture);
void use_layers(int unit, GLuint texture);
void use_samples(int unit, GLuint multisampled_texture);
GLint uniform(const Program&, const char* name);
// Returns whether the current context has an extension; in pages, enables it.
bool has_extension(std::string_view name);
inline constexpr GLenum framebuffer_srgb = 0x8DB9;  // of GL_EXT_sRGB_write_control
void set_samplers(const Program&, std::initializer_list<std::pair<const char*, int>> units);

}  // namespace betwixt::gl

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/gl.h"

#include <fmt/format.h>

namespace betwixt::gl {
namespace {

constexpr GLenum multisampled = 0x9100;  // GL_TEXTURE_2D_MULTISAMPLE, from OpenGL ES 3.1 on
const char* const packages = "on Debian: apt install libegl1 libgl1-mesa-dri";

Result<GLuint> compile(GLenum stage, std::string_view source, std::string_view defines, std::string_view version) {
  const std::string text = fmt::format(
      "#version {}\nprecision highp float;\nprecision highp int;\nprecision highp sampler2DArrayShadow;\n"
      "precision highp sampler2DArray;\n{}\n{}",
      version, defines, source);
  const GLuint shader = glCreateShader(stage);
  const char* const start = text.c_str();
  glShaderSource(shader, 1, &start, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  char log[1024] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  return fail(ErrorCode::machine, fmt::format("the graphics driver cannot compile a shader: {}", log), packages);
}

bool framebuffer_good() {
  return glGetError() == GL_NO_ERROR && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

Error cannot_draw(int width, int height) {
  return fail(ErrorCode::machine, fmt::format("the graphics driver cannot draw {}x{} pixels", width, height),
              "try a smaller size or fewer samples");
}

GLenum depth_attachment(GLenum format) {
  return format == GL_DEPTH24_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

}  // namespace

void free_buffer(GLuint id) { glDeleteBuffers(1, &id); }
void free_texture(GLuint id) { glDeleteTextures(1, &id); }
void free_renderbuffer(GLuint id) { glDeleteRenderbuffers(1, &id); }
void free_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
void free_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
void free_program(GLuint id) { glDeleteProgram(id); }
void free_sampler(GLuint id) { glDeleteSamplers(1, &id); }

Buffer new_buffer() {
  GLuint id = 0;
  glGenBuffers(1, &id);
  return Buffer(id);
}

VertexArray new_vertex_array() {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  return VertexArray(id);
}

Texture new_texture(GLenum format, int width, int height, GLint filter) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D, id);
  glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return Texture(id);
}

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glViewport(0, 0, width, height);
}

Result<Target> new_target(GLenum color_format, GLenum depth_format, int width, int height) {
  Target t;
  t.width = width, t.height = height;
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  t.framebuffer = Framebuffer(id);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  if (color_format != 0) {
    t.color = new_texture(color_format, width, height, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, t.color.id(), 0);
  }
  if (depth_format != 0) {
    t.depth = new_texture(depth_format, width, height, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, depth_attachment(depth_format), GL_TEXTURE_2D, t.depth.id(), 0);
  }
  if (!framebuffer_good()) return cannot_draw(width, height);
  return t;
}

Result<Multisampled> new_multisampled(GLenum color_format, GLenum depth_format, int samples, int width, int height) {
  Multisampled m;
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  m.framebuffer = Framebuffer(id);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  const auto attach = [&](GLenum format, GLenum attachment) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    return Renderbuffer(buffer);
  };
  m.samples = new_multisampled_texture(color_format, samples, width, height);
  if (m.samples.id() == 0)
    m.color = attach(color_format, GL_COLOR_ATTACHMENT0);
  else
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, multisampled, m.samples.id(), 0);
  m.depth = attach(depth_format, depth_attachment(depth_format));
  if (!framebuffer_good()) return cannot_draw(width, height);
  return m;
}

Result<std::pair<Texture, Framebuffer>> new_depth_layers(int side, int count) {
  GLuint texture = 0, framebuffer = 0;
  glGenTextures(1, &texture);
  glGenFramebuffers(1, &framebuffer);
  std::pair made{Texture(texture), Framebuffer(framebuffer)};
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
  glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_DEPTH_COMPONENT24, side, side, count);
  for (const auto& [what, how] : {std::pair{GL_TEXTURE_MIN_FILTER, GL_LINEAR},
                                  {GL_TEXTURE_MAG_FILTER, GL_LINEAR},
                                  {GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE},
                                  {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE},
                                  {GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE},
                                  {GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL}})
    glTexParameteri(GL_TEXTURE_2D_ARRAY, what, how);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, texture, 0, 0);
  if (!framebuffer_good()) return cannot_draw(side, side);
  return made;
}

Sampler new_depth_sampler() {
  GLuint id = 0;
  glGenSamplers(1, &id);
  for (const auto what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) glSamplerParameteri(id, what, GL_NEAREST);
  for (const auto what : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glSamplerParameteri(id, what, GL_CLAMP_TO_EDGE);
  glSamplerParameteri(id, GL_TEXTURE_COMPARE_MODE, GL_NONE);
  return Sampler(id);
}

Result<Program> new_program(std::string_view vertex, std::string_view fragment, std::string_view defines,
                            std::string_view version) {
  const auto v = compile(GL_VERTEX_SHADER, vertex, defines, version);
  if (!v) return v.error();
  const auto f = compile(GL_FRAGMENT_SHADER, fragment, defines, version);
  if (!f) {
    glDeleteShader(*v);
    return f.error();
  }
  Program program(glCreateProgram());
  glAttachShader(program.id(), *v);
  glAttachShader(program.id(), *f);
  glLinkProgram(program.id());
  glDeleteShader(*v);
  glDeleteShader(*f);
  GLint good = 0;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &good);
  if (good) return program;
  char log[1024] = "";
  glGetProgramInfoLog(program.id(), sizeof log, nullptr, log);
  return fail(ErrorCode::machine, fmt::format("the graphics driver cannot link a shader: {}", log), packages);
}

const std::string_view fill_vertex = R"(
out vec2 at;
void main() {
  at = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(2.0 * at - 1.0, 1.0, 1.0);
}
)";

void fill() {
  glBindVertexArray(0);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void use_texture(int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

void use_layers(int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
}

void use_samples(int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(multisampled, texture);
}

GLint uniform(const Program& program, const char* name) { return glGetUniformLocation(program.id(), name); }

void set_samplers(const Program& program, std::initializer_list<std::pair<const char*, int>> units) {
  glUseProgram(program.id());
  for (const auto& [name, unit] : units) glUniform1i(uniform(program, name), unit);
}

}  // namespace betwixt::gl

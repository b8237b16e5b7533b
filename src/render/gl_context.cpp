// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The context on surfaceless EGL.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl31.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <mutex>
#include <vector>

#include "render/gl.h"

namespace betwixt::gl {
namespace {

Error no_graphics(const char* why) {
  return fail(ErrorCode::machine, fmt::format("graphics are not available: {}", why),
              "on Debian: apt install libegl1 libgl1-mesa-dri");
}

// Returns whether a list of words, with a space between any two, has a word.
bool lists(const char* all, std::string_view word) {
  const std::string_view list = all != nullptr ? all : "";
  for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' ')) return true;
  }
  return false;
}

bool has_egl_extension(std::string_view name) { return lists(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), name); }

template <class Function>
Function function_of_extension(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

EGLDisplay display_of(EGLenum platform, void* device) {
  const auto get = function_of_extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return get != nullptr ? get(platform, device, nullptr) : EGL_NO_DISPLAY;
}

EGLDisplay surfaceless() {
  if (!has_egl_extension("EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  return display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
}

struct Displays {
  std::vector<EGLDisplay> cards, software;
};
Displays displays_of_devices() {
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  const auto query = function_of_extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto text = function_of_extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  Displays all;
  if (!has_egl_extension("EGL_EXT_platform_device") || query == nullptr || !query(16, devices, &count)) return all;
  for (EGLint i = 0; i < count; ++i) {
    const bool software = text != nullptr && lists(text(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
    (software ? all.software : all.cards).push_back(display_of(EGL_PLATFORM_DEVICE_EXT, devices[i]));
  }
  return all;
}

bool starts(EGLDisplay display) { return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr); }

EGLDisplay first_that_starts(const std::vector<EGLDisplay>& all) {
  for (const EGLDisplay display : all)
    if (starts(display)) return display;
  return EGL_NO_DISPLAY;
}

// Returns a display that has been started. The surfaceless platform takes a card if there is one, and some drivers lack
// it and have only devices.
EGLDisplay software_display() {
  const Displays all = displays_of_devices();
  if (!all.cards.empty())
    if (const EGLDisplay display = first_that_starts(all.software); display != EGL_NO_DISPLAY) return display;
  if (const EGLDisplay display = surfaceless(); starts(display)) return display;
  if (const EGLDisplay display = first_that_starts(all.cards); display != EGL_NO_DISPLAY) return display;
  return first_that_starts(all.software);
}
EGLDisplay display_after_fork() {
  const Displays all = displays_of_devices();
  return first_that_starts(all.software.empty() ? all.cards : all.software);
}

// All contexts of the process that draw with the same device share one display. It is never terminated: other threads,
// or the host program, may use it. After a fork the parent's display lacks its drawing threads, so a child opens the
// other one.
EGLDisplay open_display(Device device) {
  static std::mutex mutex;
  static EGLDisplay software = EGL_NO_DISPLAY, card = EGL_NO_DISPLAY;
  static bool looked = false;
  static pid_t owner = 0;
  static int opened = 0;
  const std::lock_guard lock(mutex);
  if (owner != ::getpid()) {
    owner = ::getpid(), ++opened, looked = false, card = EGL_NO_DISPLAY;
    software = opened == 1 ? software_display() : opened == 2 ? display_after_fork() : EGL_NO_DISPLAY;
  }
  if (device == Device::software) return software;
  if (!looked) looked = true, card = opened == 1 ? first_that_starts(displays_of_devices().cards) : EGL_NO_DISPLAY;
  return card != EGL_NO_DISPLAY || device == Device::gpu ? card : software;
}

}  // namespace

Result<Context> Context::create(Device device) {
  const EGLDisplay display = open_display(device);
  if (display == EGL_NO_DISPLAY && device == Device::gpu)
    return fail(ErrorCode::machine, "there is no graphics card that can draw without a window on this machine",
                "--device auto takes a card only if there is one");
  if (display == EGL_NO_DISPLAY) return no_graphics("EGL has no display without a window on this machine");
  const EGLenum previous = eglQueryAPI();
  if (!eglBindAPI(EGL_OPENGL_ES_API)) return no_graphics("EGL has no OpenGL ES");
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  EGLContext context = EGL_NO_CONTEXT;
  if (eglChooseConfig(display, wanted, &config, 1, &count) && count > 0)
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  eglBindAPI(previous);
  if (context == EGL_NO_CONTEXT) return no_graphics("OpenGL ES 3.0 is missing");
  return Context(display, context);
}

Context::~Context() {
  if (context_ != nullptr) eglDestroyContext(display_, context_);
}

bool Context::shows() const { return false; }

bool has_extension(std::string_view name) {
  return lists(reinterpret_cast<const char*>(glGetString(GL_EXTENSIONS)), name);
}

Texture new_multisampled_texture(GLenum format, int samples, int width, int height) {
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (major == 3 && minor == 0) return {};
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, id);
  glTexStorage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples, format, width, height, GL_TRUE);
  return Texture(id);
}

std::vector<float> sample_places(int samples) {
  std::vector<float> places;
  for (GLuint k = 0; k < static_cast<GLuint>(samples); ++k) {
    std::array<GLfloat, 2> at{};
    glGetMultisamplefv(GL_SAMPLE_POSITION, k, at.data());
    for (const float x : at) places.push_back(x - 0.5F);
  }
  return places;
}

Current::Current(const Context& c)
    : own_(c.display_),
      display_(eglGetCurrentDisplay()),
      context_(eglGetCurrentContext()),
      draw_(eglGetCurrentSurface(EGL_DRAW)),
      read_(eglGetCurrentSurface(EGL_READ)),
      api_(eglQueryAPI()) {
  eglBindAPI(EGL_OPENGL_ES_API);
  eglMakeCurrent(own_, EGL_NO_SURFACE, EGL_NO_SURFACE, c.context_);
}

Current::~Current() {
  eglMakeCurrent(own_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglBindAPI(api_);
  if (context_ != EGL_NO_CONTEXT) eglMakeCurrent(display_, draw_, read_, context_);
}

}  // namespace betwixt::gl

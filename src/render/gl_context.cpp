// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The context on surfaceless EGL.
#include <epoxy/egl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <mutex>

#include "render/gl.h"

namespace betwixt::gl {
namespace {

Error no_graphics(const char* why) {
  return fail(ErrorCode::machine, fmt::format("graphics are not available: {}", why),
              "on Debian: apt install libegl1 libgl1-mesa-dri");
}

EGLDisplay surfaceless() {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
}

// Returns the display of the last device, which is the software renderer.
EGLDisplay software() {
  EGLDeviceEXT devices[16];
  EGLint count = 0;
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") || !eglQueryDevicesEXT(16, devices, &count) ||
      count == 0)
    return EGL_NO_DISPLAY;
  return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[count - 1], nullptr);
}

// All contexts of the process share one display. It is never terminated: other threads, or the host program, may use
// it. After a fork the parent's display lacks its drawing threads, so a child opens the other one.
EGLDisplay open_display() {
  static std::mutex mutex;
  static EGLDisplay display = EGL_NO_DISPLAY;
  static pid_t owner = 0;
  static int opened = 0;
  const std::lock_guard lock(mutex);
  if (owner == ::getpid()) return display;
  owner = ::getpid();
  ++opened;
  display = opened == 1 ? surfaceless() : opened == 2 ? software() : EGL_NO_DISPLAY;
  if (display != EGL_NO_DISPLAY && !eglInitialize(display, nullptr, nullptr)) display = EGL_NO_DISPLAY;
  return display;
}

}  // namespace

Result<Context> Context::create() {
  const EGLDisplay display = open_display();
  if (display == EGL_NO_DISPLAY) return no_graphics("EGL has no surfaceless platform on this machine");
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

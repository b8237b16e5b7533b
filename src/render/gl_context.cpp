// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The context, on surfaceless EGL.
#include <epoxy/egl.h>
#include <fmt/format.h>

#include "render/gl.h"

namespace betwixt::gl {
namespace {

Error no_graphics(const char* why) {
  return fail(ErrorCode::machine, fmt::format("no graphics to be had: {}", why),
              "on Debian: apt install libegl1 libgl1-mesa-dri");
}

// All contexts of the process share one display. It is never shut down: other threads, or the host program, may be
// using it.
EGLDisplay open_display() {
  static const EGLDisplay display = [] {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return EGL_NO_DISPLAY;
    const EGLDisplay d = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return d != EGL_NO_DISPLAY && eglInitialize(d, nullptr, nullptr) ? d : EGL_NO_DISPLAY;
  }();
  return display;
}

}  // namespace

Result<Context> Context::create() {
  const EGLDisplay display = open_display();
  if (display == EGL_NO_DISPLAY) return no_graphics("EGL has no surfaceless platform here");
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

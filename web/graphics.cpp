// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The context in pages: one of WebGL 2 for all films, on a canvas of its own that nobody sees; what was drawn there is
// handed to the canvases that are seen (engine.js). So a page has as many players as it likes.
#include "graphics.h"

#include <emscripten.h>
#include <emscripten/html5_webgl.h>

#include "epoxy/gl.h"
#include "render/gl.h"

EM_JS(EMSCRIPTEN_WEBGL_CONTEXT_HANDLE, betwixt_make_context, (), {
  var canvas = Module.makeCanvas();
  if (!canvas) return 0;
  return GL.createContext(canvas, {
    majorVersion : 2,
    minorVersion : 0,
    alpha : true,
    depth : false,
    stencil : false,
    antialias : false,
    premultipliedAlpha : true,
    preserveDrawingBuffer : false,
    enableExtensionsByDefault : true
  });
})

namespace betwixt {

namespace {

EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;
unsigned made = 0;

}  // namespace

void forget_graphics() {
  if (context > 0) emscripten_webgl_destroy_context(context);
  context = 0;
}
unsigned graphics_generation() { return context > 0 ? made : 0; }

namespace gl {

Result<Context> Context::create() {
  if (context <= 0) {
    context = betwixt_make_context();
    if (context <= 0)
      return fail(ErrorCode::machine, "this browser draws no pictures: it has no WebGL 2, or it is switched off");
    ++made;
  }
  return Context(nullptr, &context);
}
Context::~Context() = default;
bool Context::shows() const { return true; }

Current::Current(const Context&) { emscripten_webgl_make_context_current(context); }
Current::~Current() = default;

}  // namespace gl
}  // namespace betwixt

bool epoxy_has_gl_extension(const char* name) {
  // Half floats are all that is drawn on, and some graphics of phones have no more than these.
  return std::string_view(name) == "GL_EXT_color_buffer_float" &&
         (emscripten_webgl_enable_extension(betwixt::context, "EXT_color_buffer_float") ||
          emscripten_webgl_enable_extension(betwixt::context, "EXT_color_buffer_half_float"));
}

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The graphics context of a page. All films share one context of WebGL 2 on a hidden canvas, and engine.js copies each
// picture to a visible one. So a page can have any number of players.
#include "graphics.h"

#include <emscripten.h>
#include <emscripten/html5_webgl.h>

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
    enableExtensionsByDefault : false  // has_extension() does it for the two that are used
  });
})

namespace betwixt {

namespace {

EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;

}  // namespace

void forget_graphics() {
  if (context > 0) emscripten_webgl_destroy_context(context);
  context = 0;
}

namespace gl {

// The browser chooses the device.
Result<Context> Context::create(Device) {
  if (context <= 0) {
    context = betwixt_make_context();
    if (context <= 0)
      return fail(ErrorCode::machine, "this browser draws no pictures: it has no WebGL 2, or it is switched off");
  }
  return Context(nullptr, &context);
}
Context::~Context() = default;
bool Context::shows() const { return true; }

Current::Current(const Context&) { emscripten_webgl_make_context_current(context); }
Current::~Current() = default;

bool has_extension(std::string_view name) {
  // Renderers draw to half floats only, and the graphics of some phones have only these.
  return name == "GL_EXT_color_buffer_float" &&
         (emscripten_webgl_enable_extension(context, "EXT_color_buffer_float") ||
          emscripten_webgl_enable_extension(context, "EXT_color_buffer_half_float"));
}

Texture new_multisampled_texture(GLenum, int, int, int) { return {}; }
std::vector<float> sample_places(int) { return {}; }

}  // namespace gl
}  // namespace betwixt

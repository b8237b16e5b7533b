// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A style is a module: it draws columns in its own way with the current context. A new style is one more file with a
// maker, and one more row in the table of renderer.cpp.
#pragma once

#include <memory>

#include "betwixt/render.h"
#include "render/canvas.h"
#include "render/columns.h"
#include "render/things.h"

namespace betwixt {

// Keeps its last picture and reuses it if nothing differs.
class Module {
 public:
  virtual ~Module() = default;
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;
  Status draw(const Columns&, Picture& out);
  struct Shown {};  // the surface of the graphics system
  Status draw(const Columns&, Shown& out);
  Status draw(const Columns&, LinearPicture& out);  // errors: range (the canvas is not linear)

 protected:
  Module(Canvas canvas, Purpose purpose)
      : canvas_(std::move(canvas)), things_(purpose, canvas_.width(), canvas_.height()) {}
  virtual void draw_anew() = 0;
  void draw(const Columns&);
  // Returns the background as a gradient; `own` is the style's, for films without one.
  Backdrop behind(const Backdrop& own) const;

  Canvas canvas_;
  Things things_;
  Scenery scenery_;
};

using MakeModule = Result<std::unique_ptr<Module>> (*)(const RenderOptions&);
Result<std::unique_ptr<Module>> make_shaded(const RenderOptions&);
Result<std::unique_ptr<Module>> make_wireframe(const RenderOptions&);
Result<std::unique_ptr<Module>> make_hidden_line(const RenderOptions&);

}  // namespace betwixt

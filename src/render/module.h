// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A style is a module: it draws columns in its own way with the context that is current. A new style is one more file
// that offers a maker, and one more row in the table of renderer.cpp.
#pragma once

#include <memory>

#include "betwixt/render.h"
#include "render/columns.h"

namespace betwixt {

class Module {
 public:
  virtual ~Module() = default;
  virtual void draw(const Columns&, Picture& out) = 0;
};

using MakeModule = Result<std::unique_ptr<Module>> (*)(const RenderOptions&);
Result<std::unique_ptr<Module>> make_shaded(const RenderOptions&);
Result<std::unique_ptr<Module>> make_wireframe(const RenderOptions&);
Result<std::unique_ptr<Module>> make_hidden_line(const RenderOptions&);

}  // namespace betwixt

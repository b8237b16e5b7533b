// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Renderers that make the pictures of others their own: they compose those of layers and of two cameras, and grade them
// (`view`, `white-balance`, `bloom`, `vignette`, `grain`). Films that need neither are drawn as if these were not
// there.
#pragma once

#include <functional>

#include "betwixt/render.h"

namespace betwixt {

using MakeRenderer = std::function<Result<std::unique_ptr<Renderer>>(const RenderOptions&)>;

// `plain`: made with the options; draws the films that need nothing else. `make_light`: makes a renderer of light when
// it is needed; its options are linear.
std::unique_ptr<Renderer> make_graded_renderer(std::unique_ptr<Renderer> plain, const RenderOptions&,
                                               MakeRenderer make_light);
std::unique_ptr<Renderer> make_composed_renderer(std::unique_ptr<Renderer> plain, const RenderOptions&,
                                                 MakeRenderer make_light);

}  // namespace betwixt

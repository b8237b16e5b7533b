// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Composes the pictures of a frame's layers, and those of two cameras, to one picture of linear light.
//
// The picture of a layer has its objects alone, before nothing. Objects of the layers around it hide its objects, but
// other layers do not: they are laid over each other, the farthest first.
#pragma once

#include <functional>

#include "betwixt/frame.h"
#include "betwixt/linear_picture.h"
#include "betwixt/result.h"

namespace betwixt {

// Draws a frame without layers, as light with opacities.
using DrawLight = std::function<Status(const Frame&, LinearPicture&)>;

inline bool is_composed(const Frame& f) { return f.change.has_value() || !f.layers.empty(); }

// Draws a frame of any kind. `width`, `height`: of the pictures that `draw` makes.
Status compose(const Frame&, int width, int height, const DrawLight& draw, LinearPicture& out);

// Lays the second picture over the first one, which then is the result.
void lay_over(LinearPicture& below, const LinearPicture& above, LayerBlend, double opacity);

}  // namespace betwixt

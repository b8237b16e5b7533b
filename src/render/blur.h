// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion blur and depth of field: averages many sharp pictures, in linear light, each at a time of its own while the
// shutter is open and from a point of its own of the lens.
//
// For objects that jump (a cut, a held value, another camera) the shutter closes before the jump, so nothing is seen
// twice. If nothing moves by itself or is out of focus, a single picture is enough. The style `traced` needs no such
// pictures (exposure.h).
#pragma once

#include <functional>

#include "betwixt/render.h"
#include "render/columns.h"

namespace betwixt {

using DrawColumns = std::function<Status(const Columns&, LinearPicture&)>;

// Returns how many pictures are needed, at most `most`; 1: nothing moves or is out of focus. Changes the time of the
// evaluation. `shutter`: seconds.
int subframes_needed(Evaluation&, Time, double shutter, int most, int width, int height);

// Like Renderer::render_blurred, for pictures that are `width` wide.
Status render_blurred(Evaluation&, Time, const Blur&, int width, int height, const DrawColumns&, LinearPicture& out);

}  // namespace betwixt

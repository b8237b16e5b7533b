// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion blur and depth of field: averages many sharp pictures, in linear light, each at a time of its own while the
// shutter is open and from a point of its own of the lens.
//
// For objects that jump (a cut, a held value, another camera) the shutter closes before the jump, so nothing is seen
// twice. If nothing moves by itself or is out of focus, a single picture is enough.
#pragma once

#include <functional>

#include "betwixt/render.h"
#include "render/columns.h"

namespace betwixt {

using DrawColumns = std::function<Status(const Columns&, LinearPicture&)>;

// Like Renderer::render_blurred, for pictures that are `width` wide.
Status render_blurred(Evaluation&, Time, const Blur&, int width, int height, const DrawColumns&, LinearPicture& out);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures that take time, through a lens: many sharp ones are added up, as light, each at a moment of its own while
// the shutter is open and through a point of its own of the lens.
//
// For what jumps meanwhile (a cut, a held value, another camera) the shutter closes before it does: nothing is seen
// twice. Where nothing moves by itself or is out of focus, one picture is all of them.
#pragma once

#include <functional>

#include "betwixt/render.h"
#include "render/columns.h"

namespace betwixt {

using DrawColumns = std::function<Status(const Columns&, DeepPicture&)>;

// As Renderer::expose, in pictures that are `width` wide.
Status expose(Evaluation&, Time, const Exposure&, int width, int height, const DrawColumns&, DeepPicture& out);

}  // namespace betwixt

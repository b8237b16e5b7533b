// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The triangles of a drawable, which may be turning into another shape.
#pragma once

#include "exchange/geometry.h"
#include "render/columns.h"

namespace betwixt {

// Returns the shape that it is turning into, or null.
inline const Shape* blend_target(const Content& p) { return p.look.blend != 0 ? p.toward.get() : nullptr; }

inline Geometry geometry_of(const Content& p, const Detail& d) {
  const Shape* const toward = blend_target(p);
  return toward != nullptr ? realise_blend(*p.shape, *toward, p.look.blend, d) : realise(*p.shape, d);
}

}  // namespace betwixt

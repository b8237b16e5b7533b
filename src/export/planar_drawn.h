// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The drawing of a shape: filled contours and stroked lines.
#pragma once

#include <memory>
#include <optional>

#include "betwixt/frame.h"
#include "scene/strokes.h"

namespace betwixt {

struct PlanarDrawn {
  std::vector<DrawnPart> filled;    // by the non-zero rule
  std::vector<DrawnPart> bordered;  // the same, in the stroke's colour
  std::vector<DrawnPart> stroked;   // lines; of each the part from `from` to `to` of its length is drawn
  double width = 0, from = 0, to = 1;
  bool round = false, hairline = false;
  std::optional<Vec3> color;                   // of the stroke, linear light; nullopt: the object's
  std::shared_ptr<const Gradients> gradients;  // null if it has none
  Box gradient_box;                            // in the shape's own space
  // Its source.
  std::shared_ptr<const Shape> shape, toward;

  bool looks_like(const PlanarDrawn&) const;
  std::size_t numbers() const;
};

// Returns the drawing in the shape's own space, or, given a matrix, as it looks from the front. nullopt: the shape is
// not flat, nor a body with a known outline.
std::optional<PlanarDrawn> drawn_of(const std::shared_ptr<const Shape>&, const std::shared_ptr<const Shape>& toward,
                                    double blend, const Mat4* seen_by = nullptr);
void carry(PlanarDrawn&, const Mat4&);
// Returns how far its front is before its centre, in its own space.
double front_of(const Shape&);

// Returns whether one blends into the other point by point: the same shape with other measures.
bool goes_over(const PlanarDrawn&, const PlanarDrawn&);
// Returns the largest distance of one from the blend at `s` of two others.
double off_between(const PlanarDrawn& a, const PlanarDrawn& b, double s, const PlanarDrawn& there);

}  // namespace betwixt

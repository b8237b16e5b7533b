// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a shape is as a drawing: contours that are filled, lines that are stroked.
#pragma once

#include <memory>
#include <optional>

#include "betwixt/frame.h"
#include "scene/strokes.h"

namespace betwixt {

struct PlanarDrawn {
  std::vector<DrawnPart> filled;    // by the non-zero rule
  std::vector<DrawnPart> bordered;  // the same, in the colour of the stroke
  std::vector<DrawnPart> stroked;   // of each there is what lies between `from` and `to`, parts of its length
  double width = 0, from = 0, to = 1;
  bool round = false, hairline = false;
  std::optional<Vec3> color;  // of the stroke, linear light; none: that of the object
  // What it comes from.
  std::shared_ptr<const Shape> shape, toward;

  bool looks_like(const PlanarDrawn&) const;
  std::size_t numbers() const;
};

// In the shape's own space; with a matrix, as that shows it from the front. None: it is no flat thing, and no body
// whose outline is known.
std::optional<PlanarDrawn> drawn_of(const std::shared_ptr<const Shape>&, const std::shared_ptr<const Shape>& toward,
                                    double blend, const Mat4* seen_by = nullptr);
void carry(PlanarDrawn&, const Mat4&);
// How far in front of its middle it is, in its own space: a line is round, and half of it lies in front of what it is
// on.
double front_of(const Shape&);

// Whether one goes over into the other point by point: they are the same thing, with other measures.
bool goes_over(const PlanarDrawn&, const PlanarDrawn&);
// How far one is at most off what lies at `s` between two that it goes over into.
double off_between(const PlanarDrawn& a, const PlanarDrawn& b, double s, const PlanarDrawn& there);

}  // namespace betwixt

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The look of a flat film over time: outlines that change, lines that are drawn on, colours, and the drawing order.
#pragma once

#include "betwixt/gradient.h"
#include "export/planar.h"

namespace betwixt {

// Lines and contours from a time on. They blend linearly to the next form, which has as many parts and points then.
struct PlanarForm {
  Time from;
  bool goes_on = false;
  std::vector<DrawnPart> parts;
};
// In order of time, from the beginning on. Empty: never visible.
using PlanarForms = std::vector<PlanarForm>;

// The visible part of each line, 0 to 1 of its length; the beginning is never after the end.
struct PlanarTrim {
  PlanarCurves from, to;
};

// A gradient over time, in the object's own space.
struct PlanarGradient {
  GradientKind kind = GradientKind::linear;
  GradientSpread spread = GradientSpread::pad;
  // Metres. Linear: where it begins, x and y, and where it ends; radial: its middle, and its half widths.
  Channel place;
  std::vector<Channel> stops;   // sRGB and opacity: as many as colours need that are mixed in linear light
  std::vector<Channel> places;  // of the stops, 0 to 1
};

struct PlanarLook {
  PlanarForms filled;    // by the non-zero rule
  PlanarForms bordered;  // the same, in the stroke's colour: strokes seen at an angle
  PlanarForms stroked;
  std::optional<PlanarTrim> trim;                                // of the stroked lines; nullopt: all of them
  Channel width;                                                 // of the stroke, metres
  bool hairline = false;                                         // the stroke has a constant width in pixels
  bool round = false;                                            // its ends and corners
  Channel color, stroke;                                         // sRGB
  Channel opacity;                                               // 0 while it is not visible
  std::optional<PlanarGradient> fill_gradient, stroke_gradient;  // in place of these colours
  bool lost_gradient = false;  // it has one that no drawing has: it goes around a point, or becomes another kind
};

struct PlanarThing {
  PlanarMotion motion;
  PlanarLook look;
};

// An object's place in the drawing order. An object that passes others has several.
struct PlanarPlace {
  std::size_t thing = 0;
  Channel shown;  // 0 or 1, held; without pieces: always
  bool first = true;
};

struct PlanarFilm {
  PlanarView view;
  std::vector<PlanarThing> things;
  std::vector<PlanarPlace> order;  // from back to front
};
// Everything that a drawing cannot hold is left out, and listed in `made`. Errors (range): those of planar_view;
// nothing would be left; outlines change so much that no player could show them.
Result<PlanarFilm> planar_film(const Program&, const ExportOptions&, Exported& made, bool in_unit = false);

// Returns the background from top to bottom: one colour, or as many stops as a gradient in linear light needs. Empty:
// no background.
std::vector<Vec3> planar_background(const Program&, const ExportOptions&);

}  // namespace betwixt

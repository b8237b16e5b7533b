// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a flat film looks like over time: outlines that change, lines that are drawn on, colours, and what lies in front
// of what.
#pragma once

#include "export/planar.h"

namespace betwixt {

// Lines and contours from a time on. It goes straight to the next one, which has as many parts and points then.
struct PlanarForm {
  Time from;
  bool goes_on = false;
  std::vector<DrawnPart> parts;
};
// By time; the first one is that of the beginning. Empty: there is never anything.
using PlanarForms = std::vector<PlanarForm>;

// Which part of each line is drawn, 0 to 1 of its length, the beginning never behind the end.
struct PlanarTrim {
  PlanarCurves from, to;
};

struct PlanarLook {
  PlanarForms filled;    // by the non-zero rule
  PlanarForms bordered;  // the same, in the colour of the stroke: strokes that are seen from aside
  PlanarForms stroked;
  std::optional<PlanarTrim> trim;  // of what is stroked; none: all of it
  Channel width;                   // of the stroke, metres
  bool hairline = false;           // the stroke is as thin as it may be, however large it is drawn
  bool round = false;              // its ends and corners
  Channel color, stroke;           // sRGB
  Channel opacity;                 // 0 where it is not seen
};

struct PlanarThing {
  PlanarMotion motion;
  PlanarLook look;
};

// A thing's place in the stack. One that comes in front of others and goes behind them has several.
struct PlanarPlace {
  std::size_t thing = 0;
  Channel shown;  // 0 or 1, held; no pieces: always
  bool first = true;
};

struct PlanarFilm {
  PlanarView view;
  std::vector<PlanarThing> things;
  std::vector<PlanarPlace> order;  // from back to front
};
// What no drawing can hold is left out, which `made` says. Errors (range): as of planar_view; nothing would be left,
// or outlines change so much that nobody could play it.
Result<PlanarFilm> planar_film(const Program&, const ExportOptions&, Exported& made, bool in_unit = false);

// What is behind everything, from top to bottom: one colour, or as many stops as an even mixture of light takes, in
// linear light. Empty: nothing is behind.
std::vector<Vec3> planar_background(const Program&, const ExportOptions&);

}  // namespace betwixt

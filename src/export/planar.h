// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What moves in the plane of a drawing, number by number, in the curves of web pages and of Lottie: a cubic over a
// time that passes evenly is a Bezier curve with its handles at thirds of the time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "betwixt/export.h"
#include "betwixt/frame.h"
#include "scene/strokes.h"

namespace betwixt {

// A number between two times. As `cubic-bezier(x1, y1, x2, y2)`: from `begin` at 0 to `end` at 1.
struct PlanarCurve {
  enum Shape : std::uint8_t { held, straight, cubic } shape = held;
  Time from, until;
  double begin = 0, end = 0;
  double y1 = 1.0 / 3, y2 = 2.0 / 3, x1 = 1.0 / 3, x2 = 2.0 / 3;
};
using PlanarCurves = std::vector<PlanarCurve>;  // by time, without gaps; at least one

// Number `component` of a channel. `in_unit`: y1 and y2 are between 0 and 1, for those who take no others.
PlanarCurves planar_curves(const Channel&, std::size_t component, bool in_unit = false);
// One whose time passes evenly (x1 = 1/3, x2 = 2/3), as two.
PlanarCurves halves(const PlanarCurve&);
double value_at(const PlanarCurves&, Time);
bool constant(const PlanarCurves&);

// One of the factors of a matrix: translations in metres, y up; turns in radians, anticlockwise.
struct PlanarStep {
  enum What : std::uint8_t { move_x, move_y, turn, grow_x, grow_y } what = move_x;
  PlanarCurves curves;
  bool nothing() const;  // always the identity
};

// Of a step's value, as pages count: pixels downwards, degrees clockwise.
double on_page(PlanarStep::What, double value, double pixels_of_a_metre);

// An object: its matrix in the picture is the product of its steps, the first one outermost. What it hangs on is among
// them.
struct PlanarMotion {
  ObjectId id;
  std::vector<PlanarStep> steps;
};

// What a drawing's film is seen by: it looks along -z.
struct PlanarView {
  double width = 16, height = 9;  // metres, at the beginning
  // What is done to the world so that it is seen, outermost first: with a growth where the camera's height changes, and
  // a turn where it rolls.
  std::vector<PlanarStep> steps;
  bool moves() const;
};
// Errors (range): the film is seen in perspective, or the camera is tilted.
Result<PlanarView> planar_view(const Program&, const ExportOptions&, bool in_unit = false);

// Of the objects that are asked for, or of all that are drawn; without the steps of the view. `out`: those that turn
// out of the plane, which have no steps; where nobody asks for these, one is an error (range).
Result<std::vector<PlanarMotion>> planar_motions(const Program&, const ExportOptions&, bool in_unit = false,
                                                 std::vector<ObjectId>* out = nullptr);

// What a trace is drawn on, and so moves with; none: the world.
ObjectId drawn_within(const Program&, ObjectId, Time);

// Its colour in sRGB, and how opaque it is (0 where it is not shown), in straight pieces.
Channel planar_color(const Program&, const ExportOptions&, ObjectId);
Channel planar_opacity(const Program&, const ExportOptions&, ObjectId);
// Pixels of the film's pictures.
std::pair<int, int> picture_size(const Document&);

// The names of objects as the word of other languages: "car/wheel" is car-wheel. No two are the same.
std::vector<std::string> plain_names(const Document&, const std::vector<ObjectId>&);
// As few digits as tell it from its neighbours in a ten-millionth.
std::string short_number(double);

}  // namespace betwixt

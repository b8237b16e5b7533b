// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Motion in the plane of a drawing, number by number, as the curves of web pages and of Lottie: a cubic with linear
// time is a Bezier curve with its handles at thirds of the time.
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
using PlanarCurves = std::vector<PlanarCurve>;  // in order of time, without gaps; at least one

// Returns number `component` of a channel. `in_unit`: limits y1 and y2 to 0 to 1, for players that need it.
PlanarCurves planar_curves(const Channel&, std::size_t component, bool in_unit = false);
// Splits a curve with linear time (x1 = 1/3, x2 = 2/3) into two.
PlanarCurves halves(const PlanarCurve&);
double value_at(const PlanarCurves&, Time);
bool constant(const PlanarCurves&);

// One of the factors of a matrix: translations in metres, y up; rotations in radians, anticlockwise.
struct PlanarStep {
  enum What : std::uint8_t { move_x, move_y, turn, grow_x, grow_y } what = move_x;
  PlanarCurves curves;
  bool nothing() const;  // whether it is always the identity
};

// Converts a step's value to the units of pages: pixels downwards, degrees clockwise.
double on_page(PlanarStep::What, double value, double pixels_of_a_metre);

// The motion of an object: its matrix in the picture is the product of its steps, the first one outermost. Those of its
// parents are included.
struct PlanarMotion {
  ObjectId id;
  std::vector<PlanarStep> steps;
};

// The view of a flat film, along -z.
struct PlanarView {
  double width = 16, height = 9;  // metres, at the beginning
  // The steps from the world to the view, outermost first: a scaling if the camera's height changes, a rotation
  // if it rolls.
  std::vector<PlanarStep> steps;
  bool moves() const;
};
// Errors (range): the film has perspective, or the camera is tilted.
Result<PlanarView> planar_view(const Program&, const ExportOptions&, bool in_unit = false);

// Returns the motions of the requested objects, or of all drawn ones, without the steps of the view. `out`: receives
// the objects that turn out of the plane, which have no steps; without `out`, one is an error (range).
Result<std::vector<PlanarMotion>> planar_motions(const Program&, const ExportOptions&, bool in_unit = false,
                                                 std::vector<ObjectId>* out = nullptr);

// Returns the object on which a trace is drawn, and with which it moves. An empty id is the world.
ObjectId drawn_within(const Program&, ObjectId, Time);

// Returns its colour in sRGB and its opacity (0 while it is not visible), in linear pieces.
Channel planar_color(const Program&, const ExportOptions&, ObjectId);
Channel planar_opacity(const Program&, const ExportOptions&, ObjectId);
// Returns the size of the film's pictures in pixels.
std::pair<int, int> picture_size(const Document&);

// Returns the names of objects as identifiers of other languages: "car/wheel" is car-wheel. No two are equal.
std::vector<std::string> plain_names(const Document&, const std::vector<ObjectId>&);
// Returns the fewest digits that distinguish it from other numbers to a ten-millionth.
std::string short_number(double);

}  // namespace betwixt

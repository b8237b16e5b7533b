// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Functions of flat shapes. Only src/scene/functions.cpp includes this; its rows come after its own.
#pragma once

#include "scene/document.h"
#include "scene/functions.h"

namespace betwixt {

inline constexpr double most_metres = 1e12;  // the limit of measures: a billion kilometres

// Returns the row as that of a length in metres, which is not negative: one number, unless the row says otherwise.
inline FunctionSpec measure(FunctionSpec row) {
  row.unit = Unit::metres, row.low = 0, row.high = most_metres;
  if (row.written.empty()) row.written = "a number";
  return row;
}

// Puts a number into a shape.
template <double Shape::*measure>
void put_measure(Shape& s, const Value& v, const Scene&) {
  s.*measure = std::get<double>(v);
}

constexpr KindBits bits_of(std::initializer_list<Kind> kinds) {
  KindBits all = 0;
  for (const Kind k : kinds) all |= bit(k);
  return all;
}
// The kinds that can have a depth, besides texts.
inline constexpr KindBits flat_kinds = bits_of(
    {Kind::disc, Kind::polygon, Kind::rectangle, Kind::ring, Kind::arc, Kind::regular, Kind::star, Kind::gear,
     Kind::arrow, Kind::area, Kind::riemann, Kind::vector_field, Kind::bar, Kind::brace, Kind::dot, Kind::video});
inline constexpr KindBits letter_kinds = bit(Kind::text) | bit(Kind::code);
inline constexpr KindBits drawn_kinds = flat_kinds | letter_kinds;
inline constexpr KindBits line_kinds =
    bits_of({Kind::polyline, Kind::curve, Kind::trace, Kind::line, Kind::plot, Kind::tangent, Kind::streamlines});

inline const FunctionSpec flat_functions[] = {
    measure({.name = "corner",
             .rest = 0.0,
             .kinds = bit(Kind::rectangle) | bit(Kind::bar) | bit(Kind::video) | bit(Kind::box),
             .shape = put_measure<&Shape::corner>,
             .sentence = "The radius of a rectangle's corners, or of a box's edges.",
             .example = "create card rectangle\nset card.corner 0.1"}),
    measure({.name = "inner",
             .rest = 0.5,
             .kinds = bit(Kind::ring),
             .shape = put_measure<&Shape::inner>,
             .sentence = "The radius of the hole in a ring.",
             .example = "create target ring\nset target.inner 0.8"}),
    measure({.name = "inner",
             .rest = 0.4,
             .kinds = bit(Kind::star),
             .shape = put_measure<&Shape::inner>,
             .sentence = "The radius of the inner corners of a star.",
             .example = "create st star\nset st.inner 0.6"}),
    measure({.name = "inner",
             .rest = 0.0,
             .kinds = bit(Kind::gear),
             .shape = put_measure<&Shape::inner>,
             .sentence = "The radius of the hole in a gear; 0: no hole.",
             .example = "create g gear\nset g.inner 0.4"}),
    {.name = "from",
     .type = Type::angle,
     .rest = 0.0,
     .kinds = bit(Kind::arc),
     .low = -1e6,
     .high = 1e6,
     .shape = put_measure<&Shape::from>,
     .sentence = "The angle at which an arc begins, anticlockwise from the right.",
     .written = "an angle",
     .example = "create part arc\nset part.from 30deg"},
    {.name = "to",
     .type = Type::angle,
     .rest = pi / 2,
     .kinds = bit(Kind::arc),
     .low = -1e6,
     .high = 1e6,
     .shape = put_measure<&Shape::to>,
     .sentence = "The angle at which an arc ends, anticlockwise from the right.",
     .written = "an angle",
     .example = "create part arc\nset part.to 180deg"},
    measure({.name = "width",
             .rest = 0.1,
             .kinds = bit(Kind::arc) | bit(Kind::arrow),
             .shape = put_measure<&Shape::width>,
             .sentence = "How wide the band of an arc is, or the shaft of an arrow.",
             .example = "create part arc\nset part.width 0.3"}),
    {.name = "sides",
     .type = Type::scalar,
     .rest = 6.0,
     .kinds = bit(Kind::regular),
     .low = 3,
     .high = 10000,
     .shape = put_measure<&Shape::sides>,
     .sentence = "How many sides a regular shape has.",
     .written = "a number",
     .example = "create cell regular\nset cell.sides 8"},
    {.name = "points",
     .type = Type::scalar,
     .rest = 5.0,
     .kinds = bit(Kind::star),
     .low = 2,
     .high = 10000,
     .shape = put_measure<&Shape::sides>,
     .sentence = "How many points (tips) a star has.",
     .written = "a number",
     .example = "create st star\nset st.points 7"},
    {.name = "teeth",
     .type = Type::scalar,
     .rest = 20.0,
     .kinds = bit(Kind::gear),
     .low = 4,
     .high = 10000,
     .shape = put_measure<&Shape::sides>,
     .sentence = "How many teeth a gear has.",
     .written = "a number",
     .example = "create g gear\nset g.teeth 12"},
    measure({.name = "module",
             .rest = 0.1,
             .kinds = bit(Kind::gear),
             .shape = put_measure<&Shape::module>,
             .sentence = "The pitch diameter of a gear in metres, divided by its number of teeth.",
             .example = "create g gear\nset g.module 0.2"}),
    {.name = "smooth",
     .type = Type::boolean,
     .rest = true,
     .kinds = bit(Kind::curve),
     .shape = [](Shape& s, const Value& v, const Scene&) { s.smooth = std::get<double>(v) != 0; },
     .sentence = "Whether a curve is smooth, or straight from point to point.",
     .written = "on or off",
     .example = "create road curve points=((0 0) (2 1) (4 0))\nset road.smooth off"},
    {.name = "closed",
     .type = Type::boolean,
     .rest = false,
     .kinds = bit(Kind::curve),
     .shape = [](Shape& s, const Value& v, const Scene&) { s.closed = std::get<double>(v) != 0; },
     .sentence = "Whether a curve is closed: its last point is joined to the first.",
     .written = "on or off",
     .example = "create road curve\nset road.closed on"},
    {.name = "to",
     .type = Type::vector,
     .rest = Vec3{1, 0, 0},
     .kinds = bit(Kind::arrow) | bit(Kind::line),
     .unit = Unit::metres,
     .low = -most_metres,
     .high = most_metres,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.size = std::get<Vec3>(v); },
     .sentence = "The end of a line, or the tip of an arrow, from its position.",
     .written = "a vector",
     .example = "create a arrow\nset a.to (2 1 0)"},
    {.name = "fill",
     .type = Type::boolean,
     .rest = true,
     .kinds = drawn_kinds,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.filled = std::get<double>(v) != 0; },
     .sentence = "Whether a flat shape is filled; if not, only its stroke is drawn.",
     .written = "on or off",
     .example = "create card rectangle\nset card.fill off"},
    {.name = "stroke",
     .type = Type::color,
     .rest = no_color,
     .kinds = drawn_kinds,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.stroke = std::get<Vec3>(v); },
     .sentence = "The color of a flat shape's outline; an unfilled shape without one uses its own color.",
     .written = "a color or none",
     .example = "create card rectangle\nset card.stroke gold"},
    measure({.name = "stroke-width",
             .rest = 0.05,
             .kinds = drawn_kinds,
             .shape = put_measure<&Shape::stroke_width>,
             .sentence = "The width of a stroke, half of it on each side of the outline.",
             .example = "create card rectangle fill=off\nset card.stroke-width 0.1"}),
    measure({.name = "dash",
             .type = Type::pair,
             .rest = Vec3{},
             .kinds = drawn_kinds | line_kinds,
             .shape =
                 [](Shape& s, const Value& v, const Scene&) {
                   const Vec3 p = std::get<Vec3>(v);
                   s.dash = p.x, s.gap = p.y;
                 },
             .sentence = "The length of the dashes of a line or stroke, and of the gaps between them.",
             .written = "(dash gap)",
             .example = "create way line to=(4 0 0)\nset way.dash (0.2 0.1)"}),
    {.name = "trim",
     .type = Type::pair,
     .rest = Vec3{0, 1, 0},
     .kinds = drawn_kinds | line_kinds,
     .low = 0,
     .high = 1,
     .shape =
         [](Shape& s, const Value& v, const Scene&) {
           const Vec3 p = std::get<Vec3>(v);
           s.trim_from = p.x, s.trim_to = p.y;
         },
     .sentence = "The part of a line or stroke that is drawn, from 0 to 1 of its length.",
     .written = "(from to)",
     .example = "create way line to=(4 0 0)\nat 1f way.trim (0 0)\nat 24f way.trim (0 1)"},
    {.name = "holes",
     .type = Type::points,
     .rest = Points(),
     .kinds = bit(Kind::polygon),
     .unit = Unit::metres,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.holes = std::get<Points>(v); },
     .sentence = "The holes of a polygon: one list of points, or a list of lists.",
     .written = "((x y) …) or (((x y) …) ((x y) …) …)",
     .example = "create frame polygon points=((0 0) (4 0) (4 4) (0 4))\nset frame.holes ((1 1) (3 1) (3 3) (1 3))"},
    {.name = "stroke-round",
     .type = Type::boolean,
     .rest = false,
     .kinds = drawn_kinds,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.stroke_round = std::get<double>(v) != 0; },
     .sentence = "Whether the corners and the ends of a stroke are round.",
     .written = "on or off",
     .example = "create card rectangle stroke=gold\nset card.stroke-round on"},
};

}  // namespace betwixt

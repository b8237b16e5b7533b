// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What flat shapes are said by; rows behind those of src/scene/functions.cpp, which alone reads this.
#pragma once

#include "scene/document.h"
#include "scene/functions.h"

namespace betwixt {

inline constexpr double most_metres = 1e12;  // measures: a metre to the power of twelve is past Pluto

// What a shape takes from a number.
template <double Shape::*measure>
void put_measure(Shape& s, const Value& v, const Scene&) {
  s.*measure = std::get<double>(v);
}

constexpr std::uint32_t bits_of(std::initializer_list<Kind> kinds) {
  std::uint32_t all = 0;
  for (const Kind k : kinds) all |= bit(k);
  return all;
}
// Those that can have a depth, besides letters.
inline constexpr std::uint32_t flat_kinds = bits_of(
    {Kind::polygon, Kind::rectangle, Kind::ring, Kind::arc, Kind::regular, Kind::star, Kind::gear, Kind::arrow});

inline const FunctionSpec flat_functions[] = {
    {.name = "corner",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::rectangle),
     .unit = Unit::metres,
     .low = 0,
     .high = most_metres,
     .shape = put_measure<&Shape::corner>,
     .sentence = "How round the corners of a rectangle are, a radius.",
     .written = "a number",
     .example = "create card rectangle\nset card.corner 0.1"},
    {.name = "inner",
     .type = Type::scalar,
     .rest = 0.5,
     .kinds = bit(Kind::ring),
     .unit = Unit::metres,
     .low = 0,
     .high = most_metres,
     .shape = put_measure<&Shape::inner>,
     .sentence = "The radius of the hole in a ring or a gear, of the inner corners of a star.",
     .written = "a number",
     .example = "create target ring\nset target.inner 0.8"},
    {.name = "inner",
     .type = Type::scalar,
     .rest = 0.4,
     .kinds = bit(Kind::star),
     .unit = Unit::metres,
     .low = 0,
     .high = most_metres,
     .shape = put_measure<&Shape::inner>},
    {.name = "inner",
     .type = Type::scalar,
     .rest = 0.0,
     .kinds = bit(Kind::gear),
     .unit = Unit::metres,
     .low = 0,
     .high = most_metres,
     .shape = put_measure<&Shape::inner>},
    {.name = "from",
     .type = Type::angle,
     .rest = 0.0,
     .kinds = bit(Kind::arc),
     .low = -1e6,
     .high = 1e6,
     .shape = put_measure<&Shape::from>,
     .sentence = "Where an arc begins, from the right on, anticlockwise; of a trace when.",
     .written = "an angle or a time",
     .example = "create part arc\nset part.from 30deg"},
    {.name = "to",
     .type = Type::angle,
     .rest = pi / 2,
     .kinds = bit(Kind::arc),
     .low = -1e6,
     .high = 1e6,
     .shape = put_measure<&Shape::to>,
     .sentence = "Where an arc ends, an angle; of an arrow its tip, a vector.",
     .written = "an angle or a vector",
     .example = "create part arc\nset part.to 180deg"},
    {.name = "width",
     .type = Type::scalar,
     .rest = 0.1,
     .kinds = bit(Kind::arc) | bit(Kind::arrow),
     .unit = Unit::metres,
     .low = 0,
     .high = most_metres,
     .shape = put_measure<&Shape::width>},
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
     .shape = put_measure<&Shape::sides>},
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
    {.name = "module",
     .type = Type::scalar,
     .rest = 0.1,
     .kinds = bit(Kind::gear),
     .unit = Unit::metres,
     .low = 0,
     .high = most_metres,
     .shape = put_measure<&Shape::module>,
     .sentence = "Of a gear, the metres of pitch diameter for each tooth.",
     .written = "a number",
     .example = "create g gear\nset g.module 0.2"},
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
     .sentence = "Whether a curve goes from its last point on to the first.",
     .written = "on or off",
     .example = "create road curve\nset road.closed on"},
    {.name = "to",
     .type = Type::vector,
     .rest = Vec3{1, 0, 0},
     .kinds = bit(Kind::arrow),
     .unit = Unit::metres,
     .low = -most_metres,
     .high = most_metres,
     .shape = [](Shape& s, const Value& v, const Scene&) { s.size = std::get<Vec3>(v); }},
};

}  // namespace betwixt

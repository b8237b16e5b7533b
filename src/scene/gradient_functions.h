// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Gradients, of fills and of strokes. Only src/scene/functions.cpp includes this.
#pragma once

#include "scene/flat_functions.h"

namespace betwixt {

// Returns a row with the type and the limits of one of the seven functions of a gradient.
inline FunctionSpec gradient_row(FunctionId of_fill, FunctionSpec row) {
  switch (of_fill) {
    case fn::gradient:
      row.type = Type::text, row.rest = Text(std::string("none")), row.words = "none|linear|radial|circular|conic";
      row.written = "none, linear, radial, circular or conic";
      break;
    case fn::gradient_color:
      row.type = Type::color, row.rest = Color{0, 0, 0}, row.written = "a color";
      break;
    case fn::gradient_stops:
      row.type = Type::text, row.rest = Text(), row.written = "\"COLOR, COLOR 40%, …\"";
      break;
    case fn::gradient_turn:
      row.type = Type::angle, row.rest = 0.0, row.low = -1e6, row.high = 1e6, row.written = "an angle";
      break;
    case fn::gradient_move:
      row.type = Type::pair, row.rest = Vec3{}, row.low = -1e6, row.high = 1e6, row.written = "(right up)";
      break;
    case fn::gradient_size:
      row.type = Type::scalar, row.rest = 1.0, row.low = 0.001, row.high = 1e6, row.written = "a number";
      break;
    default:
      row.type = Type::text, row.rest = Text(std::string("pad")), row.words = "pad|repeat|reflect";
      row.written = "pad, repeat or reflect";
  }
  return row;
}
inline FunctionSpec stroke_gradient_row(FunctionId of_fill, FunctionSpec row) {
  row.kinds = drawn_kinds;
  return gradient_row(of_fill, std::move(row));
}

inline const FunctionSpec gradient_functions[] = {
    gradient_row(fn::gradient,
                 {.name = "gradient",
                  .sentence = "How its color goes over into others across it: along a line, from its middle outwards, "
                              "or around its middle.",
                  .example = "create card rectangle color=orange\nset card.gradient linear"}),
    gradient_row(fn::gradient_color, {.name = "gradient-color",
                                      .sentence = "The second color of its gradient; the first is `color`.",
                                      .example = "create card rectangle color=orange gradient=linear\n"
                                                 "at 1f card.gradient-color purple\nat 24f card.gradient-color navy"}),
    gradient_row(
        fn::gradient_stops,
        {.name = "gradient-stops",
         .sentence = "The colors of its gradient, each with its place if you like, instead of two. `first` and "
                     "`second` are `color` and `gradient-color`.",
         .example = "create card rectangle gradient=linear\n"
                    "set card.gradient-stops \"#f60, #fc0 40%, transparent\""}),
    gradient_row(fn::gradient_turn,
                 {.name = "gradient-turn",
                  .sentence = "Where its gradient goes to, anticlockwise from the right; of a conic one, where it "
                              "begins.",
                  .example = "create card rectangle gradient=linear\nset card.gradient-turn 90deg"}),
    gradient_row(fn::gradient_move, {.name = "gradient-move",
                                     .sentence = "How far its gradient is moved, in widths and heights of the object.",
                                     .example = "create dot disc gradient=radial\nset dot.gradient-move (-0.2 0.2)"}),
    gradient_row(fn::gradient_size,
                 {.name = "gradient-size",
                  .sentence = "The length of its gradient, relative to the object; of a conic one, the part of a turn.",
                  .example = "create dot disc gradient=radial\nset dot.gradient-size 1.5"}),
    gradient_row(fn::gradient_spread,
                 {.name = "gradient-spread",
                  .sentence = "What is beyond its gradient: the color of the end, the gradient again, or again and "
                              "reflected.",
                  .example = "create card rectangle gradient=linear gradient-size=0.1\n"
                             "set card.gradient-spread reflect"}),
    stroke_gradient_row(
        fn::gradient,
        {.name = "stroke-gradient",
         .shape = [](Shape& s, const Value& v, const Scene&) { s.stroke_graded = *std::get<Text>(v) != "none"; },
         .sentence = "How the color of a stroke goes over into others across the object.",
         .example = "create card rectangle stroke=orange\nset card.stroke-gradient linear"}),
    stroke_gradient_row(fn::gradient_color,
                        {.name = "stroke-gradient-color",
                         .sentence = "The second color of a stroke's gradient; the first is `stroke`.",
                         .example = "create card rectangle stroke=orange stroke-gradient=linear\n"
                                    "set card.stroke-gradient-color navy"}),
    stroke_gradient_row(fn::gradient_stops,
                        {.name = "stroke-gradient-stops",
                         .sentence = "The colors of a stroke's gradient, as in `gradient-stops`. `first` and `second` "
                                     "are `stroke` and `stroke-gradient-color`.",
                         .example = "create card rectangle stroke-gradient=conic\n"
                                    "set card.stroke-gradient-stops \"red, gold, red\""}),
    stroke_gradient_row(fn::gradient_turn,
                        {.name = "stroke-gradient-turn",
                         .sentence = "Where a stroke's gradient goes to, anticlockwise from the right; of a conic one, "
                                     "where it begins.",
                         .example = "create card rectangle stroke-gradient=linear\n"
                                    "at 1f card.stroke-gradient-turn 0deg\nat 48f card.stroke-gradient-turn 360deg"}),
    stroke_gradient_row(fn::gradient_move,
                        {.name = "stroke-gradient-move",
                         .sentence = "How far a stroke's gradient is moved, in widths and heights of the object.",
                         .example = "create card rectangle stroke-gradient=linear\n"
                                    "set card.stroke-gradient-move (0.5 0)"}),
    stroke_gradient_row(fn::gradient_size, {.name = "stroke-gradient-size",
                                            .sentence = "The length of a stroke's gradient, relative to the object.",
                                            .example = "create card rectangle stroke-gradient=radial\n"
                                                       "set card.stroke-gradient-size 0.5"}),
    stroke_gradient_row(fn::gradient_spread,
                        {.name = "stroke-gradient-spread",
                         .sentence = "What is beyond a stroke's gradient: pad, repeat or reflect, as in "
                                     "`gradient-spread`.",
                         .example = "create card rectangle stroke-gradient=linear stroke-gradient-size=0.1\n"
                                    "set card.stroke-gradient-spread repeat"}),
};

}  // namespace betwixt

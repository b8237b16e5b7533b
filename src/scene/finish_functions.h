// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The finish of surfaces, and the shapes of lights. Only src/scene/functions.cpp includes this; its rows come after
// the first three of axes.
#pragma once

#include "scene/functions.h"

namespace betwixt {

inline FunctionSpec share_row(std::string_view name, double rest, std::string_view sentence, std::string_view example) {
  return {.name = std::string(name),
          .type = Type::scalar,
          .rest = rest,
          .low = 0,
          .high = 1,
          .sentence = sentence,
          .written = "a number from 0 to 1",
          .example = example};
}
inline FunctionSpec map_row(std::string_view name, std::string_view sentence, std::string_view example) {
  return {.name = std::string(name),
          .type = Type::text,
          .rest = Text(),
          .sentence = sentence,
          .written = "\"FILE\"",
          .example = example};
}

inline const FunctionSpec finish_functions[] = {
    share_row("metalness", 0, "How metallic its surface is: 0 is an insulator, 1 a metal, which reflects in its color.",
              "set ball.metalness 1"),
    share_row("roughness", 0.5, "How rough its surface is: 0 is a mirror, 1 is dull.", "set ball.roughness 0.2"),
    {.name = "emission",
     .type = Type::color,
     .rest = Color{0, 0, 0},
     .sentence = "The light that its surface sends out, beside what it reflects.",
     .written = "a color",
     .example = "set ball.emission orange"},
    {.name = "emission-strength",
     .type = Type::scalar,
     .rest = 1.0,
     .low = 0,
     .high = 1e6,
     .sentence = "The factor of `emission`, in linear light.",
     .written = "a number",
     .example = "set ball.emission orange\nset ball.emission-strength 4"},
    share_row("clearcoat", 0, "How much of it a clear coat covers, as on a car.", "set ball.clearcoat 1"),
    share_row("clearcoat-roughness", 0.1, "How rough the clear coat is.", "set ball.clearcoat-roughness 0.05"),
    {.name = "sheen",
     .type = Type::color,
     .rest = Color{0, 0, 0},
     .sentence = "The color of its surface at grazing angles, as of velvet.",
     .written = "a color",
     .example = "set ball.sheen #a04050"},
    share_row("sheen-roughness", 0.4, "How wide the sheen is.", "set ball.sheen-roughness 0.3"),
    share_row("transmission", 0, "How much light goes through its surface, as through glass.",
              "set ball.transmission 1"),
    {.name = "ior",
     .type = Type::scalar,
     .rest = 1.5,
     .low = 1,
     .high = 4,
     .sentence = "Its index of refraction: water has 1.33, glass 1.5, diamond 2.42.",
     .written = "a number from 1 to 4",
     .example = "set ball.ior 1.33"},
    {.name = "thickness",
     .type = Type::scalar,
     .rest = 0.0,
     .unit = Unit::metres,
     .low = 0,
     .high = 1e6,
     .sentence = "How far light goes through it, which bends and colors the light; 0: a thin wall, which does neither.",
     .written = "a length",
     .example = "set ball.transmission 1\nset ball.thickness 0.5"},
    {.name = "normal-strength",
     .type = Type::scalar,
     .rest = 1.0,
     .low = -10,
     .high = 10,
     .sentence = "The factor of the bumps of `normal-map` and of the material's own.",
     .written = "a number",
     .example = "set ball.normal-strength 0.5"},
    map_row("normal-map", "A picture of the directions of its surface (tangent space, y upwards).",
            "set ball.normal-map \"\""),
    map_row("roughness-map", "A picture whose green multiplies `roughness`.", "set ball.roughness-map \"\""),
    map_row("metalness-map", "A picture whose blue multiplies `metalness`.", "set ball.metalness-map \"\""),
    map_row("occlusion-map", "A picture whose red multiplies the light from all around.",
            "set ball.occlusion-map \"\""),
    map_row("emission-map", "A picture that multiplies `emission`.", "set ball.emission-map \"\""),
    {.name = "texture-projection",
     .type = Type::text,
     .rest = Text(std::string("auto")),
     .words = "auto|uv|box",
     .sentence =
         "Whether pictures follow its texture coordinates (`uv`), or are projected along its axes, one picture a "
         "metre (`box`). `auto`: along its axes, if it has no texture coordinates.",
     .written = "auto, uv or box",
     .example = "set ball.texture-projection box"},
    {.name = "texture-tile",
     .type = Type::pair,
     .rest = Vec3{1, 1, 0},
     .low = -1e6,
     .high = 1e6,
     .sentence = "How often pictures and patterns repeat on it, across and up.",
     .written = "(across up)",
     .example = "set ball.texture-tile (2 2)"},
    {.name = "texture-move",
     .type = Type::pair,
     .rest = Vec3{},
     .low = -1e9,
     .high = 1e9,
     .sentence = "How far pictures and patterns are moved on it, in pictures.",
     .written = "(across up)",
     .example = "set ball.texture-move (0.5 0)"},
    {.name = "texture-turn",
     .type = Type::angle,
     .rest = 0.0,
     .sentence = "How far pictures and patterns are turned on it.",
     .written = "an angle",
     .example = "set ball.texture-turn 45deg"},
    // Of lights.
    {.name = "shape",
     .type = Type::text,
     .rest = Text(std::string("point")),
     .kinds = bit(Kind::light),
     .words = "point|disc|rectangle",
     .instead = {{"area", "shape=rectangle size=(2 1), or shape=disc"},
                 {"spot", "cone=40deg makes a lamp a spotlight"}},
     .sentence = "The shape of a lamp: a point, or an area that shines to its front (its local -z).",
     .written = "point, disc or rectangle",
     .example = "set lamp.shape rectangle"},
    {.name = "size",
     .type = Type::pair,
     .rest = Vec3{1, 1, 0},
     .kinds = bit(Kind::light),
     .unit = Unit::metres,
     .low = 0,
     .high = 1e6,
     .sentence = "The width and the height of a lamp with an area.",
     .written = "(width height)",
     .example = "set lamp.shape rectangle\nset lamp.size (2 1)"},
    {.name = "cone",
     .type = Type::angle,
     .rest = 0.0,
     .kinds = bit(Kind::light),
     .low = 0,
     .high = 3.1,
     .sentence = "The whole angle of the cone in which a lamp shines, to its front (its local -z); 0: everywhere.",
     .written = "an angle",
     .example = "set lamp.cone 40deg"},
    [] {
      FunctionSpec edge =
          share_row("cone-edge", 0.2, "How much of the cone is its soft edge.", "set lamp.cone-edge 0.5");
      edge.kinds = bit(Kind::light);
      return edge;
    }(),
    [] {
      FunctionSpec picture =
          map_row("picture", "The picture that a lamp with a cone projects.", "set lamp.picture \"\"");
      picture.kinds = bit(Kind::light);
      return picture;
    }(),
};

}  // namespace betwixt

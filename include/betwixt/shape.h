// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What kinds of objects there are, and what they look like in their own space.
//
// Room: scene
#pragma once

#include <memory>

#include "betwixt/mesh.h"
#include "betwixt/value.h"

namespace betwixt {

enum class Kind : std::uint8_t {
  group,
  sphere,
  box,
  cylinder,
  cone,
  torus,
  plane,
  disc,
  polygon,
  polyline,
  points,
  text,
  mesh,
  light,
  camera,
  layer,        // no object of the scene: what it holds is laid over the tracks of others
  environment,  // no object of the scene: a matrix that others are moved by
  rectangle,
  ring,
  arc,
  regular,
  star,
  gear,
  arrow,
  curve,
  trace,
  line,
  sound  // nothing that is seen
};

// How letters look, beside their font, and how many of them are seen, blanks and ends of lines counted.
enum class Align : std::uint8_t { left, centre, right };
enum class Weight : std::uint8_t { thin, extralight, light, regular, medium, semibold, bold, extrabold, black };
struct Letters {
  Align align = Align::centre;
  Weight weight = Weight::regular;
  bool italic = false;
  std::uint32_t typed = 20'000;
  friend bool operator==(const Letters&, const Letters&) = default;
};

struct Outline;  // src/scene/outline.h

// What an object looks like in its own space, as a description; src/render turns it into triangles.
//   sphere   radius, about the origin              disc      radius, in the plane z = 0, facing +z
//   box      size, about the origin                plane     size x by y, in the plane z = 0, facing +z
//   cylinder cone   radius, height along y, about the origin (a cone's tip up)
//   torus    radius of the ring, tube: radius of the tube; the ring lies in the plane y = 0
//   polygon  points, filled; holes: rings, one behind the other, each up to where its first point comes again
//   polyline points, width (0: a hairline)         line      from the origin to `size`, width
//   points   points, each drawn as a ball of diameter `width`
//   text     text, font, letters, size.y = height of one line (em) in metres, depth along z; the first baseline at
//            y = 0, x = 0 by how it is aligned; or `formula` in place of the text
//   mesh     mesh
// Flat shapes lie in the plane z = 0, facing +z, about the origin; `depth` along z.
//   rectangle size x by y, corner: radius of its corners
//   ring     radius, inner: between these        arc      radius, width, from and to: angles from +x on, anticlockwise
//   regular  sides, radius of its corners, the first one up          star     sides: points, radius, inner
//   gear     sides: teeth, module: metres of pitch diameter for each; involutes of 20 degrees
//   arrow    from the origin to `size`, width
//   trace    points, width: what a point has drawn
//   curve    through its points, smooth (Catmull-Rom) or straight, closed or not; width as a polyline's
// All flat ones and texts: filled or not, and a stroke along the contours, centred on them, pointed or round
// at corners and ends. Of it, and of lines and
// arcs themselves, there is what lies from `trim_from` to `trim_to`, parts of the length of each contour, and of that
// `dash` metres, then none for `gap` metres, and so on.
struct Shape {
  Kind kind = Kind::group;
  Vec3 size{1, 1, 1};
  double radius = 1, height = 1, tube = 0.3, width = 0, depth = 0;
  double inner = 0, corner = 0, from = 0, to = 0, sides = 0, module = 0;
  bool smooth = true, closed = false;
  double stroke_width = 0, dash = 0, gap = 0, trim_from = 0, trim_to = 1;
  Vec3 stroke{-1, -1, -1};  // linear light; all below 0: none was said
  bool filled = true, stroke_round = false;
  Points points, holes;
  Text text, font;
  Letters letters;
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const Outline> formula;  // as TeX sets it, at 1 m an em; shared by all that say it
  friend bool operator==(const Shape&, const Shape&) = default;
};
// Its numbers beside the size: what blends from shape to shape, and what meshes are made to.
inline constexpr double Shape::*shape_measures[] = {&Shape::radius, &Shape::height, &Shape::tube,   &Shape::width,
                                                    &Shape::depth,  &Shape::inner,  &Shape::corner, &Shape::from,
                                                    &Shape::to,     &Shape::sides,  &Shape::module};

// plastic: a highlight from shininess; matte: none; metal: highlights and reflections in its own colour; glow: shines
// by itself, unlit.
enum class Material : std::uint8_t { plastic, matte, metal, glow };

}  // namespace betwixt

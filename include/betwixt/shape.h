// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Kinds of objects, and their shapes in object space.
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
  layer,        // not in the scene: its tracks are combined with those of objects
  environment,  // not in the scene: a matrix that moves other objects
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
  sound,  // not visible
  axes,   // these four have no shape: the objects below them are their pieces
  number_line,
  polar_axes,
  plane_grid,
  plot,
  area,
  riemann,
  tangent,
  vector_field,
  bars,  // these three and the next but one have no shape
  columns,
  pie,
  bar,
  table,
  matrix,
  brace,
  code,
  diagram,  // has no shape
  scatter,
  streamlines,
  surface,
  line_chart,  // it has no shape
  dot,
  video
};

// The style of letters besides their font. `typed` is the number of visible letters; it counts blanks and line ends.
// `wrap` is the width in metres at which lines break; with 0 they break at line ends only. `anchor` tells what is at
// y = 0: the first baseline, the top of the first line's capitals, the last baseline, or the middle between those two.
enum class Align : std::uint8_t { left, centre, right };
enum class Anchor : std::uint8_t { baseline, top, middle, bottom };
enum class Weight : std::uint8_t { thin, extralight, light, regular, medium, semibold, bold, extrabold, black };
struct Letters {
  Align align = Align::centre;
  Weight weight = Weight::regular;
  bool italic = false;
  std::uint32_t typed = 20'000;
  Anchor anchor = Anchor::baseline;
  double wrap = 0;
  friend bool operator==(const Letters&, const Letters&) = default;
};

struct Outline;  // src/scene/outline.h
struct OwnFont;  // src/scene/own_font.h

// The description of a shape in object space; src/render turns it into triangles. Lengths are in metres.
//   sphere   radius, about the origin              disc      radius, in the plane z = 0, facing +z
//   box      size, about the origin                plane     size x by y, in the plane z = 0, facing +z
//   cylinder cone   radius, height along y, about the origin (a cone's tip up)
//   torus    radius of the ring, tube: radius of the tube; the ring is in the plane y = 0
//   polygon  points, filled; holes: rings, one after the other; each ends where its first point is repeated
//   polyline points, width (0: a hairline)         line      from the origin to `size`, width
//   points   points, each drawn as a ball of diameter `width`
//   text     text, font, letters, size.y = height of one line (em) in metres, depth along z; the first baseline is
//            y = 0; x = 0 is the left end, centre or right end (`align`). If `formula` is set, it replaces the text
//   mesh     mesh
// Flat shapes are in the plane z = 0, face +z and have their centre at the origin; `depth` is along z.
//   rectangle size x by y, corner: radius of its corners (also of a box: of its edges)
//   ring     radius, inner: between these        arc      radius, width, from and to: angles from +x, anticlockwise
//   regular  sides, radius of its corners, the first one up          star     sides: points, radius, inner
//   gear     sides: teeth, module: metres of pitch diameter for each; involutes of 20 degrees
//   arrow    from the origin to `size`, width
//   trace    points, width: the line that a point has drawn
//   video    height, size: that of its pictures relative to their height, corner
//   plot tangent  points, width      scatter  points, each drawn as a disc (a ball if they are in space) of diameter
//   `width` streamlines   points, width: lines one behind the other      surface  mesh      dot  radius area riemann
//   vector_field  points: rings, one behind the other; they may be broken bar      size x by y, growing from its side
//   at x or y = 0 brace    from the origin to `size`, its tip `height` to the right of the way curve    through its
//   points, smooth (Catmull-Rom) or straight, closed or not; width as for polyline
// In a list of points, one that is not finite lifts the pen: the line or ring ends before it, and another begins after.
// Flat shapes and texts may be filled, and may have a stroke centred on their contours. The corners and ends of the
// stroke are pointed or round. Of a stroke, a line or an arc, only the part from `trim_from` to `trim_to` is drawn;
// these are shares of the length of each contour. This part has dashes of `dash` metres with gaps of `gap` metres.
struct Shape {
  Kind kind = Kind::group;
  Vec3 size{1, 1, 1};
  double radius = 1, height = 1, tube = 0.3, width = 0, depth = 0;
  double inner = 0, corner = 0, from = 0, to = 0, sides = 0, module = 0;
  bool smooth = true, closed = false;
  double stroke_width = 0, dash = 0, gap = 0, trim_from = 0, trim_to = 1;
  Vec3 stroke{-1, -1, -1};  // its colour in linear light; all below 0: that of the object
  bool filled = true, stroke_round = false;
  bool stroke_graded = false;  // a gradient colours the stroke, so that it is drawn without a colour of its own
  Points points, holes;
  Text text, font;
  Text language;  // of code, whose words are parts (src/scene/code_languages.h); "": a plain text
  std::shared_ptr<const OwnFont> own_font;  // a font that the film brings as a file; nullptr: one of the machine's
  Letters letters;
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const Outline> formula;  // with an em of 1 m; shared by all shapes with the same text
  // Of a formula or of code: parts, one a line. Only they are drawn (`only_parts`), or everything else.
  Text parts;
  bool only_parts = false;
  bool matches = false;  // while it turns into another text, signs go to equal signs
  friend bool operator==(const Shape&, const Shape&) = default;
};
// The measures besides the size. Shapes blend them in a morph, and meshes depend on them.
inline constexpr double Shape::*shape_measures[] = {&Shape::radius, &Shape::height, &Shape::tube,   &Shape::width,
                                                    &Shape::depth,  &Shape::inner,  &Shape::corner, &Shape::from,
                                                    &Shape::to,     &Shape::sides,  &Shape::module};

// plastic: a highlight that depends on shininess. matte: no highlight. metal: highlights and reflections in its own
// colour. glow: emits its colour, unlit.
enum class Material : std::uint8_t { plastic, matte, metal, glow };

}  // namespace betwixt

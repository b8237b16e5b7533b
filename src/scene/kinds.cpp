// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/flat_shapes.h"
#include "scene/kind_extents.h"
#include "scene/primitives.h"
#include "scene/strokes.h"

namespace betwixt {
namespace {

// ---- Triangles

Vec3 even_measures(const Shape& s) { return {s.radius, s.radius, s.radius}; }
Vec3 box_measures(const Shape& s) { return s.size; }
Vec3 plane_measures(const Shape& s) { return {s.size.x, s.size.y, std::max(s.size.x, s.size.y)}; }
Vec3 round_measures(const Shape& s) { return {s.radius, s.height, s.radius}; }

// Returns a radius relative to the largest measure from the centre.
double share_of(double radius, const Extent& all) {
  const Vec3 half = all.half();
  return radius / std::max({half.x, half.y, half.z, radius, 1e-300});
}

Mesh ring_mesh(const Shape& s, const Detail& d) {
  if (!(s.tube > 0) || !(s.radius >= 0) || !sane(s.tube) || !sane(s.radius)) return {};
  const int across = d.even ? d.around / 2 : d.around_thin(s.tube / (s.radius + s.tube));
  return torus_mesh(s.radius, s.tube, d.around, across);
}
Mesh stroke_mesh(const Shape& s, const Detail& d) {
  if (!sane(s.width)) return {};
  const int around = d.even ? 8 + d.around / 48 * 4 : d.around_thin(share_of(s.width / 2, whole_line(s)));
  std::vector<Mesh> parts;
  for (const auto& part : drawn_lines(s))
    parts.push_back(s.width > 0 ? tube_mesh(part, s.width, around) : line_mesh(part));
  return joined(std::move(parts));
}
Mesh cloud_mesh(const Shape& s, const Detail& d) {
  if (!sane(*s.points) || !sane(s.width) || !(s.width > 0)) return {};
  // Fewer triangles for each if there are many: together they may be millions.
  if (s.points->size() > 20000) return balls_mesh(*s.points, s.width, sphere_mesh(4, 2));
  const int around = d.even ? d.around / 3 : d.around_thin(share_of(s.width / 2, of_points(s)));
  return balls_mesh(*s.points, s.width, sphere_mesh(around, around / 2));
}

// ---- The rows

// Returns the row of a flat shape, the area of its contours, which can have a depth.
template <auto contours>
constexpr KindRow flat(KindRow row) {
  row.fill = Fill::outline, row.deep = true;
  row.extent = of_contours<contours>, row.contours = contours;
  return row;
}

constexpr KindRow kind_rows[] = {
    {.kind = Kind::group,
     .name = "group",
     .sentence = "An object without a shape, to which you attach others.",
     .example = "create hand2 group position=(0 1 0)"},
    {.kind = Kind::sphere,
     .name = "sphere",
     .sentence = "A ball.",
     .written = "radius=1",
     .example = "create s sphere radius=2",
     .functions = "radius",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_ball,
     .reach = ball_reach,
     .measures = even_measures,
     .mesh = [](const Shape&, const Detail& d) { return sphere_mesh(d.around, d.around / 2); }},
    {.kind = Kind::box,
     .name = "box",
     .sentence = "A box.",
     .written = "size=(1 1 1)",
     .example = "create b box size=(2 1 1)",
     .fill = Fill::surface,
     .extent = of_box,
     .measures = box_measures,
     .mesh = [](const Shape&, const Detail&) { return box_mesh(); }},
    {.kind = Kind::cylinder,
     .name = "cylinder",
     .sentence = "A cylinder along y.",
     .written = "radius=1 height=1",
     .example = "create c cylinder radius=0.5 height=2",
     .functions = "radius height",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_round,
     .reach = cylinder_reach,
     .measures = round_measures,
     .mesh = [](const Shape&, const Detail& d) { return cylinder_mesh(d.around); }},
    {.kind = Kind::cone,
     .name = "cone",
     .sentence = "A cone along y.",
     .written = "radius=1 height=1",
     .example = "create c cone height=2",
     .functions = "radius height",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_round,
     .measures = round_measures,
     .mesh = [](const Shape&, const Detail& d) { return cone_mesh(d.around); }},
    {.kind = Kind::torus,
     .name = "torus",
     .sentence = "A round tube in the shape of a ring, about y.",
     .written = "radius=1 tube=0.3",
     .example = "create ring torus tube=0.1",
     .functions = "radius",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_ring,
     .reach = ring_reach,
     .mesh = ring_mesh},
    {.kind = Kind::plane,
     .name = "plane",
     .sentence = "A flat rectangle.",
     .written = "size=(1 1)",
     .example = "create floor plane size=(20 20)",
     .ground = true,
     .fill = Fill::surface,
     .extent = of_plane,
     .measures = plane_measures,
     .mesh = [](const Shape&, const Detail&) { return plane_mesh(); }},
    {.kind = Kind::disc,
     .name = "circle",
     .sentence = "A filled circle.",
     .written = "radius=1",
     .example = "create dot circle radius=3",
     .functions = "radius",
     .fill = Fill::surface,
     .deep = true,
     .detailed = true,
     .extent = of_disc,
     .reach = disc_reach,
     .measures = even_measures,
     .mesh = [](const Shape&, const Detail& d) { return disc_mesh(d.around); },
     .contours = disc_contours},
    flat<polygon_contours>({.kind = Kind::polygon,
                            .name = "polygon",
                            .sentence = "A filled outline.",
                            .written = "points=((x y) …) holes=()",
                            .example = "create p polygon points=((0 0) (2 0) (1 2))",
                            .functions = "points"}),
    {.kind = Kind::polyline,
     .name = "polyline",
     .sentence = "A line through points.",
     .written = "points=((x y) …) width=0.05",
     .example = "create l polyline points=((0 0) (2 0) (1 2)) width=0.1",
     .functions = "points",
     .fill = Fill::surface,
     .line = true,
     .detailed = true,
     .extent = of_line,
     .mesh = stroke_mesh},
    {.kind = Kind::curve,
     .name = "curve",
     .sentence = "A line through points, smooth or straight; objects can move along it.",
     .written = "points=((x y) …) width=0.05 smooth=on closed=off",
     .example = "create road curve points=((0 0) (2 1) (4 0)) closed=on",
     .functions = "points",
     .fill = Fill::surface,
     .line = true,
     .detailed = true,
     .extent = of_line,
     .mesh = stroke_mesh},
    {.kind = Kind::trace,
     .name = "trace",
     .sentence = "The path that a point of an object has drawn until now.",
     .written = "of=NAME from=1f until=… last=0 point=(0 0 0) within=none width=0.05",
     .example = "create t trace of=ball from=1f width=0.02 color=red",
     .fill = Fill::surface,
     .line = true,
     .detailed = true,
     .extent = of_line,
     .mesh = stroke_mesh},
    {.kind = Kind::points,
     .name = "points",
     .article = "a cloud of",
     .sentence = "A cloud of points.",
     .written = "points=((x y z) …) size=0.05",
     .example = "create stars points points=((0 0 0) (1 2 3)) size=0.1",
     .functions = "points",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_points,
     .mesh = cloud_mesh},
    {.kind = Kind::text,
     .name = "text",
     .sentence = "Letters, flat or with a depth.",
     .written = "text=\"…\" font=\"DejaVu Sans\" weight=regular slant=upright size=1 align=centre",
     .example = "create title text text=\"The end\" size=2",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_text},
    {.kind = Kind::mesh,
     .name = "mesh",
     .sentence = "A shape from a file below the script's folder.",
     .written = "file=\"…\" texture=\"…\"",
     .example = "create tree mesh file=\"tree.obj\"",
     .fill = Fill::file,
     .extent = of_mesh},
    flat<rectangle_contours>({.kind = Kind::rectangle,
                              .name = "rectangle",
                              .sentence = "A flat rectangle; its corners may be round.",
                              .written = "size=(1 1) corner=0",
                              .example = "create card rectangle size=(3 2) corner=0.2"}),
    flat<ring_contours>({.kind = Kind::ring,
                         .name = "ring",
                         .sentence = "A flat ring.",
                         .written = "radius=1 inner=0.5",
                         .example = "create target ring radius=2 inner=1.8",
                         .functions = "radius"}),
    flat<arc_contours>({.kind = Kind::arc,
                        .name = "arc",
                        .article = "an",
                        .sentence = "A flat part of a ring, anticlockwise from the right.",
                        .written = "radius=1 from=0deg to=90deg width=0.1",
                        .example = "create part arc radius=2 to=120deg width=0.3",
                        .functions = "radius",
                        .line = true}),
    flat<regular_contours>({.kind = Kind::regular,
                            .name = "regular",
                            .sentence = "A regular polygon (all sides and angles equal), one corner up.",
                            .written = "sides=6 radius=1",
                            .example = "create cell regular sides=6 radius=2",
                            .functions = "radius"}),
    flat<star_contours>({.kind = Kind::star,
                         .name = "star",
                         .sentence = "A flat star, one point up.",
                         .written = "points=5 radius=1 inner=0.4",
                         .example = "create st star points=7 inner=0.6",
                         .functions = "radius"}),
    flat<gear_contours>({.kind = Kind::gear,
                         .name = "gear",
                         .sentence = "A flat gear wheel; wheels of one module mesh.",
                         .written = "teeth=20 module=0.1 inner=0",
                         .example = "create g gear teeth=12 module=0.2"}),
    flat<arrow_contours>({.kind = Kind::arrow,
                          .name = "arrow",
                          .article = "an",
                          .sentence = "A flat arrow from its position on.",
                          .written = "to=(1 0 0) width=0.1",
                          .example = "create a arrow to=(2 1 0)"}),
    {.kind = Kind::line,
     .name = "line",
     .sentence = "A straight line from its position on.",
     .written = "to=(1 0 0) width=0.05",
     .example = "create l line to=(2 1 0) width=0.1",
     .fill = Fill::surface,
     .line = true,
     .detailed = true,
     .extent = of_line,
     .mesh = stroke_mesh},
    {.kind = Kind::axes,
     .name = "axes",
     .article = "a set of",
     .sentence = "Coordinates: two axes with ticks and numbers, or three; other objects are on them by `on`.",
     .written =
         "x=(-5 5) y=(-3 3) size=(8 4.8) grid=off numbers=on x-title=\"\" y-title=\"\" x-scale=linear y-scale=linear",
     .example = "create ax axes x=(0 10 2) y=(0 1) size=(8 4)"},
    {.kind = Kind::number_line,
     .name = "number-line",
     .sentence = "One axis with ticks and numbers.",
     .written = "x=(-5 5) length=8 numbers=on x-title=\"\" x-scale=linear",
     .example = "create ax number-line x=(0 10)"},
    {.kind = Kind::polar_axes,
     .name = "polar-axes",
     .article = "a set of",
     .sentence = "Coordinates of a distance and an angle.",
     .written = "r=(0 3) radius=2.5 grid=off numbers=on",
     .example = "create ax polar-axes r=(0 2)"},
    {.kind = Kind::plane_grid,
     .name = "plane-grid",
     .sentence = "A grid that a linear map deforms; `right` and `up` are the columns of its matrix.",
     .written = "x=(-5 5) y=(-3 3) size=(8 4.8) right=(1 0) up=(0 1) numbers=on",
     .example = "create plane plane-grid right=(1 0.5)"},
    {.kind = Kind::plot,
     .name = "plot",
     .sentence = "The graph of a formula on axes: of x, of u if it is a vector, or an equation of x and y.",
     .written = "on=AXES of=\"x\" from=0 to=0 width=0.05",
     .example = "create ax axes\ncreate f plot on=ax of=\"sin(x - t)\"",
     .functions = "points",
     .fill = Fill::surface,
     .line = true,
     .detailed = true,
     .extent = of_line,
     .mesh = stroke_mesh},
    flat<broken_contours>({.kind = Kind::area,
                           .name = "area",
                           .article = "an",
                           .sentence = "The area between the graph of a formula and its base.",
                           .written = "on=AXES of=\"x\" base=\"0\" from=0 to=0",
                           .example = "create ax axes\ncreate a area on=ax of=\"x^2 / 4\" to=2",
                           .functions = "points"}),
    flat<broken_contours>({.kind = Kind::riemann,
                           .name = "riemann",
                           .sentence = "The rectangles of a Riemann sum under the graph of a formula.",
                           .written = "on=AXES of=\"x\" from=0 to=0 count=8 touch=left",
                           .example = "create ax axes\ncreate sum riemann on=ax of=\"x^2 / 4\" count=10",
                           .functions = "points"}),
    {.kind = Kind::tangent,
     .name = "tangent",
     .sentence = "A tangent of the graph of a formula, or a secant.",
     .written = "on=AXES of=\"x\" at=0 step=0 length=3 width=0.05",
     .example = "create ax axes\ncreate d tangent on=ax of=\"x^2 / 4\" at=1",
     .functions = "points",
     .fill = Fill::surface,
     .line = true,
     .detailed = true,
     .extent = of_line,
     .mesh = stroke_mesh},
    flat<broken_contours>({.kind = Kind::vector_field,
                           .name = "vector-field",
                           .sentence = "Arrows that show a vector at each place of axes.",
                           .written = "on=AXES of=\"vec(-y, x)\" density=14",
                           .example = "create ax axes\ncreate v vector-field on=ax of=\"vec(y, -sin(x))\"",
                           .functions = "points"}),
    {.kind = Kind::bars,
     .name = "bars",
     .article = "a chart of",
     .sentence = "A chart of bars that grow to the right.",
     .written = "of=(NUMBER …) keys=(\"…\" …) size=(6 4) range=(0 0) gap=0.25 sorted=off",
     .example = "create b bars of=(3 1 4) keys=(\"Ann\" \"Bob\" \"Cyd\")"},
    {.kind = Kind::columns,
     .name = "columns",
     .article = "a chart of",
     .sentence = "A chart of bars that grow upwards.",
     .written = "of=(NUMBER …) keys=(\"…\" …) size=(6 4) range=(0 0) gap=0.25 sorted=off",
     .example = "create b columns of=(3 1 4) keys=(\"Ann\" \"Bob\" \"Cyd\")"},
    flat<bar_contours>({.kind = Kind::bar,
                        .name = "bar",
                        .sentence = "A bar of a chart.",
                        .written = "value=0 corner=0",
                        .example = "create b columns of=(3 1 4)\nset b/1.value 2"}),
    {.kind = Kind::pie,
     .name = "pie",
     .sentence = "A chart of slices.",
     .written = "of=(NUMBER …) keys=(\"…\" …) radius=2 hole=0",
     .example = "create p pie of=(3 1 4)"},
    {.kind = Kind::table,
     .name = "table",
     .sentence = "Texts in rows and columns.",
     .written = "of=((\"…\" …) …) cell=(1.2 0.7)",
     .example = "create t table of=((\"a\" 1) (\"b\" 2))"},
    {.kind = Kind::matrix,
     .name = "matrix",
     .sentence = "Numbers in rows and columns, between brackets.",
     .written = "of=((NUMBER …) …) cell=(1.2 0.7)",
     .example = "create m matrix of=((1 2) (3 4))"},
    flat<brace_contours>({.kind = Kind::brace,
                          .name = "brace",
                          .sentence = "A curly brace from its position on.",
                          .written = "to=(2 0) height=0.3 width=0.06",
                          .example = "create b brace to=(3 0)"}),
    {.kind = Kind::light,
     .name = "light",
     .sentence = "A lamp, or the sun.",
     .written = "range=20 intensity=1 shines=point|sun shadow=auto|on|off|soft",
     .example = "create sun light shines=sun intensity=2"},
    {.kind = Kind::camera,
     .name = "camera",
     .sentence = "A camera; the film shows what it sees.",
     .written = "lens=35mm or fov=50deg or height=10, look-at=(x y z) or a name",
     .example = "create side camera position=(30 0 0) look-at=ball"},
    {.kind = Kind::sound,
     .name = "sound",
     .sentence = "A sound from a file below the script's folder.",
     .written = "file=\"…\" at=1f from=0 until=… gain=1 fade-in=0 fade-out=0",
     .example = "create music sound file=\"music.mp3\" at=24f fade-in=2s"},
    {.kind = Kind::environment,
     .name = "environment",
     .article = "an",
     .sentence = "A transform that is applied again and again to the objects in it; animate makes one.",
     .placed = false},
    {.kind = Kind::layer,
     .name = "layer",
     .sentence = "Motion on top of the objects' own; the command layer makes one.",
     .written = "weight=1 mode=add|mix",
     .placed = false},
};

}  // namespace

Detail Detail::for_pixels(double radius) {
  constexpr int steps[] = {8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256};
  // A circle of radius r is off its polygon of n sides by r (1 - cos(pi / n)): by 0.2 for n = 5 sqrt(r).
  const double wanted = 5 * std::sqrt(radius);
  const auto* enough = std::find_if(std::begin(steps), std::end(steps) - 1, [&](int n) { return n >= wanted; });
  return {*enough, false};
}
int Detail::around_thin(double share) const {
  return std::max(6, 2 * static_cast<int>(std::ceil(around / 2.0 * std::sqrt(share))));
}

std::span<const KindRow> kinds() { return kind_rows; }

const KindRow& row_of(Kind kind) {
  static const auto by_kind = [] {
    std::array<const KindRow*, 64> all{};  // bits of FunctionSpec::kinds
    all.fill(&kind_rows[0]);
    for (const KindRow& row : kind_rows) all[static_cast<std::size_t>(row.kind)] = &row;
    return all;
  }();
  return *by_kind[static_cast<std::size_t>(kind) % by_kind.size()];
}

std::optional<Kind> find_kind(std::string_view name) {
  if (name == "disc") return Kind::disc;  // its other name
  for (const KindRow& row : kind_rows)
    if (row.name == name) return row.kind;
  return std::nullopt;
}

std::string written_of(const KindRow& row) {
  std::string all(row.written);
  if (row.deep) all += " depth=0 fill=on stroke=none stroke-width=0.05 stroke-round=off";
  if (row.deep || row.line) all += " dash=(0 0) trim=(0 1)";
  return all;
}

std::string a_kind(Kind kind) { return std::string(row_of(kind).article) + " " + std::string(name_of(kind)); }

Extent extent(const Shape& s) {
  const auto of = row_of(s.kind).extent;
  return of ? of(s) : Extent{};
}

}  // namespace betwixt

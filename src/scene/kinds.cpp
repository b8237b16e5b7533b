// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "scene/kinds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/utf8.h"
#include "scene/flat_shapes.h"
#include "scene/line.h"
#include "scene/primitives.h"

namespace betwixt {
namespace {

// ---- Where shapes end

Extent centred_on_origin(Vec3 half) { return {-half, half}; }

Extent around_points(const std::vector<Vec3>& points, double margin) {
  if (points.empty()) return {};
  Extent e;
  for (const Vec3 p : points) e.add(p);
  const Vec3 m{margin, margin, margin};
  return {e.low - m, e.high + m};
}

Extent of_ball(const Shape& s) { return centred_on_origin({s.radius, s.radius, s.radius}); }
Extent of_box(const Shape& s) { return centred_on_origin(0.5 * s.size); }
Extent of_plane(const Shape& s) { return centred_on_origin({s.size.x / 2, s.size.y / 2, 0}); }
Extent of_disc(const Shape& s) { return centred_on_origin({s.radius, s.radius, 0}); }
Extent of_round(const Shape& s) { return centred_on_origin({s.radius, s.height / 2, s.radius}); }  // cylinder, cone
Extent of_ring(const Shape& s) { return centred_on_origin({s.radius + s.tube, s.tube, s.radius + s.tube}); }
Extent of_polygon(const Shape& s) {
  Extent e = around_points(*s.points, 0);
  if (!s.points->empty()) e.low.z -= s.depth / 2, e.high.z += s.depth / 2;
  return e;
}
Extent of_points(const Shape& s) { return around_points(*s.points, s.width / 2); }
Extent of_mesh(const Shape& s) { return s.mesh && !s.mesh->positions.empty() ? s.mesh->box() : Extent{}; }

// Width and lines of a text, letters taken as 0.6 em wide.
Extent of_text(const Shape& s) {
  double widest = 0, letters = 0, lines = 1;
  for (const char c : *s.text) {
    if (c == '\n')
      ++lines, letters = 0;
    else if (begins_character(c))
      widest = std::max(widest, ++letters);
  }
  if (widest == 0) return {};
  const double em = s.size.y, width = 0.6 * widest * em;
  const double left = s.letters.align == Align::left ? 0 : s.letters.align == Align::right ? -width : -width / 2;
  return {{left, (-0.25 - 1.2 * (lines - 1)) * em, -s.depth / 2}, {left + width, 0.8 * em, s.depth / 2}};
}

template <Contours (*contours)(const Shape&)>
Extent of_contours(const Shape& s) {
  Extent e;
  bool any = false;
  for (const auto& contour : contours(s))
    for (const Vec3 p : contour) any ? e.add(p) : void(e = {p, p}), any = true;
  e.low.z -= any ? s.depth / 2 : 0, e.high.z += any ? s.depth / 2 : 0;
  return e;
}

// Round shapes reach less far than the corners of their boxes.
double ball_reach(const Shape& s, Vec3 r) { return s.radius * length(r); }
double disc_reach(const Shape& s, Vec3 r) { return s.radius * std::hypot(r.x, r.y); }
double cylinder_reach(const Shape& s, Vec3 r) { return s.radius * std::hypot(r.x, r.z) + std::abs(s.height / 2 * r.y); }
double ring_reach(const Shape& s, Vec3 r) { return s.radius * std::hypot(r.x, r.z) + s.tube * length(r); }

// ---- How they become triangles

Vec3 even_measures(const Shape& s) { return {s.radius, s.radius, s.radius}; }
Vec3 box_measures(const Shape& s) { return s.size; }
Vec3 plane_measures(const Shape& s) { return {s.size.x, s.size.y, std::max(s.size.x, s.size.y)}; }
Vec3 round_measures(const Shape& s) { return {s.radius, s.height, s.radius}; }

bool in_reach(const std::vector<Vec3>& points) {
  return std::all_of(points.begin(), points.end(), [](Vec3 p) { return sane(p); });
}

// A radius beside the largest measure from the middle.
double share_of(double radius, const Shape& s) {
  const Vec3 half = of_points(s).half();
  return radius / std::max({half.x, half.y, half.z, radius, 1e-300});
}

Mesh ring_mesh(const Shape& s, const Detail& d) {
  if (!(s.tube > 0) || !(s.radius >= 0) || !sane(s.tube) || !sane(s.radius)) return {};
  const int across = d.even ? d.around / 2 : d.around_thin(s.tube / (s.radius + s.tube));
  return torus_mesh(s.radius, s.tube, d.around, across);
}
Mesh stroke_mesh(const Shape& s, const Detail& d) {
  if (!in_reach(*s.points) || !sane(s.width) || s.points->empty()) return {};
  if (!(s.width > 0)) return line_mesh(*s.points);
  return tube_mesh(*s.points, s.width, d.even ? 8 + d.around / 48 * 4 : d.around_thin(share_of(s.width / 2, s)));
}
Mesh cloud_mesh(const Shape& s, const Detail& d) {
  if (!in_reach(*s.points) || !sane(s.width) || !(s.width > 0)) return {};
  // Fewer triangles for each where there are many: together they may be millions.
  if (s.points->size() > 20000) return balls_mesh(*s.points, s.width, sphere_mesh(4, 2));
  const int around = d.even ? d.around / 3 : d.around_thin(share_of(s.width / 2, s));
  return balls_mesh(*s.points, s.width, sphere_mesh(around, around / 2));
}

// A curve as a polyline.
Shape as_stroke(const Shape& s) {
  Shape out = s;
  Line line = line_of(s);
  if (line.closed && line.points.size() > 1) line.points.push_back(line.points.front());
  out.points = Points(std::move(line.points));
  return out;
}
Extent of_curve(const Shape& s) { return of_points(as_stroke(s)); }

std::vector<std::vector<Vec3>> one_contour(const Shape& s) {
  if (s.points->size() < 3 || !in_reach(*s.points)) return {};
  return {*s.points};
}

// ---- The rows

constexpr KindRow kind_rows[] = {
    {.kind = Kind::group,
     .name = "group",
     .sentence = "No shape; things hang on it.",
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
     .sentence = "A ring.",
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
     .name = "disc",
     .sentence = "A flat disc.",
     .written = "radius=1",
     .example = "create d disc radius=3",
     .functions = "radius",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_disc,
     .reach = disc_reach,
     .measures = even_measures,
     .mesh = [](const Shape&, const Detail& d) { return disc_mesh(d.around); }},
    {.kind = Kind::polygon,
     .name = "polygon",
     .sentence = "A filled outline.",
     .written = "points=((x y) …) depth=0",
     .example = "create p polygon points=((0 0) (2 0) (1 2))",
     .functions = "points",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_polygon,
     .contours = one_contour},
    {.kind = Kind::polyline,
     .name = "polyline",
     .sentence = "A line through points.",
     .written = "points=((x y) …) width=0.05",
     .example = "create l polyline points=((0 0) (2 0) (1 2)) width=0.1",
     .functions = "points",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_points,
     .mesh = stroke_mesh},
    {.kind = Kind::curve,
     .name = "curve",
     .sentence = "A line through points, smooth or straight; things go along it.",
     .written = "points=((x y) …) width=0.05 smooth=on closed=off",
     .example = "create road curve points=((0 0) (2 1) (4 0)) closed=on",
     .functions = "points",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_curve,
     .mesh = [](const Shape& s, const Detail& d) { return stroke_mesh(as_stroke(s), d); }},
    {.kind = Kind::trace,
     .name = "trace",
     .sentence = "What a point of a thing has drawn by now.",
     .written = "of=NAME from=1f until=… last=0 point=(0 0 0) within=none width=0.05",
     .example = "create t trace of=ball from=1f width=0.02 color=red",
     .fill = Fill::surface,
     .detailed = true,
     .extent = of_points,
     .mesh = stroke_mesh},
    {.kind = Kind::points,
     .name = "points",
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
     .written = "text=\"…\" font=\"DejaVu Sans\" weight=regular slant=upright size=1 depth=0 align=centre",
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
    {.kind = Kind::rectangle,
     .name = "rectangle",
     .sentence = "A flat rectangle; its corners may be round.",
     .written = "size=(1 1) corner=0 depth=0",
     .example = "create card rectangle size=(3 2) corner=0.2",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_contours<rectangle_contours>,
     .contours = rectangle_contours},
    {.kind = Kind::ring,
     .name = "ring",
     .sentence = "A flat ring.",
     .written = "radius=1 inner=0.5 depth=0",
     .example = "create target ring radius=2 inner=1.8",
     .functions = "radius",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_contours<ring_contours>,
     .contours = ring_contours},
    {.kind = Kind::arc,
     .name = "arc",
     .article = "an",
     .sentence = "A flat part of a ring, anticlockwise from the right.",
     .written = "radius=1 from=0deg to=90deg width=0.1 depth=0",
     .example = "create part arc radius=2 to=120deg width=0.3",
     .functions = "radius",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_contours<arc_contours>,
     .contours = arc_contours},
    {.kind = Kind::regular,
     .name = "regular",
     .sentence = "A flat shape of equal sides, one corner up.",
     .written = "sides=6 radius=1 depth=0",
     .example = "create cell regular sides=6 radius=2",
     .functions = "radius",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_contours<regular_contours>,
     .contours = regular_contours},
    {.kind = Kind::star,
     .name = "star",
     .sentence = "A flat star, one point up.",
     .written = "points=5 radius=1 inner=0.4 depth=0",
     .example = "create st star points=7 inner=0.6",
     .functions = "radius",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_contours<star_contours>,
     .contours = star_contours},
    {.kind = Kind::gear,
     .name = "gear",
     .sentence = "A flat gear wheel; those of one module turn each other.",
     .written = "teeth=20 module=0.1 inner=0 depth=0",
     .example = "create g gear teeth=12 module=0.2",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_contours<gear_contours>,
     .contours = gear_contours},
    {.kind = Kind::arrow,
     .name = "arrow",
     .article = "an",
     .sentence = "A flat arrow from its position on.",
     .written = "to=(1 0 0) width=0.1 depth=0",
     .example = "create a arrow to=(2 1 0)",
     .fill = Fill::outline,
     .deep = true,
     .extent = of_contours<arrow_contours>,
     .contours = arrow_contours},
    {.kind = Kind::light,
     .name = "light",
     .sentence = "A lamp, or the sun.",
     .written = "range=20 intensity=1 shines=point|sun shadow=auto|on|off|soft",
     .example = "create sun light shines=sun intensity=2"},
    {.kind = Kind::camera,
     .name = "camera",
     .sentence = "Where the film is seen from.",
     .written = "lens=35mm or fov=50deg or height=10, look-at=(x y z) or a name",
     .example = "create side camera position=(30 0 0) look-at=ball"},
    {.kind = Kind::environment,
     .name = "environment",
     .article = "an",
     .sentence = "What the command animate makes: a matrix that moves what is in it.",
     .placed = false},
    {.kind = Kind::layer,
     .name = "layer",
     .sentence = "What the command layer makes: motion laid over objects.",
     .written = "weight=1 mode=add|mix",
     .placed = false},
};

}  // namespace

Detail Detail::for_pixels(double radius) {
  constexpr int steps[] = {8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256};
  // A circle of radius r is off its polygon of n sides by r (1 - cos(pi / n)): by 0.2 where n is 5 sqrt(r).
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
    std::array<const KindRow*, 32> all{};  // bits of FunctionSpec::kinds
    all.fill(&kind_rows[0]);
    for (const KindRow& row : kind_rows) all[static_cast<std::size_t>(row.kind)] = &row;
    return all;
  }();
  return *by_kind[static_cast<std::size_t>(kind) % by_kind.size()];
}

std::optional<Kind> find_kind(std::string_view name) {
  if (name == "circle") return Kind::disc;  // by its usual name
  for (const KindRow& row : kind_rows)
    if (row.name == name) return row.kind;
  return std::nullopt;
}

std::string a_kind(Kind kind) { return std::string(row_of(kind).article) + " " + std::string(name_of(kind)); }

Extent extent(const Shape& s) {
  const auto of = row_of(s.kind).extent;
  return of ? of(s) : Extent{};
}

}  // namespace betwixt

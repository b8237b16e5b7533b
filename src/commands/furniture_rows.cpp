// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/furniture_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "language/formula.h"
#include "language/values.h"
#include "program/on_axes.h"
#include "scene/axes.h"
#include "scene/kinds.h"
#include "scene/names.h"

namespace betwixt {
namespace {

// ---- Axes

void labels(Furnishing& f, char axis, double length, std::string_view align) {
  const std::string all = fmt::format("{}/{}/{{1..{}}}", f.name, axis, most_labels(length));
  f.line("create {} text size={} color={} align={}", all, write_number(f.number("digits")), f.label(), align);
  f.line("set {}.text = \"axes.label('{}', '{}', i)\"", all, f.name, axis);
  f.line("set {}.position = \"axes.label_place('{}', '{}', i)\"", all, f.name, axis);
  f.line("set {}.display = \"value('{}.numbers')\"", all, f.name);
}

// Returns the color that the author has set, in the form of the language.
std::string color_or(const Furnishing& f, std::string_view otherwise) {
  if (!f.colored()) return std::string(otherwise);
  return write_color(std::get<Color>(f.value("color")));
}

void axis(Furnishing& f, char axis, double length, std::string_view align) {
  f.line("create {}/{} polyline width=0.03 color={}", f.name, axis, color_or(f, f.muted()));
  f.line("set {0}/{1}.points = \"axes.line('{0}', '{1}')\"", f.name, axis);
  if (length > 0) labels(f, axis, length, align);
}

void grid(Furnishing& f) {
  f.line("create {}/grid polyline width=0.015 color={}", f.name, f.faint());
  f.line("set {0}/grid.points = \"axes.grid('{0}')\"", f.name);
  f.line("set {0}/grid.display = \"value('{0}.grid')\"", f.name);
}

void title(Furnishing& f, char axis) {
  const std::string text = f.text(fmt::format("{}-title", axis));
  if (text.empty()) return;
  const bool up = axis == 'y';
  f.line("create {}/{}/title text size={} color={} align={}", f.name, axis, write_number(1.15 * f.number("digits")),
         f.label(), up ? "centre" : "left");
  f.line("set {0}/{1}/title.text = \"value('{0}.{1}-title')\"", f.name, axis);
  f.line("set {0}/{1}/title.position = \"axes.tip('{0}', '{1}') + vec({2})\"", f.name, axis,
         up ? "0, 0.2" : "0.2, -0.1");
}

// Returns false if an axis has no length.
bool good_axis(Furnishing& f, std::string_view name, std::string_view scale = {}) {
  const Vec3 v = f.vector(name);
  Axis a{v.x, v.y, v.z, AxisScale::linear};
  if (!scale.empty() && f.text(scale) == "log") a.scale = AxisScale::log;
  if (a.good() && v.z >= 0) return true;
  f.problem = v.z < 0 ? fmt::format("the step of {} must not be below 0", name)
              : a.scale == AxisScale::log && (v.x <= 0 || v.y <= 0)
                  ? fmt::format("{} has a logarithmic scale, so both its ends must be above 0", name)
                  : fmt::format("the two ends of {} must be different", name);
  f.hint = a.scale == AxisScale::log ? fmt::format("as in {}=(1 1000)", name) : fmt::format("as in {}=(0 10)", name);
  return false;
}

void make_axes(Furnishing& f) {
  const Vec3 size = f.vector("size");
  if (!good_axis(f, "x", "x-scale") || !good_axis(f, "y", "y-scale")) return;
  if (size.z > 0 && !good_axis(f, "z")) return;
  grid(f);
  axis(f, 'x', size.x, "centre");
  axis(f, 'y', size.y, "right");
  if (size.z > 0) axis(f, 'z', 0, "centre");
  title(f, 'x');
  title(f, 'y');
}

void make_number_line(Furnishing& f) {
  if (!good_axis(f, "x", "x-scale")) return;
  axis(f, 'x', f.number("length"), "centre");
  title(f, 'x');
}

void make_polar_axes(Furnishing& f) {
  if (!good_axis(f, "r")) return;
  f.line("create {}/grid polyline width=0.015 color={}", f.name, f.faint());
  f.line("set {0}/grid.points = \"axes.grid('{0}')\"", f.name);
  axis(f, 'x', f.number("radius"), "centre");
  const double away = f.number("radius") + 1.6 * f.number("digits");
  for (int degrees = 30; degrees < 360; degrees += 30)
    f.line("create {}/{} text text=\"{}°\" size={} color={} position=({} {})", f.name, "a" + std::to_string(degrees),
           degrees, write_number(f.number("digits")), f.label(), write_number(away * std::cos(degrees * pi / 180)),
           write_number(away * std::sin(degrees * pi / 180) - 0.36 * f.number("digits")));
}

void make_plane_grid(Furnishing& f) {
  if (!good_axis(f, "x") || !good_axis(f, "y")) return;
  const std::string& name = f.name;
  f.line("create {}/grid polyline width=0.025 color={}", name, f.tint(0));
  f.line("set {0}/grid.points = \"axes.grid('{0}')\"", name);
  for (const auto& [word, color] : {std::pair<const char*, std::string>{"right", f.tint(2)}, {"up", f.tint(3)}}) {
    f.line("create {}/{} arrow width=0.07 color={} position=(0 0 0.01)", name, word, color);
    f.line("set {0}/{1}.to = \"axes.place('{0}', vec({2}))\"", name, word, word[0] == 'r' ? "1, 0" : "0, 1");
  }
}

// ---- Plots

std::size_t plots_before(const Furnishing& f) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < f.id.index; ++i) {
    const Object& o = f.scene.objects[static_cast<std::uint32_t>(i)];
    count += !o.removed && o.kind == Kind::plot ? 1 : 0;
  }
  return count;
}

void color(Furnishing& f, std::string_view what) {
  if (!f.colored()) f.line("set {}.color {}", f.name, what);
}

// Returns the colour of the plot that a formula names, or one of the palette.
void color_like(Furnishing& f, std::string_view otherwise) {
  if (f.colored()) return;
  const ObjectId named = f.scene.names.find(f.text("of"));
  const Object* o = named ? &f.scene.objects[named.index] : nullptr;
  const Slot* slot = o && o->kind == Kind::plot ? o->find(fn::color) : nullptr;
  if (const auto* c = slot && slot->set ? std::get_if<Color>(&*slot->set) : nullptr)
    f.line("set {}.color rgb({} {} {})", f.name, write_number(c->r), write_number(c->g), write_number(c->b));
  else
    color(f, otherwise);
}

void make_plot(Furnishing& f) {
  f.line("set {}.points = \"plot.curve()\"", f.name);
  color(f, f.tint(plots_before(f)));
}
void make_area(Furnishing& f) {
  f.line("set {}.points = \"plot.area()\"", f.name);
  color_like(f, f.tint(0));
  if (!f.says("transparency")) f.line("set {}.transparency 0.6", f.name);
}
void make_riemann(Furnishing& f) {
  f.line("set {}.points = \"plot.riemann()\"", f.name);
  color_like(f, f.tint(0));
  if (!f.says("transparency")) f.line("set {}.transparency 0.35", f.name);
  if (!f.says("stroke")) f.line("set {}.stroke {}", f.name, theme_color(f.scene, &Theme::paper));
  if (!f.says("stroke-width")) f.line("set {}.stroke-width 0.02", f.name);
}
void make_tangent(Furnishing& f) {
  f.line("set {}.points = \"plot.tangent()\"", f.name);
  color(f, f.tint(1));
}
void make_field(Furnishing& f) {
  f.line("set {}.points = \"plot.field()\"", f.name);
  color(f, f.tint(5));
}

// Returns the axes that it is on, if they are of one of these kinds; otherwise none, and the problem.
const Object* plane_axes(Furnishing& f, std::string_view wanted) {
  const Object& axes = f.scene.objects[axes_of(f.scene, f.object()).index];
  if (axes.kind == Kind::axes || axes.kind == Kind::plane_grid) return &axes;
  f.problem = fmt::format("{} needs {}, and '{}' is {}", a_kind(f.object().kind), wanted, axes.name, a_kind(axes.kind));
  return nullptr;
}
void make_streamlines(Furnishing& f) {
  if (!plane_axes(f, "axes with x and y")) return;
  f.line("set {}.points = \"plot.streamlines()\"", f.name);
  color(f, f.tint(5));
  if (!f.says("width")) f.line("set {}.width 0.03", f.name);
}
void make_surface(Furnishing& f) {
  const Object* axes = plane_axes(f, "axes with x, y and z");
  if (!axes) return;
  const auto size = axes->kind == Kind::axes ? find_built_in(Kind::axes, "size") : std::nullopt;
  const Slot* slot = size ? axes->find(*size) : nullptr;
  const auto* said = slot && slot->set ? std::get_if<Vec3>(&*slot->set) : nullptr;
  if (!slot || (said && !(said->z > 0))) {
    f.problem = fmt::format("a surface needs axes with a z axis, and '{}' has none", axes->name);
    f.hint = "give the axes a size of three numbers, as in size=(8 4 3)";
    return;
  }
  f.line("set {}.points = \"plot.surface()\"", f.name);
  color(f, f.tint(0));
}
void make_scatter(Furnishing& f) { color(f, f.tint(1)); }

}  // namespace

std::string palette(const Scene& s, std::size_t n) {
  const auto& all = theme_of(s).palette;
  return write_color(all[n % all.size()]);
}
std::string theme_color(const Scene& s, Color Theme::*which) { return write_color(theme_of(s).*which); }

Value Furnishing::value(std::string_view function) const {
  const auto f = find_built_in(object().kind, function);
  const Slot* slot = object().find(*f);
  const FunctionSpec& spec = spec_of(scene, *f);
  return slot && slot->set && slot->set->index() == spec.rest.index() ? *slot->set : spec.rest;
}
std::string Furnishing::text(std::string_view function) const { return *std::get<Text>(value(function)); }
bool Furnishing::says(std::string_view function) const {
  const auto f = find_built_in(object().kind, function);
  const Slot* slot = f ? object().find(*f) : nullptr;
  return slot && slot->set;
}
bool Furnishing::colored() const { return says("color"); }

const FurnitureRow* furniture_of(Kind kind) {
  static constexpr FurnitureRow rows[] = {
      {Kind::axes, Takes::nothing, false, make_axes},
      {Kind::number_line, Takes::nothing, false, make_number_line},
      {Kind::polar_axes, Takes::nothing, false, make_polar_axes},
      {Kind::plane_grid, Takes::nothing, false, make_plane_grid},
      {Kind::plot, Takes::nothing, true, make_plot},
      {Kind::area, Takes::nothing, true, make_area},
      {Kind::riemann, Takes::nothing, true, make_riemann},
      {Kind::tangent, Takes::nothing, true, make_tangent},
      {Kind::vector_field, Takes::nothing, true, make_field},
      {Kind::streamlines, Takes::nothing, true, make_streamlines},
      {Kind::surface, Takes::nothing, true, make_surface},
      {Kind::scatter, Takes::nothing, true, make_scatter},
      {Kind::bars, Takes::numbers, false, make_bars},
      {Kind::columns, Takes::numbers, false, make_columns},
      {Kind::line_chart, Takes::series, false, make_line_chart},
      {Kind::pie, Takes::numbers, false, make_pie},
      {Kind::table, Takes::cells, false, make_table},
      {Kind::matrix, Takes::cells, false, make_matrix},
      {Kind::code, Takes::nothing, false, make_code},
      {Kind::diagram, Takes::nothing, false, make_diagram},
  };
  for (const FurnitureRow& row : rows)
    if (row.kind == kind) return &row;
  return nullptr;
}

}  // namespace betwixt

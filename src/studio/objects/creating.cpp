// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/objects/creating.h"

#include <fmt/format.h>

#include <QFileDialog>
#include <QMenu>
#include <algorithm>

#include "betwixt/pick.h"
#include "language/values.h"
#include "program/on_axes.h"
#include "scene/document.h"
#include "scene/kinds.h"
#include "scene/own_kinds.h"
#include "studio/assets/asset_files.h"
#include "studio/shell/text_of.h"
#include "studio/viewport/kind_icons.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

constexpr const char *shape_kinds = QT_TR_NOOP("Shapes"), *line_kinds = QT_TR_NOOP("Lines and points"),
                     *word_kinds = QT_TR_NOOP("Text and code"), *chart_kinds = QT_TR_NOOP("Charts and tables"),
                     *plot_kinds = QT_TR_NOOP("Axes and plots"), *diagram_kinds = QT_TR_NOOP("Diagrams"),
                     *light_kinds = QT_TR_NOOP("Light and camera"), *other_kinds = QT_TR_NOOP("Others");

// In the order of the menu. The kinds `bar` and `dot` are parts of charts.
constexpr CreatedKind kinds_by_hand[] = {
    {Kind::box, shape_kinds, "cube"},
    {Kind::sphere, shape_kinds, "ball globe"},
    {Kind::cylinder, shape_kinds, "tube"},
    {Kind::cone, shape_kinds, "pyramid"},
    {Kind::torus, shape_kinds, "donut"},
    {Kind::plane, shape_kinds, "floor ground"},
    {Kind::disc, shape_kinds, "disc ellipse"},
    {Kind::rectangle, shape_kinds, "square card panel"},
    {Kind::video, shape_kinds, "film movie clip footage file"},
    {Kind::ring, shape_kinds, "circle annulus"},
    {Kind::arc, shape_kinds, "sector angle"},
    {Kind::regular, shape_kinds, "triangle hexagon"},
    {Kind::star, shape_kinds, ""},
    {Kind::gear, shape_kinds, "wheel cog"},
    {Kind::polygon, shape_kinds, "triangle area", true},
    {Kind::mesh, shape_kinds, "model file import"},
    {Kind::line, line_kinds, "segment", true},
    {Kind::arrow, line_kinds, "vector pointer", true},
    {Kind::polyline, line_kinds, "path zigzag", true},
    {Kind::curve, line_kinds, "spline bezier path", true},
    {Kind::brace, line_kinds, "bracket curly label", true},
    {Kind::points, line_kinds, "dots particles", true},
    {Kind::trace, line_kinds, "trail path"},
    {Kind::text, word_kinds, "title label formula equation tex latex"},
    {Kind::code, word_kinds, "program source listing", true},
    {Kind::bars, chart_kinds, "chart graph diagram data", true},
    {Kind::columns, chart_kinds, "chart graph diagram data histogram", true},
    {Kind::line_chart, chart_kinds, "chart graph diagram data", true},
    {Kind::pie, chart_kinds, "chart graph diagram data donut", true},
    {Kind::table, chart_kinds, "cells data spreadsheet", true},
    {Kind::matrix, chart_kinds, "array cells numbers", true},
    {Kind::axes, plot_kinds, "graph coordinates chart", true},
    {Kind::plot, plot_kinds, "graph function formula curve", true},
    {Kind::area, plot_kinds, "integral graph", true},
    {Kind::riemann, plot_kinds, "integral sum rectangles", true},
    {Kind::tangent, plot_kinds, "slope derivative secant", true},
    {Kind::scatter, plot_kinds, "chart graph data points", true},
    {Kind::vector_field, plot_kinds, "arrow slope field formula", true},
    {Kind::streamlines, plot_kinds, "flow field formula", true},
    {Kind::surface, plot_kinds, "graph function formula 3d", true},
    {Kind::number_line, plot_kinds, "axis ruler", true},
    {Kind::polar_axes, plot_kinds, "coordinates radar", true},
    {Kind::plane_grid, plot_kinds, "linear map transformation", true},
    {Kind::diagram, diagram_kinds, "graph flowchart chart tree network arrow boxes nodes", true},
    {Kind::light, light_kinds, "lamp sun"},
    {Kind::camera, light_kinds, "view"},
    {Kind::group, other_kinds, "null empty parent"},
    {Kind::sound, other_kinds, "music audio voice file"},
};

// Returns the axes on which a new object of a kind can be: those that are selected or hold the selection, or the last
// ones of the film. A surface needs axes in space.
std::string axes_for(const Workspace& workspace, Kind wanted) {
  const Document& d = workspace.document();
  const Scene& scene = d.scene();
  const auto fits = [&](ObjectId id) {
    if (!id || !has_coordinates(kind(d, id))) return false;
    const Value size = kind(d, id) == Kind::axes
                           ? workspace.program().read(Target(id, *find_built_in(Kind::axes, "size")), workspace.time())
                           : Value();
    const auto* v = std::get_if<Vec3>(&size);
    return wanted != Kind::surface || (v && v->z > 0);
  };
  for (const ObjectId id : workspace.selected()) {
    if (fits(id)) return d.name(id);
    if (const ObjectId on = axes_of(scene, scene.objects[id.index]); fits(on)) return d.name(on);
  }
  std::string last;
  for (const ObjectId id : objects(d))
    if (kind(d, id) == Kind::axes && fits(id)) last = d.name(id);
  return last;
}

// Returns the plot that is selected, whose formula an area, rectangles or a tangent can have.
std::string selected_plot(const Workspace& workspace, Kind wanted) {
  if (wanted != Kind::area && wanted != Kind::riemann && wanted != Kind::tangent) return {};
  for (const ObjectId id : workspace.selected())
    if (kind(workspace.document(), id) == Kind::plot) return workspace.name(id);
  return {};
}

void put_instead(std::string& line, std::string_view what, const std::string& other) {
  if (const std::size_t at = line.find(what); at != line.npos) line.replace(at, what.size(), other);
}

// Returns what follows `create NAME` in a line of an example.
std::string after_name(std::string_view line) {
  (void)take_piece(line), (void)take_piece(line);
  return std::string(line);
}

// Returns the lines of a kind's example, with names that are free.
ObjectEdit like_example(const Workspace& workspace, Kind k) {
  const KindRow& row = betwixt::row_of(k);
  const Document& d = workspace.document();
  ObjectEdit edit{{}, {free_name(d, std::string(row.name) + "1")}};
  const std::size_t line_end = row.example.find('\n');
  std::string own = "create " + edit.names[0] + after_name(row.example.substr(line_end + 1));  // without its axes
  if (line_end != row.example.npos) {
    std::string axes = axes_for(workspace, k);
    if (axes.empty()) {
      axes = free_name(d, "axes1", edit.names);
      const bool upright = k == Kind::surface && !d.scene().appearance.flat;  // its height goes up
      edit.lines.push_back("create " + axes +
                           (upright ? " axes size=(6 6 2) z=(-1 1) rotation=(-90deg 0 0)"
                                    : after_name(row.example.substr(0, line_end))));
    }
    put_instead(own, "on=ax", "on=" + axes);
    if (const std::string plot = selected_plot(workspace, k); !plot.empty())
      put_instead(own, "of=\"x^2 / 4\"", "of=" + plot);
  }
  edit.lines.push_back(own);
  return edit;
}

// If the film has a ground, gives new objects a position in which they stand on it with all their pieces. The first
// line places them: the others are on its axes.
void put_on_ground(const Workspace& workspace, Lines& lines) {
  std::string& first = lines.front();
  if (!workspace.document().scene().appearance.ground || first.find("position=") != first.npos ||
      first.find(" on=") != first.npos)
    return;
  const auto then = workspace.session().look_ahead(lines);
  if (!then) return;
  const Program program = Program::compile(*then);
  double lowest = 0;
  for (const Item& item : program.frame(workspace.time()).items)
    if (!workspace.document().find(then->name(item.id)))
      for (const Vec3& corner : drawn(item).corners) lowest = std::min(lowest, corner.y);
  std::string_view words = first;
  (void)take_piece(words);
  const Value at = program.read(Target(then->find(take_piece(words)), fn::position), workspace.time());
  if (const auto* p = std::get_if<Vec3>(&at); p && lowest < -1e-9)  // code without a position is in the middle
    first += fmt::format(" position=({:.4g} {:.4g} {:.4g})", p->x, p->y - lowest, p->z);
}

// A first camera sees what stands around the middle; another one looks from where the user looks from.
std::string place_of_camera(const Workspace& workspace) {
  const Frame frame = workspace.program().frame(workspace.time());
  if (!workspace.view() && frame.items.empty()) return " position=(0 2 11) look-at=(0 1.7 0)";
  const Mat4 eye = workspace.view() ? workspace.view()->world : frame.camera.world;
  const Vec3 at = translation_of(eye), to = at - 10 * normalize(Vec3{eye(0, 2), eye(1, 2), eye(2, 2)});
  return fmt::format(" position=({:.4g} {:.4g} {:.4g}) look-at=({:.4g} {:.4g} {:.4g})", at.x, at.y, at.z, to.x, to.y,
                     to.z);
}

// What a plain line needs to show something.
std::string first_values(const Workspace& workspace, Kind k) {
  if (k == Kind::text) return " text=\"text\"";
  if (k == Kind::camera) return place_of_camera(workspace);
  if (k == Kind::light) return " position=(4 8 6)";  // above, to the right and in front of the middle
  if (k == Kind::trace && !workspace.selected().empty()) return " of=" + workspace.name(workspace.selected().back());
  return {};
}

ObjectEdit plain_lines(const Workspace& workspace, const std::string& kind, const std::string& values) {
  const std::string name = free_name(workspace.document(), kind + "1");
  return {{"create " + name + " " + kind + values}, {name}};
}

void say_creation(Workspace& workspace, ObjectEdit edit) {
  put_on_ground(workspace, edit.lines);
  if (workspace.say(edit.lines)) workspace.select({workspace.document().find(edit.names[0])});
}

}  // namespace

std::span<const CreatedKind> created_kinds() { return kinds_by_hand; }

ObjectEdit creating_lines(const Workspace& workspace, const CreatedKind& row) {
  return row.like_example ? like_example(workspace, row.kind)
                          : plain_lines(workspace, std::string(name_of(row.kind)), first_values(workspace, row.kind));
}

void create_of_kind(Workspace& workspace, const CreatedKind& row, QWidget* over) {
  if (row.kind == Kind::trace && workspace.selected().empty())
    return Q_EMIT workspace.said({}, QObject::tr("select the object whose way the trace shows"), true);
  ObjectEdit edit = creating_lines(workspace, row);
  if (row.kind == Kind::mesh || row.kind == Kind::sound || row.kind == Kind::video) {
    const QString file = QFileDialog::getOpenFileName(over, QObject::tr("The file of %1").arg(text_of(edit.names[0])));
    if (file.isEmpty()) return;
    edit.lines.back() += " file=" + write_text(path_from_script(file, workspace.session().file()));
  }
  say_creation(workspace, std::move(edit));
}

void fill_kinds(QMenu& menu, Workspace& workspace, QWidget* over) {
  QMenu* group = nullptr;
  for (const CreatedKind& row : created_kinds()) {
    if (const QString title = QObject::tr(row.group); !group || group->title() != title)
      group = menu.addMenu(title), group->setObjectName("kinds"), group->setToolTipsVisible(true);
    const KindRow& of = betwixt::row_of(row.kind);
    group->addAction(kind_icon(row.kind), text_of(of.name), over, [&] { create_of_kind(workspace, row, over); })
        ->setToolTip(text_of(of.sentence));
  }
  menu.setToolTipsVisible(true);
  QObject::connect(&menu, &QMenu::aboutToShow, over, [&menu, &workspace, over, built_in = menu.actions().size()] {
    while (menu.actions().size() > built_in) delete menu.actions().back();
    const Scene& s = workspace.document().scene();
    for (const OwnKind& own : s.kinds->all) {
      const auto& model = s.objects[own.model().index];
      menu.addAction(kind_icon(model.kind), text_of(own.name), over,
                     [&workspace, name = own.name] { say_creation(workspace, plain_lines(workspace, name, {})); })
          ->setToolTip(QObject::tr("A kind of this film, like %1").arg(text_of(model.name)));
    }
  });
}

}  // namespace betwixt::studio

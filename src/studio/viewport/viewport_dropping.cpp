// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Creates objects from files dropped on the picture.
#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QImageReader>
#include <QMimeData>
#include <cmath>

#include "betwixt/pick.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/assets/asset_files.h"
#include "studio/assets/look_lines.h"
#include "studio/poses/pose_actions.h"
#include "studio/shell/text_of.h"
#include "studio/viewport/hand.h"
#include "studio/viewport/viewport.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

QStringList files_of(const QMimeData* data) {
  QStringList out;
  for (const QUrl& url : data->urls())
    if (const QString file = url.toLocalFile(); asset_sort(file) != AssetSort::none) out << file;
  return out;
}

bool use_pose(Workspace& workspace, const QString& file) {
  PoseActions& poses = PoseActions::of(workspace);
  const auto pose = poses.read(QFileInfo(file).completeBaseName());
  return pose && workspace.say(poses.lines(*pose, false, 1));
}

Box box_of_named(const Program& program, const std::string& name, Time t) {
  Box box;
  for (const Item& item : program.frame(t).items) {
    const std::string own = program.document().name(item.id);
    if (own == name || own.starts_with(name + "/"))
      for (const Vec3& corner : drawn(item, 1000).corners) box.add(corner);
  }
  return box;
}

}  // namespace

// Returns a place under the pointer: on an object; otherwise on the ground (in a flat film, on the paper).
std::optional<Vec3> Viewport::surface_under(QPointF p) const {
  const Scope s = scope();
  const QPointF at = s.in_picture(p);
  if (const auto h = pick(frame(), s.projection, at.x(), at.y())) return h->place;
  const Vec3 up = frame().surroundings.flat ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Ray ray = s.ray(p);
  const double slope = dot(ray.along, up), t = slope == 0 ? -1 : -dot(ray.from, up) / slope;
  if (t > 0 && t < 1e4) return ray.from + t * ray.along;
  return std::nullopt;
}

// … otherwise in front of the eye.
Vec3 Viewport::place_under(QPointF p) const {
  const Scope s = scope();
  return surface_under(p).value_or(s.place(p, std::max(1e-3, s.depth(pivot()))));
}

// Returns the box that an object and its parts fill after a line; an empty one if the line fails or they show nothing.
// Files may be large: this runs beside the window. Nothing if the user stops it.
std::optional<Box> Viewport::box_after(const std::string& line, const std::string& name) const {
  Box box;
  const bool done = workspace_.jobs().carry_out(
      [&, t = workspace_.time()] {
        if (const auto then = workspace_.session().look_ahead({line}))
          box = box_of_named(Program::compile(*then), name, t);
      },
      true);
  return done ? std::optional(box) : std::nullopt;
}

// Tells how to scale an object that is far too large or too small to be seen from here.
void Viewport::tell_size(ObjectId id, double depth) const {
  const std::string name = workspace_.name(id);
  Box box;
  workspace_.jobs().carry_out([&, t = workspace_.time()] { box = box_of_named(workspace_.program(), name, t); }, true);
  const double size = 2 * std::max({box.half().x, box.half().y, box.half().z});
  if (box.empty() || size <= 0 || (size < 50 * depth && size > depth / 500)) return;
  const double by = std::pow(10, std::round(std::log10(depth / 3 / size)));
  const std::string factor = write_number(by),
                    line = fmt::format("set {}.scale ({} {} {})", name, factor, factor, factor);
  const auto three_digits = [](double x) {
    return text_of(write_number(rounded(x, std::pow(10, std::floor(std::log10(x)) - 2))));
  };
  const QString large = three_digits(size);
  emit workspace_.said(
      "# " + (large == "1" ? tr("%1 is %2 unit large; `%3` makes it %4") : tr("%1 is %2 units large; `%3` makes it %4"))
                 .arg(text_of(name), large, text_of(line), three_digits(size * by)),
      {}, false);
}

std::string Viewport::line_for_file(const QString& file, QPointF p) const {
  const Document& d = workspace_.document();
  const std::string name = asset_name(file, d), path = write_text(path_from_script(file, workspace_.session().file()));
  const AssetSort sort = asset_sort(file);
  if (sort == AssetSort::sound)
    return "create " + name + " sound file=" + path + " at=" + workspace_.when(workspace_.time());
  const Scope s = scope();
  const auto surface = surface_under(p);
  Vec3 place = place_under(p);
  const double pixel = s.metres(std::max(1e-3, s.depth(place)));
  const bool flat = frame().surroundings.flat;
  std::string line = "create " + name;
  if (sort == AssetSort::mesh) {
    line += " mesh file=" + path;
  } else if (sort == AssetSort::scene) {  // its own places and animation
    line += " scene file=" + path;
    if (workspace_.time() > d.range().first) line += " start=" + workspace_.when(workspace_.time());
  } else if (sort == AssetSort::video) {  // it starts now, and has a third of the picture's height
    line += " video file=" + path + " height=" + write_number(rounded(s.box.height() * pixel / 3, 10 * pixel));
    if (workspace_.time() > d.range().first) line += " at=" + workspace_.when(workspace_.time());
  } else {
    // The image gets a third of the picture's height, and its own aspect ratio.
    const QSize size = QImageReader(file).size();
    const double high = rounded(s.box.height() * pixel / 3, 10 * pixel);
    const double wide = size.height() > 0 ? rounded(high * size.width() / size.height(), pixel) : high;
    line += " plane size=(" + write_number(wide) + " " + write_number(high) + ") texture=" + path;
    if (!flat && surface) place.y += high / 2;
  }
  for (int i = 0; i < 3; ++i) place[i] = rounded(place[i], pixel);
  // What was made in another program stands on the surface, or is centred at the pointer.
  if (!flat && (sort == AssetSort::mesh || sort == AssetSort::scene)) {
    const auto box = box_after(line, name);
    if (!box) return {};
    if (!box->empty()) {
      const double fine = std::pow(10, std::floor(std::log10(std::max(1e-6, box->half().y))) - 4);
      place.y -= rounded(surface ? box->low.y : box->middle().y, fine);
    }
  }
  return line + (place == Vec3{} ? "" : " position=" + write_vector(place));
}

void Viewport::tell_refusal() {
  refusal_ = QString::fromStdString(workspace_.last_said()).section('\n', 0, 0);
  update();
}

bool Viewport::import_file(const QString& file, QPointF at) {
  if (asset_sort(file) == AssetSort::film) return workspace_.say("open " + as_one_word(file.toStdString()));
  if (asset_sort(file) == AssetSort::pose) return use_pose(workspace_, file);
  const Scope s = scope();
  const double depth = std::max(1e-3, s.depth(place_under(at)));
  const std::string line = line_for_file(file, at);
  if (line.empty()) return false;
  if (!workspace_.say(line)) {
    tell_refusal();
    return false;
  }
  const std::size_t from = std::string("create ").size();
  if (const ObjectId made = workspace_.document().find(line.substr(from, line.find(' ', from) - from)))
    workspace_.select({made}), tell_size(made, depth);
  return true;
}

// Returns the lines that a drop on an object carries out: a look that is dragged, or a mesh that replaces its shape.
std::vector<std::string> Viewport::lines_for_drop(const QDropEvent& e) const {
  const auto on = hit(e.position());
  if (!on) return {};
  const Document& d = workspace_.session().document();
  if (e.mimeData()->hasFormat(look_data))
    return look_lines(d, {on->id}, e.mimeData()->data(look_data).toStdString(), workspace_.time(),
                      workspace_.makes_events());
  const QStringList files = files_of(e.mimeData());
  const bool replaces = e.modifiers() & Qt::AltModifier && files.size() == 1;
  if (!replaces || (asset_sort(files[0]) != AssetSort::mesh && asset_sort(files[0]) != AssetSort::scene)) return {};
  return shape_lines(d, {on->id}, path_from_script(files[0], workspace_.session().file()), asset_name(files[0], d));
}

void Viewport::dragEnterEvent(QDragEnterEvent* e) {
  if (e->mimeData()->hasFormat(look_data) || !files_of(e->mimeData()).isEmpty()) e->acceptProposedAction();
}

// Shows what a look would do.
void Viewport::dragMoveEvent(QDragMoveEvent* e) {
  if (!e->mimeData()->hasFormat(look_data)) return e->acceptProposedAction();
  const std::vector<std::string> lines = lines_for_drop(*e);
  lines.empty() ? workspace_.look_back() : void(workspace_.look_ahead(lines));
  e->setAccepted(!lines.empty());
}

void Viewport::dragLeaveEvent(QDragLeaveEvent*) { workspace_.look_back(); }

void Viewport::dropEvent(QDropEvent* e) {
  const std::vector<std::string> lines = lines_for_drop(*e);
  workspace_.look_back();
  if (!lines.empty()) {
    if (!workspace_.say(lines)) tell_refusal();
    return e->acceptProposedAction();
  }
  // Each file finds a name that is free.
  for (const QString& file : files_of(e->mimeData()))
    if (!import_file(file, e->position()) || asset_sort(file) == AssetSort::film) break;
  e->acceptProposedAction();
}

}  // namespace betwixt::studio

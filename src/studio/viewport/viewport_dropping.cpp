// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Creates objects from files dropped on the picture.
#include <QDir>
#include <QDropEvent>
#include <QFileInfo>
#include <QImageReader>
#include <QMimeData>

#include "language/values.h"
#include "studio/assets/asset_files.h"
#include "studio/assets/look_lines.h"
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

}  // namespace

// Returns a place under the pointer: on an object; otherwise on the ground (in a flat film, on the paper); otherwise in
// front of the eye.
Vec3 Viewport::place_under(QPointF p) const {
  const Scope s = scope();
  const QPointF at = s.in_picture(p);
  if (const auto h = pick(frame(), s.projection, at.x(), at.y())) return h->place;
  const Vec3 up = frame().surroundings.flat ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Ray ray = s.ray(p);
  const double slope = dot(ray.along, up), t = slope == 0 ? -1 : -dot(ray.from, up) / slope;
  if (t > 0 && t < 1e4) return ray.from + t * ray.along;
  return s.place(p, std::max(1e-3, s.depth(pivot())));
}

std::string Viewport::line_for_file(const QString& file, QPointF p) const {
  const Document& d = workspace_.document();
  const std::string name = asset_name(file, d), path = write_text(path_from_script(file, workspace_.session().file()));
  const AssetSort sort = asset_sort(file);
  if (sort == AssetSort::sound)
    return "create " + name + " sound file=" + path + " at=" + workspace_.when(workspace_.time());
  const Scope s = scope();
  Vec3 place = place_under(p);
  const double pixel = s.metres(std::max(1e-3, s.depth(place)));
  const bool flat = frame().surroundings.flat;
  std::string line = "create " + name;
  if (sort == AssetSort::mesh) {
    line += " mesh file=" + path;
  } else if (sort == AssetSort::scene) {  // its own places and animation
    line += " scene file=" + path;
    if (workspace_.time() > d.range().first) line += " start=" + workspace_.when(workspace_.time());
  } else {
    // The image gets a third of the picture's height, and its own aspect ratio.
    const QSize size = QImageReader(file).size();
    const double high = rounded(s.box.height() * pixel / 3, 10 * pixel);
    const double wide = size.height() > 0 ? rounded(high * size.width() / size.height(), pixel) : high;
    line += " plane size=(" + write_number(wide) + " " + write_number(high) + ") texture=" + path;
    if (!flat) place.y += high / 2;
  }
  for (int i = 0; i < 3; ++i) place[i] = rounded(place[i], pixel);
  return line + (place == Vec3{} ? "" : " position=" + write_vector(place));
}

void Viewport::tell_refusal() {
  refusal_ = QString::fromStdString(workspace_.last_said()).section('\n', 0, 0);
  update();
}

bool Viewport::import_file(const QString& file, QPointF at) {
  if (asset_sort(file) == AssetSort::film) return workspace_.say("open " + as_one_word(file.toStdString()));
  const std::string line = line_for_file(file, at);
  if (!workspace_.say(line)) {
    tell_refusal();
    return false;
  }
  const std::size_t from = std::string("create ").size();
  if (const ObjectId made = workspace_.document().find(line.substr(from, line.find(' ', from) - from)))
    workspace_.select({made});
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

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
#include "studio/objects/object_lines.h"
#include "studio/viewport/viewport.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

enum class Sort { none, film, scene, mesh, picture, sound };

Sort sort_of(const QString& file) {
  const QString ending = QFileInfo(file).suffix().toLower();
  const auto in = [&](const char* endings) { return QString(endings).split(' ').contains(ending); };
  if (ending == "bx") return Sort::film;
  if (in("gltf glb dae fbx bvh svg")) return Sort::scene;
  if (in("ply obj stl 3ds")) return Sort::mesh;
  if (in("png jpg jpeg tga bmp")) return Sort::picture;
  if (in("wav flac ogg mp3 opus m4a")) return Sort::sound;
  return Sort::none;
}

// Returns an unused name for a file's content: "cow", "cow2".
std::string name_for(const QString& file, const Document& d) {
  std::string name;
  for (const QChar c : QFileInfo(file).completeBaseName().toLower())
    name += (c.unicode() < 128 && c.isLetterOrNumber()) || c == '_' ? static_cast<char>(c.toLatin1()) : '-';
  while (name.ends_with('-')) name.pop_back();
  if (name.empty() || !QChar(name[0]).isLetter()) name = "thing" + (name.empty() ? "" : "-" + name);
  return free_name(d, name);
}

// Returns a path relative to the script's folder, or the absolute path of a file outside it.
std::string path_from_script(const QString& file, const std::string& script) {
  const QDir folder = script.empty() ? QDir::current() : QFileInfo(QString::fromStdString(script)).absoluteDir();
  const QString path = folder.relativeFilePath(file);
  return (path.startsWith("..") ? file : path).toStdString();
}

QStringList files_of(const QMimeData* data) {
  QStringList out;
  for (const QUrl& url : data->urls())
    if (const QString file = url.toLocalFile(); sort_of(file) != Sort::none) out << file;
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
  const std::string name = name_for(file, d), path = write_text(path_from_script(file, workspace_.session().file()));
  const Sort sort = sort_of(file);
  if (sort == Sort::sound)
    return "create " + name + " sound file=" + path + " at=" + workspace_.when(workspace_.time());
  const Scope s = scope();
  Vec3 place = place_under(p);
  const double pixel = s.metres(std::max(1e-3, s.depth(place)));
  const bool flat = frame().surroundings.flat;
  std::string line = "create " + name;
  if (sort == Sort::mesh) {
    line += " mesh file=" + path;
  } else if (sort == Sort::scene) {  // its own places and animation
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

void Viewport::dragEnterEvent(QDragEnterEvent* e) {
  if (!files_of(e->mimeData()).isEmpty()) e->acceptProposedAction();
}

void Viewport::dropEvent(QDropEvent* e) {
  std::vector<std::string> lines;
  for (const QString& file : files_of(e->mimeData())) {
    if (sort_of(file) == Sort::film) {
      workspace_.say("open " + as_one_word(file.toStdString()));
      return e->acceptProposedAction();
    }
    // Carry the lines out one by one, so that each finds a name that is free.
    const std::string line = line_for_file(file, e->position());
    if (!workspace_.say(line)) {
      refusal_ = QString::fromStdString(workspace_.last_said()).section('\n', 0, 0);
      update();
      return;
    }
    const std::size_t from = std::string("create ").size();
    if (const ObjectId made = workspace_.document().find(line.substr(from, line.find(' ', from) - from)))
      workspace_.select({made});
  }
  e->acceptProposedAction();
}

}  // namespace betwixt::studio

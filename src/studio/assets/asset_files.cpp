// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/assets/asset_files.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFileInfo>
#include <QPainter>
#include <algorithm>

#include "betwixt/language.h"
#include "betwixt/picture.h"
#include "betwixt/sound.h"
#include "scene/document.h"
#include "studio/assets/small_pictures.h"
#include "studio/objects/object_lines.h"
#include "syntax/texts.h"

namespace betwixt::studio {
namespace {

constexpr int most_files = 500;    // that are listed
constexpr int most_seen = 50'000;  // that are looked at
constexpr int milliseconds = 5;    // of one look

QImage film_of(const QString& file, const std::string& line, QSize size) {
  const QFileInfo info(file);
  const std::string text = "background transparent\n" + line + write_text(info.fileName().toStdString()) + "\n";
  const Loaded loaded = load_text(text, info.dir().filePath("assets.bx").toStdString());
  return has_errors(loaded.diagnostics) ? QImage() : film_picture(loaded.document, 1, size);
}

QImage scaled_picture(const QString& file, QSize size) {
  const auto picture = read_picture(file.toStdString());
  if (!picture) return {};
  const Picture& p = **picture;
  const QImage whole(p.rgba.data(), p.width, p.height, 4 * p.width, QImage::Format_RGBA8888);
  return whole.scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation).copy();
}

QImage loudness_picture(const QString& file, QSize size) {
  const QFileInfo info(file);
  const Loaded loaded = load_text("create s sound file=" + write_text(info.fileName().toStdString()) + "\n",
                                  info.dir().filePath("assets.bx").toStdString());
  const auto& sounds = *loaded.document.scene().sounds;
  if (sounds.empty() || !sounds.begin()->second) return {};
  const Sound& sound = *sounds.begin()->second;
  std::vector<double> heights;
  for (int x = 0; x < size.width(); ++x) heights.push_back(sound.loudness(sound.seconds * (x + 0.5) / size.width()));
  const double most = std::max(1e-6, *std::ranges::max_element(heights));
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter p(&image);
  p.setPen(QColor(0x62, 0xc4, 0x8a));
  const double middle = size.height() / 2.0;
  for (int x = 0; x < size.width(); ++x) {
    const double half = std::max(0.5, 0.9 * middle * heights[static_cast<std::size_t>(x)] / most);
    p.drawLine(QPointF(x + 0.5, middle - half), QPointF(x + 0.5, middle + half));
  }
  return image;
}

}  // namespace

AssetSort asset_sort(const QString& file) {
  const QString ending = QFileInfo(file).suffix().toLower();
  const auto in = [&](const char* endings) { return QString(endings).split(' ').contains(ending); };
  if (ending == "bx") return QFileInfo(file).dir().dirName() == "poses" ? AssetSort::pose : AssetSort::film;
  if (in("gltf glb dae fbx bvh svg")) return AssetSort::scene;
  if (in("ply obj stl 3ds")) return AssetSort::mesh;
  if (in("png jpg jpeg tga bmp")) return AssetSort::picture;
  if (in("wav flac ogg mp3 opus m4a")) return AssetSort::sound;
  if (in("mp4 m4v mov webm mkv avi ogv")) return AssetSort::video;
  return AssetSort::none;
}

std::string asset_name(const QString& file, const Document& d) {
  std::string name;
  for (const QChar c : QFileInfo(file).completeBaseName().toLower())
    name += (c.unicode() < 128 && c.isLetterOrNumber()) || c == '_' ? static_cast<char>(c.toLatin1()) : '-';
  while (name.ends_with('-')) name.pop_back();
  if (name.empty() || !QChar(name[0]).isLetter()) name = "thing" + (name.empty() ? "" : "-" + name);
  return free_name(d, name);
}

std::string path_from_script(const QString& file, const std::string& script) {
  const QDir folder = script.empty() ? QDir::current() : QFileInfo(QString::fromStdString(script)).absoluteDir();
  const QString path = folder.relativeFilePath(file);
  return (path.startsWith("..") ? file : path).toStdString();
}

QImage asset_picture(const QString& file, QSize size) {
  switch (asset_sort(file)) {
    case AssetSort::mesh:
      return film_of(file, "create a mesh file=", size);
    case AssetSort::scene:
      return film_of(file, "create a scene file=", size);
    case AssetSort::picture:
      return scaled_picture(file, size);
    case AssetSort::video:
      return film_of(file, "flat\ncreate a video file=", size);
    case AssetSort::sound:
      return loudness_picture(file, size);
    default:
      return {};
  }
}

FolderScan::FolderScan(QObject* parent) : QObject(parent) {
  connect(&timer_, &QTimer::timeout, this, &FolderScan::go_on);
}

void FolderScan::begin(const QString& folder) {
  at_ = std::make_unique<QDirIterator>(folder, QDir::Files | QDir::Readable, QDirIterator::Subdirectories);
  found_.clear(), seen_ = 0, full_ = false;
  timer_.start(0);
}

void FolderScan::go_on() {
  QElapsedTimer clock;
  clock.start();
  while (at_->hasNext() && !full_ && clock.elapsed() < milliseconds) {
    const QString file = at_->next();
    if (asset_sort(file) != AssetSort::none) found_ << file;
    full_ = ++seen_ >= most_seen || found_.size() >= most_files;
  }
  if (at_->hasNext() && !full_) return;
  timer_.stop();
  at_.reset();
  found_.sort();
  emit over(found_);
}

}  // namespace betwixt::studio

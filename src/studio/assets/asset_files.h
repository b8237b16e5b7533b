// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Files from which objects are made: which there are, what they become, and how they look.
#pragma once

#include <QDirIterator>
#include <QImage>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <memory>
#include <string>

#include "betwixt/document.h"

namespace betwixt::studio {

enum class AssetSort : std::uint8_t { none, film, pose, scene, mesh, picture, sound, video };
AssetSort asset_sort(const QString& file);  // by the ending of its name; poses are scripts in a folder `poses`

// Returns an unused name for the object that a file becomes: "cow", "cow2".
std::string asset_name(const QString& file, const Document&);
// Returns a path relative to the script's folder, or the absolute path of a file outside it.
std::string path_from_script(const QString& file, const std::string& script);

// Draws a file: a picture, a mesh or a scene as it is, a sound as its loudness. May take long; a process of its own
// reads what other programs wrote. Returns a null image if there is nothing to draw.
QImage asset_picture(const QString& file, QSize);

// Lists the assets below a folder, a few at a time, so that the window never waits.
class FolderScan : public QObject {
  Q_OBJECT
 public:
  explicit FolderScan(QObject* parent = nullptr);
  void begin(const QString& folder);
  bool is_full() const { return full_; }  // there are more files than it lists

 Q_SIGNALS:
  void over(const QStringList& files);  // sorted

 private:
  void go_on();

  QTimer timer_;
  std::unique_ptr<QDirIterator> at_;
  QStringList found_;
  int seen_ = 0;
  bool full_ = false;
};

}  // namespace betwixt::studio

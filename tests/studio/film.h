// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Helpers for tests of panels: a film in a temporary folder, and short functions that read it.
#pragma once

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "betwixt/language.h"
#include "studio/shell/workspace.h"

namespace betwixt::studio {

struct Film {
  QTemporaryDir folder;
  Workspace workspace;

  explicit Film(const QByteArray& text) {
    QDir::setCurrent(folder.path());
    QFile f(folder.filePath("film.bx"));
    if (f.open(QIODevice::WriteOnly)) f.write(text);
    f.close();
    workspace.open(f.fileName());
  }
  ~Film() { QDir::setCurrent(QDir::tempPath()); }

  QString text() const { return QString::fromStdString(workspace.text()); }
  ObjectId id(const char* name) const { return workspace.document().find(name); }
  void select(const char* name) { workspace.select({id(name)}); }
  std::string selected() const {
    std::string all;
    for (const ObjectId i : workspace.selected()) all += (all.empty() ? "" : " ") + workspace.name(i);
    return all;
  }
  Target target(const std::string& words) const { return find_targets(words, workspace.document())->front(); }
  Value value(const std::string& of) const { return workspace.program().read(target(of), workspace.time()); }
  double radius(const std::string& of) const { return std::get<double>(value(of + ".radius")); }
  std::size_t events_of(const std::string& words) const { return events(workspace.document(), target(words)).size(); }
  Time at_time(const char* words) const { return *parse_time(words, workspace.document()); }
};

}  // namespace betwixt::studio

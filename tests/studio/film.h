// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What the tests of panels need: a film that lies in a folder of its own, and short words for what is in it.
#pragma once

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include "betwixt/language.h"
#include "studio/desk.h"

namespace betwixt::studio {

struct Film {
  QTemporaryDir folder;
  Desk desk;

  explicit Film(const QByteArray& text) {
    QDir::setCurrent(folder.path());
    QFile f(folder.filePath("film.bx"));
    if (f.open(QIODevice::WriteOnly)) f.write(text);
    f.close();
    desk.open(f.fileName());
  }
  ~Film() { QDir::setCurrent(QDir::tempPath()); }

  QString text() const { return QString::fromStdString(desk.text()); }
  ObjectId id(const char* name) const { return desk.document().find(name); }
  void select(const char* name) { desk.select({id(name)}); }
  std::string selected() const {
    std::string all;
    for (const ObjectId i : desk.selected()) all += (all.empty() ? "" : " ") + desk.name(i);
    return all;
  }
  Target target(const std::string& words) const { return find_targets(words, desk.document())->front(); }
  Value value(const std::string& of) const { return desk.program().read(target(of), desk.time()); }
  double radius(const std::string& of) const { return std::get<double>(value(of + ".radius")); }
  std::size_t events_of(const std::string& words) const { return events(desk.document(), target(words)).size(); }
  Time at_time(const char* words) const { return *parse_time(words, desk.document()); }
};

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The studio's window: the picture in the middle, panels around it that can be moved, closed and laid over each other.
#pragma once

#include <QCloseEvent>
#include <QMainWindow>
#include <vector>

#include "studio/desk.h"

class QDockWidget;

namespace betwixt::studio {

class Viewport;

class Window : public QMainWindow {
  Q_OBJECT
 public:
  // `bare`: the picture and the ruler alone, to play.
  explicit Window(Desk&, bool bare = false);
  ~Window() override;

  Desk& desk() { return desk_; }
  const Desk& desk() const { return desk_; }
  Viewport& viewport() { return *viewport_; }
  // How panels lie: "all", "animate", "script", "picture". False: there is no such layout.
  bool set_layout(const QString& name);
  static QStringList layouts();

  void open_asking();
  bool save();  // asks for a name where there is none

 protected:
  void closeEvent(QCloseEvent*) override;

 private:
  void add_panels();
  void add_menus();
  void name_film();

  Desk& desk_;
  Viewport* viewport_;
  std::vector<QDockWidget*> docks_;
};

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The twerpers (easings) as small pictures, to choose one for the selected events. The picture of the film shows what
// the one under the pointer would do.
#pragma once

#include <QFrame>
#include <QIcon>
#include <string>
#include <vector>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

// Returns the values of a twerper from an event with 0 to one with 1, evenly spaced in time; empty if it has no curve.
std::vector<double> twerper_shape(const Document&, const std::string& name);
QIcon twerper_picture(const Document&, const std::string& name);

class TwerperGrid : public QFrame {
  Q_OBJECT
 public:
  // Shows the grid at a place of the screen. It deletes itself when it is closed.
  static void pop_up(Workspace&, QWidget* parent, const QPoint& at);

 protected:
  bool eventFilter(QObject*, QEvent*) override;
  void closeEvent(QCloseEvent*) override;

 private:
  TwerperGrid(Workspace&, QWidget* parent);
  void add(const std::string& name, const QString& sentence);

  Workspace& workspace_;
  int count_ = 0;
};

}  // namespace betwixt::studio

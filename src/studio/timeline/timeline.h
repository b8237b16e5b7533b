// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The timeline panel: the ruler, and buttons for playback.
#pragma once

#include <QWidget>

#include "studio/shell/workspace.h"

class QLabel;
class QLineEdit;
class QToolButton;

namespace betwixt::studio {

class TimeAxis;

class Timeline : public QWidget {
  Q_OBJECT
 public:
  explicit Timeline(Workspace&, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent*) override;

 private:
  QToolButton* button(const QString& name, const QString& tip, void (*does)(Workspace&));
  void draw_buttons();
  void show_time();
  void show_playing();
  void go_where_said();

  Workspace& workspace_;
  TimeAxis& axis_;
  std::vector<QToolButton*> buttons_;
  QLineEdit* at_ = nullptr;
  QLabel *of_ = nullptr, *rate_ = nullptr;
  QToolButton* seconds_ = nullptr;
};

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The poses kept beside the film. A double click gives one to the selection.
#pragma once

#include <QWidget>

#include "studio/poses/pose_actions.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace betwixt::studio {

class PosePanel : public QWidget {
  Q_OBJECT
 public:
  explicit PosePanel(Workspace&, QWidget* parent = nullptr);

 protected:
  void showEvent(QShowEvent*) override;

 private:
  void refresh();
  QString chosen() const;
  void use(bool in_mirror);
  void use_in_part();
  void keep();
  void ask_to_forget();
  void show_menu(QPoint);

  Workspace& workspace_;
  PoseActions& poses_;
  QLineEdit* name_;
  QListWidget* list_;
  QLabel* words_;
  QWidget* hint_;  // while there are no poses
};

}  // namespace betwixt::studio

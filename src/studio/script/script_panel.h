// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The script panel: the editor, its margin and the diagnostics.
#pragma once

#include <QLineEdit>
#include <QListWidget>
#include <QWidget>

#include "studio/script/script_edit.h"

namespace betwixt::studio {

class ScriptPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ScriptPanel(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override;

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void list_diagnostics();
  void find(bool backwards);

  Workspace& workspace_;
  ScriptEdit* edit_;
  QWidget* margin_;
  QListWidget* strip_;
  QLineEdit* sought_;
};

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The history of the film as a list. A click on a step goes back, or forward again, to the film after that step.
#pragma once

#include <QListWidget>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class HistoryPanel : public QListWidget {
  Q_OBJECT
 public:
  explicit HistoryPanel(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {22 * fontMetrics().horizontalAdvance('m'), 300}; }

 protected:
  void showEvent(QShowEvent*) override;

 private:
  void refresh();
  void go_to(int row);

  Workspace& workspace_;
  int standing_ = 0;  // the row of the film as it is
  bool going_ = false;
};

}  // namespace betwixt::studio

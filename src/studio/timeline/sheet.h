// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sheet panel: the dope sheet and the exposure sheet, with buttons above them.
#pragma once

#include <QWidget>

#include "studio/shell/workspace.h"

class QStackedLayout;

namespace betwixt::studio {

class Sheet : public QWidget {
  Q_OBJECT
 public:
  explicit Sheet(Workspace&, QWidget* parent = nullptr);

 private:
  void focusInEvent(QFocusEvent*) override;

  QStackedLayout* either_;  // the dope sheet or the exposure sheet
};

}  // namespace betwixt::studio

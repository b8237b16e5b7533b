// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The sheet panel: the dope sheet and the exposure sheet, with buttons above them.
#pragma once

#include <QWidget>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class Sheet : public QWidget {
  Q_OBJECT
 public:
  explicit Sheet(Workspace&, QWidget* parent = nullptr);
};

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The curve panel: the curves of the selected objects, and buttons above them.
#pragma once

#include <QWidget>

#include "studio/shell/workspace.h"

namespace betwixt::studio {

class Curves : public QWidget {
  Q_OBJECT
 public:
  explicit Curves(Workspace&, QWidget* parent = nullptr);
};

}  // namespace betwixt::studio

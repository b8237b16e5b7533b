// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/outliner.h"

namespace betwixt::studio {

Outliner::Outliner(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  setObjectName("outliner");
  setWindowTitle(tr("Objects"));
}

}  // namespace betwixt::studio

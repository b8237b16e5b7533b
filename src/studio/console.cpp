// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/console.h"

namespace betwixt::studio {

Console::Console(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  setObjectName("console");
  setWindowTitle(tr("Console"));
}

}  // namespace betwixt::studio

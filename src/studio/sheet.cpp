// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/sheet.h"

namespace betwixt::studio {

Sheet::Sheet(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  setObjectName("sheet");
  setWindowTitle(tr("Sheet"));
}

}  // namespace betwixt::studio

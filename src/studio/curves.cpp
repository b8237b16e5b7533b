// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves.h"

namespace betwixt::studio {

Curves::Curves(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  setObjectName("curves");
  setWindowTitle(tr("Curves"));
}

}  // namespace betwixt::studio

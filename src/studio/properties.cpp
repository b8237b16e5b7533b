// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/properties.h"

namespace betwixt::studio {

Properties::Properties(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  setObjectName("properties");
  setWindowTitle(tr("Properties"));
}

}  // namespace betwixt::studio

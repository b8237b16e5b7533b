// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline.h"

namespace betwixt::studio {

Timeline::Timeline(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  setObjectName("timeline");
  setWindowTitle(tr("Time"));
}

}  // namespace betwixt::studio

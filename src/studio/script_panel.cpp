// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/script_panel.h"

namespace betwixt::studio {

ScriptPanel::ScriptPanel(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk) {
  setObjectName("script_panel");
  setWindowTitle(tr("Script"));
}

}  // namespace betwixt::studio

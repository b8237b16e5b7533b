// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/curves.h"

#include <QVBoxLayout>

#include "studio/curve_pane.h"

namespace betwixt::studio {

Curves::Curves(Desk& desk, QWidget* parent) : QWidget(parent) {
  setObjectName("curves");
  setWindowTitle(tr("Curves"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  auto* pane = new CurvePane(desk, this);
  all->addWidget(pane);
  setFocusProxy(pane);
}

}  // namespace betwixt::studio

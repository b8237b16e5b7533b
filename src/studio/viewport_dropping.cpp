// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <QDropEvent>

#include "studio/viewport.h"

namespace betwixt::studio {

void Viewport::dragEnterEvent(QDragEnterEvent* e) { e->ignore(); }
void Viewport::dropEvent(QDropEvent* e) { e->ignore(); }

}  // namespace betwixt::studio

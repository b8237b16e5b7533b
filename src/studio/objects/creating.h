// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Menus of the kinds, which create objects.
#pragma once

#include "studio/shell/workspace.h"

class QMenu;

namespace betwixt::studio {

// Gives a menu a row for each kind, also for those of the film when it shows. `over`: the widget that asks for files.
void fill_kinds(QMenu&, Workspace&, QWidget* over);

}  // namespace betwixt::studio

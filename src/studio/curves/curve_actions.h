// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Actions on the curves of the selected events: handle types, twerpers as pictures, simplifying, separate axes.
#pragma once

#include "studio/shell/workspace.h"

class QMenu;
class QWidget;

namespace betwixt::studio {

void ask_key_type(Workspace&, QWidget* parent);  // a menu at the pointer
void ask_twerper(Workspace&, QWidget* parent);   // a grid of pictures at the pointer
// Asks for a tolerance, and removes the selected events (or all of the selected objects) that it makes unnecessary.
void ask_simplify(Workspace&, QWidget* parent);
// Separates the tracks of the selected events (or all of the selected objects) into components.
void separate_axes(Workspace&);

void fill_curve_actions(QMenu&, Workspace&, QWidget* parent);

}  // namespace betwixt::studio

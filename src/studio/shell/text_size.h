// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The size of all text, and of what is measured by it.
#pragma once

#include <QFont>
#include <QSize>
#include <functional>

class QWidget;

namespace betwixt::studio {

// Gives all text a size; 1 is the size at the first start.
void size_all_text(double);
// Returns how large the text of the program is now: 1 at the first start.
double size_of_all_text();

// The font of scripts, in the size of all text.
QFont script_font();

// Measures something by the text of a widget: now, and whenever this text gets another size.
void measure_by_text(QWidget&, std::function<void()> measure);

// Gives a window a size, but not one that is larger than the screen.
void resize_on_screen(QWidget& window, QSize);

}  // namespace betwixt::studio

// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// How the studio looks: light or dark, and the colours of what panels draw themselves.
#pragma once

#include <QApplication>
#include <QColor>

#include "betwixt/value.h"

namespace betwixt::studio {

enum class Theme { dark, light };
void set_theme(QApplication&, Theme);

// The colours of what panels draw, in the theme that is set.
struct Colors {
  QColor back, raised, line, text, dim, accent, playhead, event, selected, error, warning, note, cut;
  QColor x, y, z;  // of axes and components, red green blue of colours too
};
const Colors& colors();
QColor faint(QColor, float alpha);
QColor swatch(const Color&);  // of the language
// The same in any theme: of what lies over pictures.
const Colors& picture_colors();

}  // namespace betwixt::studio
